// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a simulation promises its callers, whatever the physics.
#include "autodiff_sim/step/simulation.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "autodiff_sim/step/known_motion.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

Simulation MakeSimulation(const TestScene& scene, const SimulationOptions& options = {}) {
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  return simulation;
}

// `steps` steps from rest; expects all to converge.
State Simulate(const TestScene& scene, int steps, Simulation* simulation) {
  State state = simulation->MakeState(scene.x);
  const Drive drive = scene.MakeDrive();
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(simulation->Advance(kStep, drive, &state).status, StepStatus::kConverged);
  }
  return state;
}

TEST(Simulation, SameResultTwiceToTheBit) {
  const TestScene scene = SwingingCloth(6, 0.3);
  Simulation first = MakeSimulation(scene), second = MakeSimulation(scene);
  const State a = Simulate(scene, 30, &first), b = Simulate(scene, 30, &second);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  first.Reset();
  const State again = Simulate(scene, 30, &first);
  EXPECT_EQ(a.x, again.x);
  EXPECT_EQ(a.v, again.v);
}

// Derivatives are looked at, not lived by: carrying them along does not move the cloth. The kept
// factor differs, so the iterates do within the tolerance, 1e-9 of an edge a step.
TEST(Simulation, DerivativesDoNotMoveTheCloth) {
  const TestScene scene = SwingingCloth(6, 0.3);
  Simulation simulation = MakeSimulation(scene);
  const State plain = Simulate(scene, 30, &simulation);
  simulation.Reset();
  State state = simulation.MakeState(scene.x);
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(simulation.parameters().size(), 1);
  directions(1, 0) = 1.0;
  Sensitivity sensitivity(state, directions);
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(simulation.Advance(kStep, scene.MakeDrive(), &state, &sensitivity).status,
              StepStatus::kConverged);
  }
  EXPECT_LE((state.x - plain.x).lpNorm<Eigen::Infinity>(), 1e-8);
  EXPECT_GT(sensitivity.x().norm(), 0.0);
}

// A motion that is known is differentiated as it would be where it is solved for.
TEST(Simulation, AKnownMotionIsNotSolvedForAgain) {
  const TestScene scene = SwingingCloth(6, 0.3);
  Simulation simulation = MakeSimulation(scene);
  const Drive drive = scene.MakeDrive();
  State plain = simulation.MakeState(scene.x);
  KnownMotion motion;
  motion.Begin(plain.x);
  for (int i = 0; i < 30; ++i) motion.Add(simulation.Advance(kStep, drive, &plain), plain);
  EXPECT_TRUE(motion.IsOf(scene.x));
  EXPECT_FALSE(motion.IsOf(plain.x));
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(simulation.parameters().size(), 3);
  for (int i = 0; i < 3; ++i) directions(i + 1, i) = 1.0;
  std::vector<Eigen::MatrixXd> derivatives;
  for (const bool is_known : {false, true}) {
    simulation.Reset();
    State state = simulation.MakeState(scene.x);
    Sensitivity sensitivity(state, directions);
    StepReport total;
    for (std::size_t i = 0; i < 30; ++i) {
      const Eigen::VectorXd* v = motion.After(i);
      ASSERT_NE(v, nullptr);
      total += simulation.Advance(kStep, drive, &state, &sensitivity, is_known ? v : nullptr);
    }
    ASSERT_EQ(total.status, StepStatus::kConverged);
    EXPECT_EQ(motion.After(30), nullptr);
    derivatives.push_back(sensitivity.x());
    if (is_known) {
      EXPECT_EQ(state.x, plain.x);
      EXPECT_EQ(total.newton_iterations, 0);
    }
  }
  EXPECT_LE((derivatives[1] - derivatives[0]).norm(), 1e-6 * derivatives[0].norm());
}

TEST(Simulation, TimeIsThatOfTheSteps) {
  const TestScene scene = SwingingCloth(4, 0.3);
  Simulation simulation = MakeSimulation(scene);
  State state = Simulate(scene, 12, &simulation);
  EXPECT_NEAR(state.time, 12 * kStep, 1e-15);
}

