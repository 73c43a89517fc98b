// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the world does: masses in tilted gravity, adhesion, obstacles and attraction, against their
// laws written another way.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/terms/force_of_energy.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

// Swings for half a second with these parameters set.
State Swing(const std::vector<std::pair<std::string, double>>& values) {
  const TestScene scene = SwingingCloth(5, 0.3);
  SimulationOptions options;
  options.tolerance = 1e-12;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  for (const auto& [name, value] : values) Set(name, value, &simulation);
  State state = simulation.MakeState(scene.x);
  Advance(1.0 / 120.0, 60, scene.MakeDrive(), &simulation, &state);
  return state;
}

// A patch that covers the cloth with as much mass as it has: a cloth of twice the areal density,
// in weight and in inertia, also in gravity that is tilted.
TEST(HeavyPatchPhysics, EverywhereIsArealDensity) {
  const State patched = Swing({{"heavy_patch.share", 1.0},
                               {"heavy_patch.radius", 1e6},
                               {"gravity_tilt.angle_1", 0.1},
                               {"gravity.scale", 0.9}});
  const State heavy =
      Swing({{"cloth.areal_density", 0.3}, {"gravity_tilt.angle_1", 0.1}, {"gravity.scale", 0.9}});
  const State light = Swing({{"gravity_tilt.angle_1", 0.1}, {"gravity.scale", 0.9}});
  // 60 steps solved to 1e-12 of an edge.
  EXPECT_LE((patched.x - heavy.x).lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_GT((light.x - heavy.x).lpNorm<Eigen::Infinity>(), 1e-3);
}

TEST(HemPhysics, WeighsItsLengths) {
  TermScene scene = MakeTermScenes().front();
  scene.a.setZero();
  const auto elements = SceneElements<Hem>(scene);
  // kg/m of the sides u = 0, u = 0.08 m, v = 0, v = 0.06 m.
  const Eigen::Vector4d density(0.01, 0.02, 0.03, 0.04);
  double net = 0.0;
  for (const auto& element : elements) {
    const Eigen::Vector3d f =
        EvaluateTerm<Hem, double>(element, ElementNumbers<Hem>(element, scene, density));
    net += f.z();
    const Eigen::Vector2d uv = scene.mesh.uv[element.nodes[0]];
    const bool inner = uv.x() > 0.01 && uv.x() < 0.07;
    // A particle of the side v = 0 stands for one edge of it.
    if (inner && uv.y() == 0.0) {
      EXPECT_NEAR(f.z(), -0.03 * 0.02 * 9.81, 1e-15);
    }
  }
  EXPECT_NEAR(net, -9.81 * (0.01 * 0.06 + 0.02 * 0.06 + 0.03 * 0.08 + 0.04 * 0.08), 1e-14);
  EXPECT_EQ(elements.size(), 14u);  // of 20 particles 6 are inside
}

// Nothing but weight and inertia: what falls freely falls with gravity and feels no force.
TEST(HemPhysics, FallsFreely) {
  TermScene scene = MakeTermScenes().front();
  for (int i = 0; i < scene.mesh.num_particles(); ++i)
    scene.a.segment<3>(3 * i) = scene.world.gravity;
  for (const auto& element : SceneElements<Hem>(scene)) {
    const Eigen::VectorXd f = EvaluateTerm<Hem, double>(
        element, ElementNumbers<Hem>(element, scene, Eigen::Vector4d::Constant(0.1)));
    EXPECT_LE(f.norm(), 1e-16);
  }
}

TEST(AdhesionPhysics, IsLargestAtItsRange) {
  const double range = 0.004;
  EXPECT_EQ(AdhesionShare<double>(-1e-3, range), 0.0);
  EXPECT_EQ(AdhesionShare<double>(range, range), 1.0);
  EXPECT_LT(AdhesionShare<double>(0.9 * range, range), 1.0);
  EXPECT_LT(AdhesionShare<double>(1.1 * range, range), 1.0);
  EXPECT_NEAR(AdhesionShare<double>(1e-6, range), 0.0, 1e-6);
  EXPECT_LT(AdhesionShare<double>(10.0 * range, range), 1e-5);
}

// What it takes to pull an area off is the pressure times range times e^2 / 4, the integral of the
// traction over all gaps.
TEST(AdhesionPhysics, ForceIsThatOfTheEnergy) {
  const double pressure = 30.0, range = 0.004;
  const auto energy = [&](double gap) {
    if (gap <= 0.0) return 0.0;
    const double q = gap / range;
    const double tail = std::exp(-2.0 * q) * (0.5 * q * q + 0.5 * q + 0.25);
    return pressure * range * std::exp(2.0) * (0.25 - tail);
  };
  int count = 0;
  for (TermScene scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<Adhesion>(scene)) {
      const Eigen::VectorXd numbers =
          ElementNumbers<Adhesion>(element, scene, Numbers({pressure, range}));
      const double z = numbers[2], step = 1e-6;
      const Eigen::Vector3d f = EvaluateTerm<Adhesion, double>(element, numbers);
      const double slope = (energy(z + step) - energy(z - step)) / (2.0 * step);
      // The difference's own error, step^2 / range^2, and at a gap of zero its kink's.
      EXPECT_NEAR(f.z(), -element.area * slope, 1e-5 * element.area * pressure);
      EXPECT_EQ(f.head<2>().norm(), 0.0);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

TEST(AdhesionPhysics, PatchThatCoversTheClothIsAdhesion) {
  const TermScene scene = MakeTermScenes()[6];
  for (const auto& element : SceneElements<Adhesion>(scene)) {
    const Eigen::VectorXd patch = EvaluateTerm<StickyPatch, double>(
        element, ElementNumbers<StickyPatch>(element, scene, Numbers({5.0, 0.003, 0.0, 0.0, 1e6})));
    const Eigen::VectorXd all = EvaluateTerm<Adhesion, double>(
        element, ElementNumbers<Adhesion>(element, scene, Numbers({5.0, 0.003})));
    EXPECT_LE((patch - all).norm(), 1e-12 * all.norm());
    EXPECT_GT(all.norm(), 0.0);
  }
}

// Integral of SoftDepth: cubic up to 5 mm, quadratic beyond.
double SoftEnergy(double depth) {
  constexpr double kSoft = 0.005;
  if (depth <= 0.0) return 0.0;
  if (depth < kSoft) return depth * depth * depth / (6.0 * kSoft);
  return kSoft * kSoft / 6.0 + 0.5 * (depth * depth - kSoft * kSoft) -
         0.5 * kSoft * (depth - kSoft);
}

// Of a radius of 0.1, as the terms take it: smooth in the middle.
double DepthInBall(double distance) { return (0.1 * 0.1 - distance * distance) / (2.0 * 0.1); }

TEST(ObstaclePhysics, ForcesAreThoseOfTheEnergies) {
  const double k = 2e4;
  const Eigen::Vector3d middle(0.13, -0.02, 0.42), end(0.16, 0.01, 0.3);
  ExpectForceOfEnergy<ObstacleSphere>(
      Numbers({k, middle.x(), middle.y(), middle.z(), 0.1}), [&](const auto& e, const auto& n) {
        return e.area * k * SoftEnergy(DepthInBall((Node<0>(n) - middle).norm()));
      });
  ExpectForceOfEnergy<ObstacleCapsule>(
      Numbers({k, middle.x(), middle.y(), middle.z(), end.x(), end.y(), end.z(), 0.1}),
      [&](const auto& e, const auto& n) {
        // The nearest of many points of the axis.
        double nearest = 1e9;
        const Eigen::Vector3d axis = end - middle;
        const double share = (Node<0>(n) - middle).dot(axis) / axis.squaredNorm();
        for (const double s : {0.0, 1.0, std::min(1.0, std::max(0.0, share))})
          nearest = std::min(nearest, (Node<0>(n) - middle - s * axis).norm());
        return e.area * k * SoftEnergy(DepthInBall(nearest));
      });
  // A plane at 0.301 m whose normal is turned about x by 0.1.
  const Eigen::Vector3d normal(0.0, -std::sin(0.1), std::cos(0.1));
  ExpectForceOfEnergy<ObstaclePlane>(
      Numbers({k, 0.301, 0.1, 0.0}), [&](const auto& e, const auto& n) {
        return e.area * k * SoftEnergy(0.301 - normal.dot(Node<0>(n)));
      });
}

TEST(ObstaclePhysics, TableHasAnEdge) {
  const double k = 2e4;
  const Eigen::Vector3d first(0.15, 0.1, 0.3), second(0.1, 0.3, 0.32);
  const Eigen::Vector3d edge = (second - first).normalized();
  const Eigen::Vector3d over = edge.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d top = over.cross(edge);
  EXPECT_GT(over.x(), 0.0);  // to the right of the way, and the table to the left
  ExpectForceOfEnergy<ObstacleTable>(
      Numbers({k, first.x(), first.y(), first.z(), second.x(), second.y(), second.z()}),
      [&](const auto& e, const auto& n) {
        const Eigen::Vector3d below = first - Node<0>(n);
        const double a = below.dot(top), b = below.dot(over);
        return a > 0.0 && b > 0.0 ? e.area * k * SoftEnergy(a + b - std::hypot(a, b)) : 0.0;
      });
}

TEST(ObstaclePhysics, TableIsAPlaneFarBehindItsEdge) {
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<ObstacleTable>(scene)) {
      const Eigen::VectorXd table = EvaluateTerm<ObstacleTable, double>(
          element, ElementNumbers<ObstacleTable>(element, scene,
                                                 Numbers({2e4, 1e4, 0.0, 0.301, 1e4, 1.0, 0.301})));
      const Eigen::VectorXd plane = EvaluateTerm<ObstaclePlane, double>(
          element, ElementNumbers<ObstaclePlane>(element, scene, Numbers({2e4, 0.301, 0.0, 0.0})));
      EXPECT_LE((table - plane).norm(), 1e-3 * plane.norm());
      count += plane.norm() > 0.0;
    }
  }
  EXPECT_GT(count, 100);
}

// In the middle, where there is no direction, there is no push.
TEST(ObstaclePhysics, IsFiniteInTheMiddleAndWithoutLength) {
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(TermLayout<ObstacleCapsule>::kSize);
  numbers.segment<8>(6) << 1e4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1;
  const AreaElement element = {{0}, 1e-4};
  EXPECT_EQ((EvaluateTerm<ObstacleCapsule, double>(element, numbers).norm()), 0.0);
  for (int column = 0; column < numbers.size(); ++column)
    EXPECT_TRUE((DifferentiateTerm<ObstacleCapsule>(element, numbers, column).allFinite()));
  numbers[0] = 0.05;
  EXPECT_GT((EvaluateTerm<ObstacleCapsule, double>(element, numbers)[0]), 0.0);
}

// Gravity and its tilt together are the weight in a world that is turned.
TEST(GravityTiltPhysics, TurnsTheWeight) {
  const double angle_1 = 0.2, angle_2 = -0.3;
  const Eigen::Vector3d turn(angle_1, angle_2, 0.0);
  const Eigen::Vector3d turned =
      Eigen::AngleAxisd(turn.norm(), turn.normalized()) * Eigen::Vector3d(0.0, 0.0, -9.81);
  const TermScene scene = MakeTermScenes().front();
  int count = 0;
  for (const auto& element : SceneElements<GravityTilt>(scene)) {
    const Eigen::Vector3d extra = EvaluateTerm<GravityTilt, double>(
        element, ElementNumbers<GravityTilt>(element, scene, Numbers({angle_1, angle_2})));
    const double mass = 0.15 * element.area;
    const Eigen::Vector3d weight(0.0, 0.0, -9.81 * mass);
    EXPECT_LE((weight + extra - mass * turned).norm(), 1e-14 * weight.norm());
    ++count;
  }
  EXPECT_GT(count, 10);
}

TEST(GravityTiltPhysics, HasAFrameForAnyGravity) {
  for (const Eigen::Vector3d& gravity :
       {Eigen::Vector3d(0, 0, -9.81), Eigen::Vector3d(9.81, 0, 0), Eigen::Vector3d(0, -9.81, 0),
        Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0, 0, 0)}) {
    const DownFrame frame = MakeDownFrame(gravity);
    Eigen::Matrix3d axes;
    axes << frame.axis_1, frame.axis_2, -frame.down;
    EXPECT_LE((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-15);
    // The series near zero and the formula beyond meet.
    for (const double angle : {0.0099999, 0.0100001, 1.0}) {
      const Eigen::Vector3d expected =
          Eigen::AngleAxisd(angle, frame.axis_2).toRotationMatrix() * frame.down;
      EXPECT_LE((TiltedDown<double>(frame, 0.0, angle) - expected).norm(), 1e-14);
    }
  }
  EXPECT_EQ(MakeDownFrame({0, 0, -9.81}).axis_2, Eigen::Vector3d::UnitY());
}

TEST(AttractorPhysics, ForceIsThatOfTheEnergy) {
  const Eigen::Vector3d place(0.13, -0.03, 0.45);
  const Eigen::VectorXd parameters = Numbers({50.0, place.x(), place.y(), place.z(), 0.2});
  ExpectForceOfEnergy<Attractor>(parameters, [&](const auto& e, const auto& n) {
    const double square = (Node<0>(n) - place).squaredNorm();
    return -e.area * 50.0 * 0.04 * std::exp(-0.5 * square / 0.04);
  });
}

}  // namespace
}  // namespace clothfit
