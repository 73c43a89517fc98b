// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/contact_shapes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "autodiff_sim/term/tilted_down.h"

namespace clothfit {
namespace {

// Pushes from a surface, in directions that spread and strengths that differ.
class ContactShapes : public testing::Test {
 protected:
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  void Add(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
    pushes_.push_back({at, Uniform(1.0, 3.0) * normal});
  }

  std::mt19937_64 random_{4};
  std::vector<Push> pushes_;
};

TEST_F(ContactShapes, FindAPlane) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.1, 0.2, 0.9).normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  for (int k = 0; k < 50; ++k)
    Add(0.7 * normal + Uniform(-0.3, 0.3) * u + Uniform(-0.3, 0.3) * v, normal);
  const PlaneFit plane = FitPlane(pushes_);
  EXPECT_LT((plane.normal - normal).norm(), 1e-12);
  EXPECT_NEAR(plane.height, 0.7, 1e-12);
  EXPECT_FALSE(FitSphere(pushes_));  // which of them it would be is open
  EXPECT_FALSE(FitCapsule(pushes_));
  // As the term has it.
  const Eigen::Vector3d gravity(0.0, 0.0, -9.81);
  const std::vector<ContactStart> starts = ContactStarts(pushes_, gravity);
  ASSERT_EQ(starts.size(), 1u);
  EXPECT_EQ(starts[0].term, "obstacle_plane");
  const Probe& probe = starts[0].probe;
  const Eigen::Vector3d down =
      TiltedDown<double>(MakeDownFrame(gravity), probe.at("obstacle_plane.angle_1"),
                         probe.at("obstacle_plane.angle_2"));
  EXPECT_LT((down + normal).norm(), 1e-12);
}

TEST_F(ContactShapes, FindABall) {
  const Eigen::Vector3d middle(0.2, -0.1, 0.5);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector3d normal =
        Eigen::Vector3d(Uniform(-1, 1), Uniform(-1, 1), 1.0).normalized();
    Add(middle + 0.15 * normal, normal);
  }
  const std::optional<SphereFit> ball = FitSphere(pushes_);
  ASSERT_TRUE(ball);
  EXPECT_LT((ball->middle - middle).norm(), 1e-9);
  EXPECT_NEAR(ball->radius, 0.15, 1e-9);
}

TEST_F(ContactShapes, FindABar) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 0.3, 0.1).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const Eigen::Vector3d origin(0.1, 0.4, 1.2);
  for (int k = 0; k < 80; ++k) {
    const double angle = Uniform(-1.0, 1.0);
    const Eigen::Vector3d normal = std::cos(angle) * u + std::sin(angle) * v;
    Add(origin + Uniform(-0.4, 0.4) * axis + 0.03 * normal, normal);
  }
  const std::optional<CapsuleFit> bar = FitCapsule(pushes_);
  ASSERT_TRUE(bar);
  EXPECT_NEAR(bar->radius, 0.03, 1e-9);
  const Eigen::Vector3d found = (bar->end_2 - bar->end_1).normalized();
  EXPECT_NEAR(std::abs(found.dot(axis)), 1.0, 1e-12);
  for (const Eigen::Vector3d& end : {bar->end_1, bar->end_2}) {
    EXPECT_LT((end - origin).cross(axis).norm(), 1e-9);
    EXPECT_GT(std::abs((end - origin).dot(axis)), 0.5);  // beyond the cloth
  }
}

}  // namespace
}  // namespace clothfit
