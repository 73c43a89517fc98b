// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/contact_shapes.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "autodiff_sim/term/tilted_down.h"

namespace clothfit {
namespace {

const Eigen::Vector3d kGravity(0.0, 0.0, -9.81);

// A cloth that hovers a hand's breadth away, lies on something, and lies on it elsewhere; every
// force is known alike.
class ContactShapes : public testing::Test {
 protected:
  ContactShapes() {
    missing_.layout = MakeForceLayout(mesh_, {7, 7}, 10.0, 3, 0.1);
    missing_.last_frame = 3;
    const int size = missing_.layout.size();
    missing_.system.information = Eigen::MatrixXd::Identity(size, size);
    missing_.system.data = Eigen::VectorXd::Zero(size);
  }

  // place: where a point of the cloth lies when it is moved by `shift` along the surface; push: the
  // surface's normal there, or nothing where the cloth hangs free.
  using OfPoint = std::function<Eigen::Vector3d(const Eigen::Vector2d& uv, double shift)>;
  void Move(const OfPoint& place, const OfPoint& push) {
    for (int frame = 0; frame <= missing_.last_frame; ++frame) {
      const double shift = frame < 3 ? 0.0 : 0.06;
      const Eigen::Vector3d away(0.0, 0.0, frame == 0 ? 0.1 : 0.0);
      Eigen::VectorXd x(3 * mesh_.num_particles());
      for (int i = 0; i < mesh_.num_particles(); ++i)
        x.segment<3>(3 * i) = place(mesh_.uv[static_cast<std::size_t>(i)], shift) + away;
      missing_.x.push_back(x);
      if (frame > 0) AddForces(frame, shift, x, push);
    }
  }

  // Of 5 N/m^2, in the frame of the triangle next to each node.
  void AddForces(int frame, double shift, const Eigen::VectorXd& x, const OfPoint& push) {
    const ForceLayout& layout = missing_.layout;
    for (int node = 0; node < layout.num_nodes(); ++node) {
      const Eigen::Vector2d uv = layout.NodePlace(node);
      const std::array<int, 3>* nearest = nullptr;
      double least = 1e9;
      for (const std::array<int, 3>& t : mesh_.triangles) {
        const double d = ((mesh_.uv[t[0]] + mesh_.uv[t[1]] + mesh_.uv[t[2]]) / 3.0 - uv).norm();
        if (d < least) nearest = &t;
        least = std::min(least, d);
      }
      missing_.system.data.col(0).segment<3>(layout.Index(frame, node, 0)) =
          TriangleFrame(mesh_, *nearest, x).transpose() * (5.0 * push(uv, shift));
    }
  }

  ContactShape Best(const std::string& term) const {
    for (const ContactShape& shape : FindContactShapes(mesh_, kGravity, missing_))
      if (shape.term == term) return shape;
    ADD_FAILURE() << "no " << term;
    return {};
  }

  ClothMesh mesh_ = MakeGrid({0.4, 0.4}, {11, 11});
  MissingForce missing_;
};

TEST_F(ContactShapes, FindAPlane) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.1, 0.2, 0.9).normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Move(
      [&](const Eigen::Vector2d& uv, double shift) {
        return Eigen::Vector3d(0.7 * normal + (uv.x() + shift) * u + uv.y() * v);
      },
      [&](const Eigen::Vector2d&, double) { return normal; });
  const Probe probe = Best("obstacle_plane").probe;
  const Eigen::Vector3d down =
      TiltedDown<double>(MakeDownFrame(kGravity), probe.at("obstacle_plane.angle_1"),
                         probe.at("obstacle_plane.angle_2"));
  EXPECT_LT((down + normal).norm(), 0.1);
  EXPECT_NEAR(probe.at("obstacle_plane.height"), 0.7, 0.03);
}

// Wrapped around as far as a radian to either side, from where it hangs down straight.
TEST_F(ContactShapes, FindABar) {
  constexpr double kRadius = 0.05, kWrapped = 1.0;
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 0.5, 0.0).normalized();
  const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(axis), origin(0.1, 0.4, 1.2);
  const auto normal_at = [&](double angle) {
    return Eigen::Vector3d(std::sin(angle) * side + std::cos(angle) * Eigen::Vector3d::UnitZ());
  };
  Move(
      [&](const Eigen::Vector2d& uv, double shift) {
        const double angle = (uv.y() - 0.2 + shift) / kRadius;
        const double on_bar = std::max(-kWrapped, std::min(kWrapped, angle));
        const Eigen::Vector3d normal = normal_at(on_bar), along = axis.cross(normal);
        const double beyond = (angle - on_bar) * kRadius;
        return Eigen::Vector3d(origin + uv.x() * axis + kRadius * normal -
                               beyond * along * (along.dot(side) > 0.0 ? -1.0 : 1.0));
      },
      [&](const Eigen::Vector2d& uv, double shift) {
        const double angle = (uv.y() - 0.2 + shift) / kRadius;
        if (std::abs(angle) > kWrapped) return Eigen::Vector3d(Eigen::Vector3d::Zero());
        return normal_at(angle);
      });
  const Probe probe = Best("obstacle_capsule").probe;
  const auto end = [&](const std::string& number) {
    const std::string name = "obstacle_capsule.";
    return Eigen::Vector3d(probe.at(name + "x" + number), probe.at(name + "y" + number),
                           probe.at(name + "z" + number));
  };
  const Eigen::Vector3d found = (end("2") - end("1")).normalized();
  EXPECT_GT(std::abs(found.dot(axis)), std::cos(0.2));
  const Eigen::Vector3d middle = origin + 0.2 * axis;
  EXPECT_LT((end("1") - middle).cross(found).norm(), 0.04);  // what counts as touching it
  EXPECT_GT((end("2") - end("1")).norm(), 0.4);              // beyond the cloth
}

