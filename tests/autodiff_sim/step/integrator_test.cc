// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The motion itself: order in time and conservation laws.
#include <cmath>
#include <numeric>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/step/simulation.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

// A cloth that hangs and has been pushed aside, smoothly, after `steps` steps of 0.1 s together.
Eigen::VectorXd Pushed(Integrator integrator, int steps) {
  TestScene scene = SwingingCloth(5, 0.3);
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, 0.3}, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
  SimulationOptions options;
  options.integrator = integrator;
  options.tolerance = 1e-11;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  // Soft, so that 1 ms resolves all that moves.
  Set("stretch.stiffness", 2.0, &simulation);
  Set("shear.stiffness", 0.5, &simulation);
  Set("bending.stiffness", 1e-4, &simulation);
  Set("gravity.scale", 0.05, &simulation);
  State state = simulation.MakeState(scene.x);
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const double down = scene.mesh.uv[i].y() / 0.3;
    state.v.segment<3>(3 * i) = down * down * Eigen::Vector3d(0.1, 0.5, 0.0);
  }
  const std::vector<Eigen::Vector3d> places = {scene.handles[0].At(scene.x),
                                               scene.handles[1].At(scene.x)};
  scene.path = [places](double) { return places; };
  Advance(0.1 / steps, steps, scene.MakeDrive(), &simulation, &state);
  return state.x;
}

TEST(Integrator, ConvergesWithItsOrder) {
  const Eigen::VectorXd reference = Pushed(Integrator::kBdf2, 1280);  // error 1/64 of the next
  for (const Integrator integrator : {Integrator::kBackwardEuler, Integrator::kBdf2}) {
    const double coarse = (Pushed(integrator, 80) - reference).norm();
    const double fine = (Pushed(integrator, 160) - reference).norm();
    const double order = std::log2(coarse / fine);
    EXPECT_NEAR(order, integrator == Integrator::kBdf2 ? 2.0 : 1.0, 0.15);
    EXPECT_LT(fine, 1e-2);
  }
}

// Implicit integrators take energy where they are inexact; they must not give any.
TEST(Integrator, EnergyOfAHangingClothNeverGrows) {
  for (const Integrator integrator : {Integrator::kBackwardEuler, Integrator::kBdf2}) {
    TestScene scene = SwingingCloth(6, 0.3);
    const std::vector<Eigen::Vector3d> places = scene.path(0.0);
    scene.path = [places](double) { return places; };
    SimulationOptions options;
    options.integrator = integrator;
    Simulation simulation(scene.mesh, scene.world, scene.handles, options);
    UseSuppleCloth(&simulation);
    Set("bending.stiffness", 1e-4, &simulation);
    State state = simulation.MakeState(scene.x);
    const double start = Total(simulation.Energies(state));
    double energy = start;
    const double scale = 0.15 * 0.09 * 9.81 * 0.15;  // J, of the fall
    double largest_gain = 0.0;
    for (int i = 0; i < 150; ++i) {
      Advance(1.0 / 240.0, 1, scene.MakeDrive(), &simulation, &state);
      const double now = Total(simulation.Energies(state));
      largest_gain = std::max(largest_gain, now - energy);
      energy = std::min(energy, now);
    }
    EXPECT_LT(energy, start - 0.5 * scale);  // it has fallen: there was something to gain from
    // Backward Euler's energy falls at every step (its steps minimise, where springs are taut).
    // BDF2's own quadratic form falls; energy follows it but for an h^2 of what moves: 0.1 %.
    EXPECT_LE(largest_gain, (integrator == Integrator::kBdf2 ? 1e-3 : 1e-9) * scale);
  }
}

TEST(Integrator, InternalForcesConserveMomentum) {
  for (const Integrator integrator : {Integrator::kBackwardEuler, Integrator::kBdf2}) {
    const ClothMesh mesh = MakeGrid({0.3, 0.3}, {6, 6});
    SimulationOptions options;
    options.integrator = integrator;
    Simulation simulation(mesh, World(), {}, options);
    UseSuppleCloth(&simulation);
    KeepOnly({"stretch", "shear", "bending"}, &simulation);
    State state = simulation.MakeState(
        LayFlat(mesh, {-0.15, -0.15, 0.0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
    for (Eigen::Index i = 0; i < state.v.size(); ++i)
      state.v[i] = std::sin(1.3 * static_cast<double>(i));
    const std::vector<double>& areas = simulation.model().topology().areas;
    const auto momentum = [&]() {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < areas.size(); ++i)
        p += 0.15 * areas[i] * state.v.segment<3>(3 * i);
      return p;
    };
    const Eigen::Vector3d before = momentum();
    const Eigen::VectorXd shape = state.x;
    Advance(1.0 / 120.0, 60, FreeDrive(), &simulation, &state);
    EXPECT_GT((state.x - shape).norm(), 0.1);
    // Each step is solved to 1e-9 of an edge (0.06 m) in position, so 1e-8 m/s in velocity.
    EXPECT_LE((momentum() - before).norm(), 60 * 1e-8 * 0.15 * 0.09);
  }
}

// Multistep formulas conserve the momentum of x and v linearly; the angular momentum is quadratic
// and only kept to the order of the method.
TEST(Integrator, AngularMomentumIsKeptToTheOrder) {
  const auto loss = [](double step, int steps) {
    const ClothMesh mesh = MakeGrid({0.3, 0.3}, {4, 4});
    Simulation simulation(mesh, World(), {});
    UseSuppleCloth(&simulation);
    KeepOnly({"stretch", "shear", "bending"}, &simulation);
    Set("stretch.damping", 0.2, &simulation);
    State state = simulation.MakeState(
        LayFlat(mesh, {-0.15, -0.15, 0.0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
    for (int i = 0; i < mesh.num_particles(); ++i) {
      state.v.segment<3>(3 * i) =
          Eigen::Vector3d(0.0, 0.0, 1.0).cross(Eigen::Vector3d(state.x.segment<3>(3 * i)));
    }
    const std::vector<double>& areas = simulation.model().topology().areas;
    const auto angular = [&]() {
      Eigen::Vector3d l = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < areas.size(); ++i) {
        l += 0.15 * areas[i] *
             Eigen::Vector3d(state.x.segment<3>(3 * i)).cross(state.v.segment<3>(3 * i));
      }
      return l.z();
    };
    const double before = angular();
    Advance(step, steps, FreeDrive(), &simulation, &state);
    return std::abs(angular() / before - 1.0);
  };
  const double coarse = loss(1.0 / 60.0, 30), fine = loss(1.0 / 240.0, 120);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, 0.15 * coarse);  // a second order would leave 1/16, and the first step is Euler's
}

}  // namespace
}  // namespace clothfit