// Everything that must not converge: it reports so, and leaves state and derivatives as they were.
void ExpectDiverged(const TestScene& scene, const Drive& drive, const Eigen::VectorXd* parameters,
                    const Eigen::VectorXd* x = nullptr) {
  SimulationOptions options;
  options.max_halvings = 3;
  Simulation simulation = MakeSimulation(scene, options);
  if (parameters != nullptr) simulation.SetParameters(*parameters);
  State state = simulation.MakeState(x != nullptr ? *x : scene.x);
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(simulation.parameters().size(), 1);
  directions(1, 0) = 1.0;
  Sensitivity sensitivity(state, directions);
  const State before = state;
  const StepReport report = simulation.Advance(kStep, drive, &state, &sensitivity);
  EXPECT_EQ(report.status, StepStatus::kDiverged);
  EXPECT_EQ(report.halvings, 3);
  EXPECT_EQ(state.time, before.time);
  EXPECT_EQ(state.v, before.v);
  if (x == nullptr) {
    EXPECT_EQ(state.x, before.x);
  }
  EXPECT_TRUE(sensitivity.x().isZero(0.0));
  EXPECT_TRUE(sensitivity.v().isZero(0.0));
}

TEST(Simulation, NothingConvergesOnWhatIsNoNumber) {
  const TestScene scene = SwingingCloth(4, 0.3);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinite, -infinite}) {
    const Drive drive = [&](double time, bool) {
      StepInputs inputs = scene.MakeDrive()(time, false);
      inputs.handles[0].position.y() = bad;
      return inputs;
    };
    ExpectDiverged(scene, drive, nullptr);
    Eigen::VectorXd parameters = MakeSimulation(scene).parameters();
    for (int p = 0; p < 4; ++p) {
      Eigen::VectorXd wrong = parameters;
      wrong[p] = bad;
      SCOPED_TRACE(p);
      ExpectDiverged(scene, scene.MakeDrive(), &wrong);
    }
    Eigen::VectorXd x = scene.x;
    x[30] = bad;
    ExpectDiverged(scene, scene.MakeDrive(), nullptr, &x);
  }
}

// Absurd parameters: whatever comes of it, a converged step is finite and solves its equation.
TEST(Simulation, AbsurdParametersGiveNoNonsense) {
  const TestScene scene = SwingingCloth(4, 0.3);
  int diverged = 0, converged = 0;
  for (const double factor : {0.0, -1.0, -1e6, 1e12, 1e200}) {
    for (const char* name : {"cloth.areal_density", "stretch.stiffness", "bending.stiffness",
                             "air_drag.normal", "air_drag.saturation"}) {
      SimulationOptions options;
      options.max_halvings = 2;
      Simulation simulation = MakeSimulation(scene, options);
      Eigen::VectorXd parameters = simulation.parameters();
      parameters[RequireParameter(simulation.model().parameters(), name)] =
          factor == 0.0 ? 0.0 : factor * 0.1;
      simulation.SetParameters(parameters);
      State state = simulation.MakeState(scene.x);
      SCOPED_TRACE(std::string(name) + " " + std::to_string(factor));
      for (int i = 0; i < 10; ++i) {
        const State before = state;
        const StepReport report = simulation.Advance(kStep, scene.MakeDrive(), &state);
        EXPECT_TRUE(state.x.allFinite() && state.v.allFinite() && state.previous_x.allFinite());
        if (report.status != StepStatus::kConverged) {
          ++diverged;
          break;
        }
        ++converged;
        EXPECT_LE(report.error, options.tolerance * 0.2);  // an edge is about 0.1 m
      }
    }
  }
  EXPECT_GT(converged, 0);
  EXPECT_GT(diverged, 0);
}