TEST_F(ContactShapes, FindABall) {
  constexpr double kRadius = 0.15;
  const Eigen::Vector3d middle(0.2, -0.1, 0.5);
  const auto normal_at = [&](const Eigen::Vector2d& uv, double shift) {
    const Eigen::Vector2d from(uv.x() - 0.2 + shift, uv.y() - 0.2);
    const double angle = std::min(1.2, from.norm() / kRadius);
    const Eigen::Vector2d flat = from.norm() > 0.0 ? Eigen::Vector2d(from.normalized()) : from;
    return Eigen::Vector3d(std::sin(angle) * flat.x(), std::sin(angle) * flat.y(), std::cos(angle));
  };
  Move(
      [&](const Eigen::Vector2d& uv, double shift) {
        const double beyond = std::max(
            0.0, Eigen::Vector2d(uv.x() - 0.2 + shift, uv.y() - 0.2).norm() - 1.2 * kRadius);
        return Eigen::Vector3d(middle + kRadius * normal_at(uv, shift) -
                               beyond * Eigen::Vector3d::UnitZ());
      },
      [&](const Eigen::Vector2d& uv, double shift) {
        const bool is_on =
            Eigen::Vector2d(uv.x() - 0.2 + shift, uv.y() - 0.2).norm() < 1.2 * kRadius;
        return is_on ? normal_at(uv, shift) : Eigen::Vector3d(Eigen::Vector3d::Zero());
      });
  const Probe probe = Best("obstacle_sphere").probe;
  EXPECT_NEAR(probe.at("obstacle_sphere.x"), middle.x(), 0.03);
  EXPECT_NEAR(probe.at("obstacle_sphere.y"), middle.y(), 0.03);
  EXPECT_NEAR(probe.at("obstacle_sphere.z") + probe.at("obstacle_sphere.radius"), 0.65, 0.03);
}

// A draught pushes everywhere, and the cloth would always be inside of what did that.
TEST_F(ContactShapes, HoldNoCloth) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  Move(
      [&](const Eigen::Vector2d& uv, double shift) {
        return Eigen::Vector3d(uv.x() + 5.0 * shift, uv.y(), 1.0 + 3.0 * shift);
      },
      [&](const Eigen::Vector2d&, double) { return up; });
  for (const ContactShape& shape : FindContactShapes(mesh_, kGravity, missing_)) {
    if (shape.term != "obstacle_plane") continue;
    const Eigen::Vector3d normal =
        -TiltedDown<double>(MakeDownFrame(kGravity), shape.probe.at("obstacle_plane.angle_1"),
                            shape.probe.at("obstacle_plane.angle_2"));
    int inside = 0, all = 0;
    for (const Eigen::VectorXd& x : missing_.x) {
      for (Eigen::Index i = 0; i < x.size(); i += 3, ++all)
        inside += shape.probe.at("obstacle_plane.height") - normal.dot(x.segment<3>(i)) > 0.03;
    }
    EXPECT_LT(inside, all / 2);
  }
}

// Gravity that leans, so that level is not along the world's axes.
TEST(BarsThroughBall, LieLevelInAllDirectionsAsThickAsTheBall) {
  const Eigen::Vector3d gravity = 9.81 * Eigen::Vector3d(0.3, -0.4, -1.0).normalized();
  const Eigen::Vector3d middle(0.2, -0.1, 0.5);
  const Probe ball = {{"obstacle_sphere.x", middle.x()},
                      {"obstacle_sphere.y", middle.y()},
                      {"obstacle_sphere.z", middle.z()},
                      {"obstacle_sphere.radius", 0.03}};
  const std::vector<Probe> bars = BarsThroughBall(ball, gravity, 0.7);
  ASSERT_EQ(bars.size(), 4U);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (const Probe& bar : bars) {
    const auto end = [&](const std::string& number) {
      const std::string name = "obstacle_capsule.";
      return Eigen::Vector3d(bar.at(name + "x" + number), bar.at(name + "y" + number),
                             bar.at(name + "z" + number));
    };
    EXPECT_EQ(bar.at("obstacle_capsule.radius"), 0.03);
    EXPECT_LT((0.5 * (end("1") + end("2")) - middle).norm(), 1e-12);
    EXPECT_NEAR((end("2") - end("1")).norm(), 1.4, 1e-12);
    const Eigen::Vector3d axis = (end("2") - end("1")).normalized();
    EXPECT_NEAR(axis.dot(gravity), 0.0, 1e-12);
    axes += axis * axis.transpose();
  }
  // Spread evenly over all level directions.
  const Eigen::Vector3d down = gravity.normalized();
  const Eigen::Matrix3d level = Eigen::Matrix3d::Identity() - down * down.transpose();
  EXPECT_LT((axes - 2.0 * level).norm(), 1e-12);
}

TEST_F(ContactShapes, AreNoneWhereNothingPushes) {
  Move([&](const Eigen::Vector2d& uv, double) { return Eigen::Vector3d(uv.x(), uv.y(), 1.0); },
       [&](const Eigen::Vector2d&, double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); });
  EXPECT_TRUE(FindContactShapes(mesh_, kGravity, missing_).empty());
}

}  // namespace
}  // namespace clothfit
