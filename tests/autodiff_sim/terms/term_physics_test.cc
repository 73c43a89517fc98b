// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The force terms against their formulas written another way: energies, angles, distances.
#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/base/gradient_check.h"
#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/terms/force_of_energy.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

TEST(SpringPhysics, ForceIsThatOfTheEnergy) {
  const Eigen::VectorXd parameters = Numbers({150.0, 0.0});
  const auto energy = [](const Spring& spring, const auto& numbers) {
    const double length = (Node<1>(numbers) - Node<0>(numbers)).norm();
    // Shrunk along warp and weft as an ellipse is: the length of the shrunk rest vector.
    const double warp = std::sqrt(spring.warp_share) * (1.0 - kSampleShrinkage[0]);
    const double weft = std::sqrt(1.0 - spring.warp_share) * (1.0 - kSampleShrinkage[1]);
    const double extension = length - spring.rest_length * std::hypot(warp, weft);
    return 0.5 * 150.0 * spring.weight * extension * extension;
  };
  ExpectForceOfEnergy<StretchSpring>(parameters, energy);
}

TEST(GravityPhysics, ForceIsThatOfTheEnergy) {
  ExpectForceOfEnergy<Gravity>(Eigen::VectorXd::Constant(1, 1.0), [](const auto& e, const auto& n) {
    return 0.15 * e.area * 9.81 * Node<0>(n).z();
  });
}

TEST(GroundPhysics, PushIsThatOfTheEnergy) {
  Eigen::VectorXd parameters(5);
  parameters << 1e5, 0.0, 0.0, 0.002, 0.005;
  ExpectForceOfEnergy<GroundContact>(parameters, [](const auto& e, const auto& n) {
    const double depth = std::max(0.0, 0.002 - Node<0>(n).z());
    return e.area * 1e5 * depth * depth * depth / (3.0 * 0.002);
  });
}

// Half the quadratic energy, and the reciprocal pull's -k / sqrt(d^2 + r^2).
double AttractionEnergy(double squared_distance) {
  return 0.5 * 3.0 * squared_distance - 2e-3 / std::sqrt(squared_distance + 0.01 * 0.01);
}

TEST(AttractionPhysics, PointsPullWithTheEnergyOfTheDistance) {
  const Eigen::VectorXd parameters = Numbers({3.0, 2e-3, 0.01});
  ExpectForceOfEnergy<PointAttraction>(parameters, [](const auto& e, const auto& n) {
    const Eigen::Vector3d place =
        e.weights[0] * Node<0>(n) + e.weights[1] * Node<1>(n) + e.weights[2] * Node<2>(n);
    return AttractionEnergy((place - Eigen::Vector3d(e.input.data())).squaredNorm());
  });
}

// The distance of a point from a ray, from two points of the ray instead of Pluecker coordinates.
TEST(AttractionPhysics, RaysPullWithTheEnergyOfTheDistance) {
  const Eigen::VectorXd parameters = Numbers({3.0, 2e-3, 0.01});
  ExpectForceOfEnergy<RayAttraction>(parameters, [](const auto& e, const auto& n) {
    const Eigen::Vector3d place =
        e.weights[0] * Node<0>(n) + e.weights[1] * Node<1>(n) + e.weights[2] * Node<2>(n);
    const Eigen::Vector3d direction(e.input.data()), moment(e.input.data() + 3);
    const Eigen::Vector3d on_ray = direction.cross(moment) + 0.3 * direction;
    const Eigen::Vector3d along = direction * (place - on_ray).dot(direction);
    return AttractionEnergy((place - on_ray - along).squaredNorm());
  });
}