// A step that fails half way leaves the state where it got to, with the derivatives of that state.
TEST(Simulation, FailsHalfWayAtTheLastGoodState) {
  const TestScene scene = SwingingCloth(4, 0.3);
  SimulationOptions options;
  options.max_halvings = 2;
  Simulation simulation = MakeSimulation(scene, options);
  State state = Simulate(scene, 3, &simulation);
  const double start = state.time;
  const Drive breaks = [&](double time, bool) {
    StepInputs inputs = scene.MakeDrive()(time, false);
    if (time > start + 0.6 * kStep) inputs.handles[0].position.x() = std::nan("");
    return inputs;
  };
  Sensitivity none;
  const StepReport report = simulation.Advance(kStep, breaks, &state, &none);
  EXPECT_EQ(report.status, StepStatus::kDiverged);
  EXPECT_EQ(report.halvings, 2);
  EXPECT_NEAR(state.time, start + 0.5 * kStep, 1e-15);
  EXPECT_TRUE(state.x.allFinite());
  // It goes on from there once the handle is back.
  EXPECT_EQ(simulation.Advance(kStep, scene.MakeDrive(), &state, &none).status,
            StepStatus::kConverged);
}

TEST(Simulation, HalvingsAreReported) {
  const TestScene scene = SwingingCloth(6, 0.3);
  SimulationOptions options;
  options.max_newton_iterations = 4;
  Simulation simulation = MakeSimulation(scene, options);
  State state = simulation.MakeState(scene.x);
  const Drive jump = [&](double time, bool) {
    StepInputs inputs = scene.MakeDrive()(time, false);
    inputs.handles[0].position.z() += 0.05;
    return inputs;
  };
  const StepReport report = simulation.Advance(kStep, jump, &state);
  EXPECT_EQ(report.status, StepStatus::kConverged);
  EXPECT_GT(report.halvings, 0);
  EXPECT_NEAR(state.time, kStep, 1e-18);
}

// Halving is the last resort: it makes another, if no worse, motion, and a motion that jumps as its
// parameters change cannot be fitted. Here the cloth swings through and crumples.
TEST(Simulation, SwingsThroughWithoutHalvings) {
  const TestScene scene = SwingingCloth(9, 0.3);
  for (int k = 0; k < 4; ++k) {
    Simulation simulation = MakeSimulation(scene);
    State state = simulation.MakeState(scene.x);
    for (Eigen::Index i = 0; i < state.v.size(); ++i)
      state.v[i] = 1e-4 * std::sin(static_cast<double>(i * i + k));
    StepReport total;
    for (int i = 0; i < 60; ++i) total += simulation.Advance(kStep, scene.MakeDrive(), &state);
    EXPECT_EQ(total.status, StepStatus::kConverged);
    EXPECT_EQ(total.halvings, 0);
  }
}

// At rest the handles carry the weight, each its share, straight up.
TEST(Simulation, HandlesCarryTheWeight) {
  TestScene scene = SwingingCloth(6, 0.3);
  scene.handles = LocateOnCloth(scene.mesh, {{0.02, 0.03}, {0.3, 0.0}});  // one inside a triangle
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, 0.3}, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
  const std::vector<Eigen::Vector3d> places = {scene.handles[0].At(scene.x),
                                               scene.handles[1].At(scene.x)};
  scene.path = [places](double) { return places; };
  SimulationOptions options;
  options.integrator = Integrator::kBackwardEuler;  // forgets its motion sooner
  Simulation simulation = MakeSimulation(scene, options);
  Eigen::VectorXd parameters = simulation.parameters();
  const auto& table = simulation.model().parameters();
  parameters[RequireParameter(table, "air_drag.tangential")] = 1.0;
  simulation.SetParameters(parameters);
  State state = simulation.MakeState(scene.x);
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(simulation.Advance(0.1, scene.MakeDrive(), &state).status, StepStatus::kConverged);
  }
  ASSERT_LE(state.v.lpNorm<Eigen::Infinity>(), 1e-6);
  const Eigen::Map<const Eigen::Matrix3Xd> forces(simulation.handle_forces().data(), 3,
                                                  scene.mesh.num_particles());
  const double weight = 0.15 * 0.09 * 9.81;
  const Eigen::Vector3d net = forces.rowwise().sum();
  // What is left of the motion: 1e-6 m/s resisted by 1 kg/(m^2 s) over 0.09 m^2.
  EXPECT_NEAR(net.z(), weight, 1e-6 * weight);
  EXPECT_NEAR(net.x(), 0.0, 1e-6 * weight);
  EXPECT_NEAR(net.y(), 0.0, 1e-6 * weight);
  int held = 0;
  for (Eigen::Index i = 0; i < forces.cols(); ++i) {
    if (forces.col(i).norm() > 0.0) ++held;
  }
  EXPECT_EQ(held, 4);  // the three of the inner handle's triangle, and the corner
}

