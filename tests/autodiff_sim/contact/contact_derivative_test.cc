// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of rollouts whose cloth is in contact with itself, against differences. Where a pair
// of features begins to be closest at another of their parts the forces have a kink, so that a step
// of the differences is exact only if no pair changes over within it: their first step is small.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/scenes/contact_scenes.h"
#include "tests/autodiff_sim/step/rollout.h"

namespace clothfit {
namespace {

SimulationOptions Precise() {
  SimulationOptions options;
  options.tolerance = 1e-12;  // of the mean edge, so that differences of small steps are no noise
  options.self_contact = true;
  return options;
}

GradientCheckOptions Options() {
  GradientCheckOptions options;
  options.tolerance = 1e-5;
  options.first_step = 1e-4;
  options.sufficient = 0.3;
  return options;
}

Rollout MakeRollout(const TestScene& scene, int steps) {
  Rollout rollout;
  rollout.make = [scene]() {
    Simulation simulation(scene.mesh, scene.world, scene.handles, Precise());
    UseSuppleCloth(&simulation);
    return simulation;
  };
  rollout.parameters = rollout.make().parameters();
  rollout.x = scene.x;
  rollout.v = Eigen::VectorXd::Zero(scene.x.size());
  const Drive drive = scene.handles.empty() ? FreeDrive() : scene.MakeDrive();
  rollout.inputs = [drive](double time) { return drive(time, false); };
  rollout.steps = steps;
  return rollout;
}

const std::vector<std::string> kContact = {"contact.stiffness", "contact.thickness",
                                           "contact.friction", "contact.slip_speed"};

// Whether the rollout as given is in contact at its end.
void ExpectContact(const Rollout& rollout, int pairs) {
  const RolloutResult result = RunRollout(
      rollout, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rollout.directions.size())), false);
  ASSERT_TRUE(result.converged);
  EXPECT_GE(result.report.contact_pairs, pairs);
}

// Moves the particles off the lattice, so that no vertex is just above an edge.
void Distort(Eigen::VectorXd* x) {
  for (Eigen::Index i = 0; i < x->size(); i += 3) {
    (*x)[i] += 0.003 * std::sin(40.0 * (*x)[i + 1] + 300.0 * (*x)[i + 2]);
    (*x)[i + 1] += 0.004 * std::sin(25.0 * (*x)[i] + 500.0 * (*x)[i + 2]);
  }
}

TEST(ContactDerivative, LayersThatSlide) {
  Rollout rollout = MakeRollout(FoldedCloth(5, 0.2, 0.0019), 24);
  Distort(&rollout.x);
  rollout.AddParameters(kContact);
  rollout.AddParameters({"gravity.scale", "stretch.stiffness", "ground.friction"});
  ExpectContact(rollout, 20);
  ExpectDerivatives(rollout, Options());
}

TEST(ContactDerivative, LayersThrownTogether) {
  TestScene scene = FoldedCloth(5, 0.2, 0.006);
  scene.handles.clear();
  Rollout rollout = MakeRollout(scene, 20);
  Distort(&rollout.x);
  Direction faster;
  faster.name = "initial v";
  faster.typical = 0.1;
  faster.dv = Eigen::VectorXd::Zero(rollout.v.size());
  for (Eigen::Index i = 0; i < rollout.v.size(); i += 3) {
    if (rollout.x[i + 2] < 0.004) continue;
    rollout.v.segment<3>(i) << 0.3, 0.1, -0.5;
    faster.dv.segment<3>(i) << 1.0, -0.5, -1.0;
  }
  rollout.directions.push_back(faster);
  // The slip speed does little where layers slide fast.
  rollout.AddParameters({"contact.stiffness", "contact.thickness", "contact.friction"});
  rollout.AddParameters({"gravity.scale", "bending.stiffness", "air_drag.normal"});
  ExpectContact(rollout, 20);
  GradientCheckOptions options = Options();
  options.first_step = 1e-3;
  ExpectDerivatives(rollout, options);
}

}  // namespace
}  // namespace clothfit