TEST(AttractionPhysics, RaysPullTowardsTheRayAndAcrossIt) {
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<RayAttraction>(scene)) {
      const Eigen::VectorXd numbers = ElementNumbers<RayAttraction>(
          element, scene, Numbers({1.0, 0.0, 0.01}));  // 1 N/m: the force is the distance
      const Eigen::VectorXd force = EvaluateTerm<RayAttraction, double>(element, numbers);
      const Eigen::Vector3d net = force.segment<3>(0) + force.segment<3>(3) + force.segment<3>(6);
      const Eigen::Vector3d direction(element.input.data()), moment(element.input.data() + 3);
      Eigen::Vector3d place = Eigen::Vector3d::Zero();
      for (int n = 0; n < 3; ++n) place += element.weights[n] * numbers.segment<3>(3 * n);
      EXPECT_NEAR(net.dot(direction), 0.0, 1e-14);
      // place + net lies on the ray: its moment is the ray's.
      const Eigen::Vector3d foot = place + net;
      EXPECT_LE((foot.cross(direction) - moment).norm(), 1e-14);
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

// T = 1/2 m A (n . v)^2 of an element's numbers, moved on by a time.
double KineticEnergy(double mass, const Eigen::VectorXd& numbers, double time) {
  using Layout = TermLayout<AddedMass>;
  const auto a = numbers.segment<9>(Layout::kA);
  const Eigen::VectorXd v = numbers.segment<9>(Layout::kV) + time * a;
  const Eigen::VectorXd x =
      numbers.head<9>() + time * numbers.segment<9>(Layout::kV) + 0.5 * time * time * a;
  const Eigen::Vector3d across =
      (Node<1>(x) - Node<0>(x)).cross(Node<2>(x) - Node<0>(x)).normalized();
  const double speed = across.dot(Node<0>(v) + Node<1>(v) + Node<2>(v)) / 3.0;
  return 0.5 * mass * speed * speed;
}

// What the air's inertia takes from the cloth, its kinetic energy gains: f . v = -dT/dt; and its
// force is Lagrange's, -d/dt (dT/dv) + dT/dx.
TEST(AddedMassPhysics, ForceIsThatOfTheKineticEnergy) {
  using Layout = TermLayout<AddedMass>;
  GradientCheckOptions options;
  options.tolerance = 1e-8;
  options.max_steps = 12;
  const auto derivative = [&](const std::function<double(double)>& f, double step) {
    return RiddersDifference(
               [&](double s, Eigen::VectorXd* value) {
                 *value = Eigen::VectorXd::Constant(1, f(s));
                 return true;
               },
               step, options)
        .derivative[0];
  };
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    SCOPED_TRACE(scene.name);
    for (const auto& element : SceneElements<AddedMass>(scene)) {
      const Eigen::VectorXd numbers =
          ElementNumbers<AddedMass>(element, scene, Eigen::VectorXd::Constant(1, 0.3));
      const double mass = 0.3 * element.area;
      const Eigen::VectorXd force = EvaluateTerm<AddedMass, double>(element, numbers);
      const double power = force.dot(numbers.segment<9>(Layout::kV));
      const double gain =
          derivative([&](double t) { return KineticEnergy(mass, numbers, t); }, 1e-3);
      const double size = force.norm() * numbers.segment<9>(Layout::kV).norm();
      EXPECT_NEAR(power, -gain, 1e-7 * size + 1e-13);
      for (int i = 0; i < Layout::kForces; ++i) {
        const auto energy_with = [&](int column, double amount, double time) {
          Eigen::VectorXd moved = numbers;
          moved[column] += amount;
          return KineticEnergy(mass, moved, time);
        };
        // T is quadratic in v: the central difference over the speed is exact. A velocity moved
        // now moves the place later; that part is taken off by moving the place back.
        const double dv = scene.speed;
        const auto momentum = [&](double t) {
          Eigen::VectorXd up = numbers, down = numbers;
          up[Layout::kV + i] += dv;
          up[i] -= t * dv;
          down[Layout::kV + i] -= dv;
          down[i] += t * dv;
          return (KineticEnergy(mass, up, t) - KineticEnergy(mass, down, t)) / (2.0 * dv);
        };
        const double push = derivative([&](double s) { return energy_with(i, s, 0.0); }, 1e-4);
        EXPECT_NEAR(force[i], push - derivative(momentum, 1e-3), 1e-6 * force.norm() + 1e-11);
      }
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

// Bhat's formula, with the velocity split along and across the unit normal.
TEST(AirDragPhysics, IsBhatsFormula) {
  const Eigen::VectorXd k = Numbers({1.3, 0.2, 0.05});  // k_n, k_f, k_t
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<AirDrag>(scene)) {
      const Eigen::VectorXd numbers = ElementNumbers<AirDrag>(element, scene, k);
      const Eigen::Vector3d cross =
          (Node<1>(numbers) - Node<0>(numbers)).cross(Node<2>(numbers) - Node<0>(numbers));
      const Eigen::Vector3d normal = cross.normalized();
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      for (int n = 0; n < 3; ++n) v += numbers.segment<3>(9 + 3 * n) / 3.0;
      const Eigen::Vector3d v_n = normal * v.dot(normal), v_t = v - v_n;
      const double speed2 = v_n.squaredNorm();
      const Eigen::Vector3d expected =
          -0.5 * cross.norm() *
          (k[0] * speed2 / (1.0 + k[1] * speed2) * v_n.normalized() + k[2] * v_t);
      const Eigen::VectorXd force = EvaluateTerm<AirDrag, double>(element, numbers);
      for (int n = 0; n < 3; ++n) {
        EXPECT_LE((force.segment<3>(3 * n) - expected / 3.0).norm(), 1e-13 * expected.norm());
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100);
}

// Coulomb: sliding friction is mu times the push, against the motion.
TEST(GroundPhysics, SlidingFrictionIsCoulombs) {
  const GroundContact::Element element = {{0}, 1e-3, 0.0};
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(TermLayout<GroundContact>::kSize);
  numbers.head<6>() << 0.0, 0.0, 0.001, 3.0, -4.0, 0.0;
  numbers.segment<5>(6) << 1e5, 0.4, 0.0, 0.002, 1e-3;
  const Eigen::VectorXd f = EvaluateTerm<GroundContact, double>(element, numbers);
  EXPECT_NEAR(f[2], 1e-3 * 1e5 * 1e-6 / 0.002, 1e-12);
  // |v| / sqrt(|v|^2 + s^2) is 1 - 2e-8 at 5 m/s and s = 1 mm/s.
  EXPECT_NEAR(f[0], -0.4 * f[2] * 0.6, 1e-7 * f[2]);
  EXPECT_NEAR(f[1], 0.4 * f[2] * 0.8, 1e-7 * f[2]);
}

// The angle between the two triangles of a hinge, positive or negative, without the term's formula.
double FoldAngle(const Eigen::VectorXd& n) {
  const Eigen::Vector3d edge = (Node<3>(n) - Node<2>(n)).normalized();
  Eigen::Vector3d wing0 = Node<0>(n) - Node<2>(n), wing1 = Node<1>(n) - Node<2>(n);
  wing0 -= edge * wing0.dot(edge);
  wing1 -= edge * wing1.dot(edge);
  const double opening = std::atan2(wing0.cross(wing1).dot(edge), wing0.dot(wing1));  // flat: +-pi
  return opening > 0.0 ? opening - M_PI : opening + M_PI;
}

TEST(BendingPhysics, ForceIsThatOfTheEnergy) {
  const Eigen::VectorXd parameters = Numbers({1e-3, 0.0});
  ExpectForceOfEnergy<Bending>(parameters, [](const Hinge& hinge, const Eigen::VectorXd& n) {
    return 2.0 * 1e-3 * hinge.shape * (1.0 - std::cos(0.5 * FoldAngle(n)));
  });
}

// The damping is a moment -k_d/2 |E|^2 / (|N1| + |N2|) dtheta/dt, whose power is that times
// dtheta/dt: it shows the term's u_i to be the gradient of the angle.
TEST(BendingPhysics, DampingActsOnTheAnglesRate) {
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    SCOPED_TRACE(scene.name);
    for (const Hinge& hinge : SceneElements<Bending>(scene)) {
      const Eigen::VectorXd numbers = ElementNumbers<Bending>(hinge, scene, Numbers({0.0, 1e-3}));
      const Eigen::VectorXd force = EvaluateTerm<Bending, double>(hinge, numbers);
      Eigen::VectorXd gradient(12);
      for (int i = 0; i < 12; ++i) {
        GradientCheckOptions options;
        options.tolerance = 1e-8;
        const Difference d = RiddersDifference(
            [&](double s, Eigen::VectorXd* f) {
              Eigen::VectorXd moved = numbers;
              moved[i] += s;
              *f = Eigen::VectorXd::Constant(1, FoldAngle(moved));
              return true;
            },
            1e-4, options);
        gradient[i] = d.derivative[0];
      }
      const double rate = gradient.dot(numbers.segment<12>(12));
      const double viscous = 0.5 * 1e-3 * hinge.shape;
      const Eigen::VectorXd expected = -viscous * rate * gradient;
      // The differences' tolerance is 1e-8 of the gradient, but the rate is a sum that cancels.
      const double size = viscous * gradient.squaredNorm() * numbers.segment<12>(12).norm();
      EXPECT_LE((force - expected).norm(), 1e-7 * size);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

// A flat cloth that moves out of its plane with w / time is held back as one that has moved by w
// pushes back: the retardation time is k_d / k_e for every edge, whatever the mesh.
TEST(BendingPhysics, RetardationTimeIsTheSameOnEveryMesh) {
  constexpr double kStiffness = 4e-5, kTime = 0.3, kHeight = 1e-8;  // N m, s, m
  for (const std::array<int, 2>& particles : {std::array{4, 4}, {13, 13}, {7, 19}}) {
    const ClothMesh mesh = MakeGrid({0.5, 0.4}, particles);
    const ClothTopology topology = BuildTopology(mesh);
    for (const Hinge& hinge : topology.hinges) {
      Eigen::VectorXd moved = Eigen::VectorXd::Zero(TermLayout<Bending>::kSize);
      for (int n = 0; n < 4; ++n) moved.segment<2>(3 * n) = mesh.uv[hinge.nodes[n]];
      Eigen::VectorXd moving = moved;
      moved[2] = kHeight;
      moving[14] = kHeight / kTime;
      moved[24] = kStiffness;
      moving[25] = kStiffness * kTime;
      const Eigen::VectorXd elastic = EvaluateTerm<Bending, double>(hinge, moved);
      const Eigen::VectorXd viscous = EvaluateTerm<Bending, double>(hinge, moving);
      EXPECT_GT(elastic.norm(), 0.0);
      EXPECT_LE((elastic - viscous).norm(), 1e-5 * elastic.norm());
    }
  }
}

TEST(BendingPhysics, UnfoldsToEitherSide) {
  for (const double degrees : {1.0, 45.0, 90.0, 170.0, -1.0, -45.0, -90.0, -170.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * M_PI / 180.0;
    const ClothMesh mesh = MakeGrid({0.02, 0.01}, {3, 2});
    const ClothTopology topology = BuildTopology(mesh);
    int folded = 0;
    for (const Hinge& hinge : topology.hinges) {
      Eigen::VectorXd numbers = Eigen::VectorXd::Zero(TermLayout<Bending>::kSize);
      for (int n = 0; n < 4; ++n) {
        const Eigen::Vector2d uv = mesh.uv[hinge.nodes[n]];
        const double beyond = std::max(0.0, uv.x() - 0.01);
        numbers.segment<3>(3 * n) = Eigen::Vector3d(
            std::min(uv.x(), 0.01) + beyond * std::cos(angle), uv.y(), beyond * std::sin(angle));
      }
      numbers[24] = 1e-3;
      if (std::abs(FoldAngle(numbers)) < 1e-9) continue;
      ++folded;
      EXPECT_NEAR(std::abs(FoldAngle(numbers)), std::abs(angle), 1e-12);
      const Eigen::VectorXd f = EvaluateTerm<Bending, double>(hinge, numbers).head(12);
      // A small move along the forces makes the fold flatter.
      Eigen::VectorXd moved = numbers;
      moved.head(12) += 1e-5 * f / f.norm();
      EXPECT_LT(std::abs(FoldAngle(moved)), std::abs(FoldAngle(numbers)));
    }
    EXPECT_EQ(folded, 1);
  }
}

// Bends a grid into a cylinder z = c s^2 / 2 along a direction in (u, v), lets the particles at
// which diagonals end move against the others to where the elastic energy is least, and compares
// that with a plate's, B c^2 / 2 an area. Returns k_e / B.
double StiffnessOverPlate(const Eigen::Vector2d& along, double cell_u, double cell_v) {
  const int n = 41;
  const ClothMesh mesh = MakeGrid({cell_u * (n - 1), cell_v * (n - 1)}, {n, n});
  const ClothTopology topology = BuildTopology(mesh);
  const double curvature = 1e-2;  // 1/m: slopes below 1e-2, whose squares are neglected
  const auto energy_with = [&](double offset) {
    const auto place = [&](int node) {
      const Eigen::Vector2d uv = mesh.uv[node];
      const double s = (uv - mesh.uv[mesh.num_particles() / 2]).dot(along);
      const bool is_apart = (node % n + node / n) % 2 == 1;
      return Eigen::Vector3d(uv.x(), uv.y(), 0.5 * curvature * s * s + (is_apart ? offset : 0.0));
    };
    double energy = 0.0;
    for (const Hinge& hinge : topology.hinges) {
      // Only inner cells, so that the border's missing hinges do not count: 32 x 32 whole cells,
      // each with its lower and left side.
      Eigen::VectorXd numbers(12);
      for (int k = 0; k < 4; ++k) numbers.segment<3>(3 * k) = place(hinge.nodes[k]);
      const Eigen::Vector2d middle = 0.5 * (mesh.uv[hinge.nodes[2]] + mesh.uv[hinge.nodes[3]]);
      const bool inside = middle.x() >= 3.75 * cell_u && middle.x() < 35.75 * cell_u &&
                          middle.y() >= 3.75 * cell_v && middle.y() < 35.75 * cell_v;
      if (!inside) continue;
      energy += 2.0 * hinge.shape * (1.0 - std::cos(0.5 * FoldAngle(numbers)));  // k_e = 1 N m
    }
    return energy;
  };
  // The least of the parabola through three points.
  const double step = curvature * cell_u * cell_v;
  const double low = energy_with(-step), middle = energy_with(0.0), high = energy_with(step);
  const double slope = 0.5 * (high - low), bend = high - 2.0 * middle + low;
  const double least = middle - 0.5 * slope * slope / bend;
  const double area = 32.0 * 32.0 * cell_u * cell_v;
  return 0.5 * curvature * curvature * area / least;
}

TEST(BendingPhysics, StiffnessIsFourTimesAPlatesInEveryDirection) {
  for (const double degrees : {0.0, 20.0, 45.0, 70.0, 90.0, 135.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * M_PI / 180.0;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    EXPECT_NEAR(StiffnessOverPlate(along, 0.02, 0.02), 4.0, 1e-2);
    EXPECT_NEAR(StiffnessOverPlate(along, 0.02, 0.029), 4.0, 1e-2);
  }
}

}  // namespace
}  // namespace clothfit
