// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Grips that yield and grips that slip: as constraints while rigid, as forces otherwise, and the
// derivatives where one becomes the other.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/step/rollout.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

using Values = std::map<std::string, double>;

constexpr double kGripStep = 1.0 / 240.0;                    // s
constexpr double kDensity = 0.15, kSide = 0.3;               // kg/m^2, m
constexpr double kWeight = kDensity * kSide * kSide * 9.81;  // N

// Hangs straight down from two corners that rest.
TestScene HangingCloth() {
  TestScene scene = SwingingCloth(5, kSide);
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, 0.3}, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
  const std::vector<Eigen::Vector3d> places = {scene.handles[0].At(scene.x),
                                               scene.handles[1].At(scene.x)};
  scene.path = [places](double) { return places; };
  return scene;
}

State Settle(const TestScene& scene, Simulation* simulation) {
  State state = simulation->MakeState(scene.x);
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(simulation->Advance(0.1, scene.MakeDrive(), &state).status, StepStatus::kConverged);
  }
  EXPECT_LE(state.v.lpNorm<Eigen::Infinity>(), 1e-6);
  return state;
}

Simulation SettlingSimulation(const TestScene& scene) {
  SimulationOptions options;
  options.integrator = Integrator::kBackwardEuler;  // forgets its motion sooner
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  Set("air_drag.tangential", 1.0, &simulation);
  return simulation;
}

// By symmetry each corner carries half of the weight, straight up but for a pull along the edge.
TEST(Grip, YieldsByItsShareOfTheWeight) {
  const TestScene scene = HangingCloth();
  Simulation simulation = SettlingSimulation(scene);
  constexpr double kCompliance = 5e-3;
  Set("grip.compliance", kCompliance, &simulation);
  const State state = Settle(scene, &simulation);
  const std::vector<Eigen::Vector3d> places = scene.path(0.0);
  Eigen::Vector3d net = Eigen::Vector3d::Zero();
  for (std::size_t h = 0; h < 2; ++h) {
    const Eigen::Vector3d way = scene.handles[h].At(state.x) - places[h];
    EXPECT_NEAR(way.z(), -kCompliance * kWeight / 2.0, 1e-6 * kCompliance * kWeight);
    const Eigen::Vector3d force =
        simulation.handle_forces().segment<3>(3 * scene.handles[h].nodes[0]) +
        simulation.handle_forces().segment<3>(3 * scene.handles[h].nodes[1]) +
        simulation.handle_forces().segment<3>(3 * scene.handles[h].nodes[2]);
    EXPECT_LE((way + kCompliance * force).norm(), 1e-12);
    net += force;
  }
  EXPECT_NEAR(net.z(), kWeight, 1e-6 * kWeight);
}

TEST(Grip, TakesTheClothAlongAsItSlips) {
  for (const double compliance : {0.0, 1e-5}) {
    SCOPED_TRACE(compliance);
    const TestScene scene = SwingingCloth(5, kSide);
    Simulation simulation(scene.mesh, scene.world, scene.handles);
    UseSuppleCloth(&simulation);
    Set("grip.compliance", compliance, &simulation);
    // Of one corner, the other being ten radii away.
    const Values slips = {{"x", 0.004},      {"y", 0.003}, {"z", -0.012}, {"onset", 0.1},
                          {"duration", 0.1}, {"u", kSide}, {"v", 0.0},    {"radius", 0.03}};
    for (const auto& [name, value] : slips) Set("grip_slip." + name, value, &simulation);
    State state = simulation.MakeState(scene.x);
    for (int i = 0; i < 72; ++i) {
      ASSERT_EQ(simulation.Advance(kGripStep, scene.MakeDrive(), &state).status,
                StepStatus::kConverged);
      const std::vector<Eigen::Vector3d> places = scene.path(state.time);
      const double phase = std::clamp((state.time - 0.1) / 0.1, 0.0, 1.0);
      const double share = 0.5 * (1.0 - std::cos(M_PI * phase));
      const Eigen::Vector3d slip = share * Eigen::Vector3d(0.004, 0.003, -0.012);
      // Yields by the cloth's pull, of about its weight.
      const double near = 1e-12 + 10.0 * compliance * kWeight;
      EXPECT_LE((scene.handles[1].At(state.x) - places[1] - slip).norm(), near);
      EXPECT_LE((scene.handles[0].At(state.x) - places[0]).norm(), near);
    }
  }
}