TEST(Simulation, DerivativesTakeNoMoreMemoryAsTimeGoesOn) {
  const TestScene scene = SwingingCloth(4, 0.3);
  Simulation simulation = MakeSimulation(scene);
  State state = simulation.MakeState(scene.x);
  Sensitivity sensitivity(state, Eigen::MatrixXd::Identity(simulation.parameters().size(), 11));
  const auto size = [&] {
    Eigen::Index numbers = 0;
    for (const StateLanes& lanes : sensitivity.lanes()) {
      numbers += lanes.x.size() + lanes.v.size() + lanes.memory.size() + lanes.previous_x.size() +
                 lanes.previous_v.size();
    }
    return numbers;
  };
  const Eigen::Index before = size();
  // 11 directions are two blocks of lanes.
  EXPECT_EQ(before, 2 * (4 * 48 + simulation.model().memory_size()) * kLanes);
  for (int i = 0; i < 20; ++i) simulation.Advance(kStep, scene.MakeDrive(), &state, &sensitivity);
  EXPECT_EQ(size(), before);
  EXPECT_EQ(sensitivity.x().cols(), 11);
}

// Derivatives along so many directions that they go in several blocks, some of which move nothing
// at first: the same numbers whoever computes them.
TEST(Simulation, DerivativesAreTheSameForAnyNumberOfThreads) {
  const TestScene scene = SwingingCloth(7, 0.4);
  constexpr int kDirections = 30, kSteps = 20;
  const auto run = [&](int num_threads) {
    SimulationOptions options;
    options.num_threads = num_threads;
    Simulation simulation(scene.mesh, scene.world, scene.handles, options);
    UseSuppleCloth(&simulation);
    State state = simulation.MakeState(scene.x);
    Eigen::MatrixXd parameters = Eigen::MatrixXd::Zero(simulation.parameters().size(), kDirections);
    parameters(kArealDensity, 0) = 1.0;
    Sensitivity sensitivity(state, parameters);
    const Drive known = scene.MakeDrive();
    const Drive drive = [&](double time, bool with_directions) {
      StepInputs inputs = known(time, with_directions);
      inputs.directions.setZero(inputs.num_rows(), kDirections);
      // Directions from the second on begin one step after the other.
      for (int d = 1; d < kDirections; ++d) {
        if (time > (d - 0.5) / 120.0) inputs.directions(d % inputs.num_rows(), d) = 1.0;
      }
      return inputs;
    };
    for (int k = 0; k < kSteps; ++k) {
      EXPECT_EQ(simulation.Advance(1.0 / 120.0, drive, &state, &sensitivity).status,
                StepStatus::kConverged);
    }
    return sensitivity.x();
  };
  const Eigen::MatrixXd alone = run(1), together = run(3);
  EXPECT_EQ((alone - together).lpNorm<Eigen::Infinity>(), 0.0);
  EXPECT_GT(alone.col(kSteps - 2).norm(), 0.0);
  EXPECT_EQ(alone.rightCols(kDirections - kSteps - 1).norm(), 0.0);
}

}  // namespace
}  // namespace clothfit