// A rollout with moving, inner and corner handles.
Rollout MovedCloth() {
  TestScene scene = SwingingCloth(5, kSide);
  scene.handles = LocateOnCloth(scene.mesh, {{0.02, 0.03}, {kSide, 0.0}});  // one in a triangle
  const std::vector<Eigen::Vector3d> places = {scene.handles[0].At(scene.x),
                                               scene.handles[1].At(scene.x)};
  scene.path = [places](double time) {
    const Eigen::Vector3d sway(0.0, 0.05 * std::sin(2.0 * M_PI * time), 0.03 * time);
    return std::vector<Eigen::Vector3d>{places[0] + sway, places[1] + 0.8 * sway};
  };
  Rollout rollout = MakeRollout(scene, Precise(Integrator::kBdf2));
  rollout.steps = 60;
  rollout.AddParameter("grip.compliance");
  return rollout;
}

Eigen::VectorXd One(double value) { return Eigen::VectorXd::Constant(1, value); }

TEST(Grip, DerivativeWhenRigidIsThatOfSwitchingOn) {
  const Rollout rollout = MovedCloth();
  const RolloutResult rigid = RunRollout(rollout, One(0.0), true);
  ASSERT_TRUE(rigid.converged);
  // One-sided differences of order h^2 and their order: a quarter where h is half.
  const auto error = [&](double h) {
    const Eigen::VectorXd once = RunRollout(rollout, One(h), false).values;
    const Eigen::VectorXd twice = RunRollout(rollout, One(2.0 * h), false).values;
    const Eigen::VectorXd difference = (4.0 * once - twice - 3.0 * rigid.values) / (2.0 * h);
    return (difference - rigid.jacobian.col(0)).lpNorm<Eigen::Infinity>() /
           rigid.jacobian.col(0).lpNorm<Eigen::Infinity>();
  };
  const double coarse = error(4e-5), fine = error(2e-5);
  EXPECT_LE(fine, 1e-4);
  EXPECT_NEAR(coarse / fine, 4.0, 1.0);
}

// The slip of a grip that yields is a force, that of a rigid one moves a constraint: with less and
// less compliance one becomes the other, its derivatives too.
TEST(Grip, SlipOfAStiffGripIsThatOfARigidOne) {
  Rollout rollout = MovedCloth();
  rollout.directions.clear();
  const Values slips = {
      {"z", -0.02}, {"onset", 0.1}, {"duration", 0.2}, {"u", 0.25}, {"radius", 0.2}};
  for (const auto& [name, value] : slips) {
    Set("grip_slip." + name, value, &rollout);
    rollout.AddParameter("grip_slip." + name);
  }
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(5);
  const RolloutResult rigid = RunRollout(rollout, zero, true);
  ASSERT_TRUE(rigid.converged);
  std::vector<double> apart, slopes_apart;
  for (const double compliance : {2e-5, 1e-5}) {
    Set("grip.compliance", compliance, &rollout);
    const RolloutResult soft = RunRollout(rollout, zero, true);
    ASSERT_TRUE(soft.converged);
    apart.push_back((soft.values - rigid.values).lpNorm<Eigen::Infinity>());
    slopes_apart.push_back((soft.jacobian - rigid.jacobian).norm() / rigid.jacobian.norm());
  }
  EXPECT_LE(apart[1], 1e-3);
  EXPECT_LE(slopes_apart[1], 1e-2);
  EXPECT_NEAR(apart[0] / apart[1], 2.0, 0.2);
  EXPECT_NEAR(slopes_apart[0] / slopes_apart[1], 2.0, 0.2);
}

}  // namespace
}  // namespace clothfit
