// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of whole rollouts against differences: everything that can move a rollout, through
// 120 steps.
#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/rollout.h"
#include "tests/autodiff_sim/terms/catalogue_cases.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

GradientCheckOptions Options() {
  GradientCheckOptions options;
  options.tolerance = 1e-5;
  options.first_step = 5e-3;
  options.sufficient = 0.3;
  return options;
}

// Moves handle `which` along an axis with sin^2 of the time, from rest.
Direction MoveHandle(int which, int axis) {
  Direction direction;
  direction.name = "handle " + std::to_string(which) + " axis " + std::to_string(axis);
  direction.typical = 0.05;
  direction.inputs = [which, axis](double time, const StepInputs& inputs) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(inputs.num_rows());
    if (which < static_cast<int>(inputs.handles.size()))
      d[3 * which + axis] = std::pow(std::sin(2.0 * time), 2);
    return d;
  };
  return direction;
}

// Moves the input that is `back` rows from the last (the first rows go away with their handles).
Direction MoveInput(const std::string& name, int back) {
  Direction direction;
  direction.name = name;
  direction.typical = 0.05;
  direction.inputs = [back](double time, const StepInputs& inputs) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(inputs.num_rows());
    d[inputs.num_rows() - back] = 1.0 + std::cos(3.0 * time);
    return d;
  };
  return direction;
}

// Initial positions or velocities, along random numbers of up to 1 a particle and axis; held
// particles are where their handles are whatever their initial position.
Direction MoveInitial(const std::string& name, Eigen::VectorXd Direction::*part, double typical,
                      Eigen::Index size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  Direction direction;
  direction.name = name;
  direction.typical = typical;
  (direction.*part).resize(size);
  for (double& value : direction.*part) value = one(random);
  return direction;
}

void AddInitial(Rollout* rollout) {
  const Eigen::Index size = rollout->x.size();
  rollout->directions.push_back(MoveInitial("initial x", &Direction::dx, 1e-3, size));
  rollout->directions.push_back(MoveInitial("initial v", &Direction::dv, 1e-2, size));
}

Rollout Swing(int n, Integrator integrator) {
  Rollout rollout = MakeRollout(SwingingCloth(n, 0.3), Precise(integrator));
  Set("air_drag.saturation", 0.1, &rollout);
  Set("added_mass.normal", 0.03, &rollout);
  return rollout;
}

// All parameters, by the rollout in which they act.
const std::vector<std::string> kOfTheCloth = {
    "cloth.areal_density", "cloth.shrink_warp", "cloth.shrink_weft", "gravity.scale",
    "stretch.stiffness",   "stretch.damping",   "shear.stiffness",   "shear.damping",
    "bending.stiffness",   "bending.damping",   "air_drag.normal",   "air_drag.saturation",
    "air_drag.tangential", "added_mass.normal"};
const std::vector<std::string> kOfTheGround = {"ground.stiffness", "ground.friction",
                                               "ground.damping", "ground.distance",
                                               "ground.slip_speed"};
const std::vector<std::string> kOfTheTargets = {
    "attraction_point.linear",  "attraction_point.reciprocal", "attraction_point.radius",
    "attraction_ray.linear",    "attraction_ray.reciprocal",   "attraction_ray.radius",
    "attraction_point.damping", "attraction_ray.damping"};

// In contact_derivative_test.cc.
const std::vector<std::string> kOfTheContact = {"contact.stiffness", "contact.thickness",
                                                "contact.friction", "contact.slip_speed"};

// In obstacle_contact_test.cc, obstacle_change_test.cc and residual_force_term_test.cc.
const std::vector<std::string> kOfObstaclesAndForces = {
    "obstacle.stiffness",  "obstacle.thickness", "obstacle.friction",
    "obstacle.slip_speed", "obstacle.shift_x",   "obstacle.shift_y",
    "obstacle.shift_z",    "obstacle.growth",    "residual_force.share"};

// Those of the terms that are off unless asked for stand in catalogue_rollout_test.cc.
TEST(RolloutDerivative, OfEveryParameterThatActsByItself) {
  const std::vector<std::string> catalogue = CatalogueTerms();
  std::vector<std::string> checked = kOfTheCloth;
  checked.insert(checked.end(), kOfTheGround.begin(), kOfTheGround.end());
  checked.insert(checked.end(), kOfTheTargets.begin(), kOfTheTargets.end());
  checked.insert(checked.end(), kOfTheContact.begin(), kOfTheContact.end());
  checked.insert(checked.end(), kOfObstaclesAndForces.begin(), kOfObstaclesAndForces.end());
  std::vector<std::string> names;
  for (const NamedParameter& p : MakeParameterTable()) {
    names.push_back(p.name);
    if (std::find(catalogue.begin(), catalogue.end(), p.term) == catalogue.end()) {
      EXPECT_THAT(checked, ::testing::Contains(p.name));
    }
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf(checked));
}

TEST(RolloutDerivative, SwingingClothBdf2) {
  Rollout rollout = Swing(6, Integrator::kBdf2);
  rollout.AddParameters(kOfTheCloth);
  rollout.directions.push_back(MoveHandle(0, 0));
  rollout.directions.push_back(MoveHandle(1, 2));
  AddInitial(&rollout);
  ExpectDerivatives(rollout, Options());
}

TEST(RolloutDerivative, SwingingClothBackwardEuler) {
  Rollout rollout = Swing(5, Integrator::kBackwardEuler);
  rollout.AddParameters({"cloth.areal_density", "stretch.stiffness", "shear.damping",
                         "bending.damping", "air_drag.normal"});
  rollout.directions.push_back(MoveHandle(1, 1));
  AddInitial(&rollout);
  ExpectDerivatives(rollout, Options());
}

// Everything at once, on a finer cloth: one direction that moves all of it.
TEST(RolloutDerivative, FinerCloth) {
  Rollout rollout = Swing(9, Integrator::kBdf2);
  Direction all = MoveHandle(0, 1);
  const Eigen::Index size = rollout.x.size();
  all.name = "handle and initial state";
  all.typical = 0.01;
  all.dx = 0.01 * MoveInitial("", &Direction::dx, 1.0, size).dx;
  all.dv = MoveInitial("", &Direction::dv, 1.0, size).dv;
  all.parameter = RequireParameter(rollout.make().model().parameters(), "air_drag.normal");
  rollout.directions = {all};
  ExpectDerivatives(rollout, Options());
}

TEST(RolloutDerivative, ClothLiftedFromTheGround) {
  Rollout rollout = MakeRollout(LiftedCloth(5, 0.3), Precise(Integrator::kBdf2));
  Set("ground.damping", 1e4, &rollout);
  rollout.AddParameters({"ground.stiffness", "ground.friction", "ground.damping", "ground.distance",
                         "ground.slip_speed", "cloth.areal_density"});
  rollout.directions.push_back(MoveHandle(0, 0));
  rollout.directions.push_back(MoveHandle(0, 2));
  // Not the initial state, of which the ground leaves so little after a second that differences
  // drown in what the solver leaves of a step; the dropped cloth below shows it.
  // Creeping on the ground adds up what the solver leaves of each step, 1e-12 of an edge, so that
  // differences of ground.damping, which does least, are good to about 5e-5 only.
  GradientCheckOptions options = Options();
  options.tolerance = 5e-5;
  ExpectDerivatives(rollout, options, 1);
}

TEST(RolloutDerivative, ClothThatBucklesBelowItsMesh) {
  TestScene scene = LiftedCloth(5, 0.3);
  scene.mesh.buckles = true;
  Rollout rollout = MakeRollout(scene, Precise(Integrator::kBdf2));
  rollout.step = 0.004;  // so that no step is halved
  rollout.steps = 250;
  rollout.AddParameters({"stretch.stiffness", "stretch.damping", "shear.stiffness", "shear.damping",
                         "bending.stiffness", "cloth.areal_density"});
  rollout.directions.push_back(MoveHandle(0, 2));
  GradientCheckOptions options = Options();
  options.tolerance = 5e-5;  // as of the lifted cloth above
  ExpectDerivatives(rollout, options, 1);
}

// Falls to the ground and slides on it.
TEST(RolloutDerivative, ClothDroppedOnTheGround) {
  TestScene scene = LiftedCloth(5, 0.3);
  scene.handles.clear();
  scene.x = LayFlat(scene.mesh, {0.0, 0.0, 0.05}, Eigen::Vector3d::UnitX(),
                    Eigen::Vector3d(0.0, 0.98, 0.2));
  Rollout rollout = MakeRollout(scene, Precise(Integrator::kBackwardEuler));
  for (Eigen::Index i = 0; i < rollout.v.size(); i += 3) rollout.v[i] = 0.6;
  rollout.AddParameters({"ground.stiffness", "ground.friction", "gravity.scale"});
  AddInitial(&rollout);
  ExpectDerivatives(rollout, Options());
}

// A cloth drawn to points and rays that move, held at a point inside a triangle until half way.
Rollout Attracted() {
  TestScene scene = SwingingCloth(5, 0.3);
  scene.handles = LocateOnCloth(scene.mesh, {{0.027, 0.046}, {0.3, 0.0}});
  Rollout rollout = MakeRollout(scene, Precise(Integrator::kBdf2));
  const std::vector<SurfacePoint> targets =
      LocateOnCloth(scene.mesh, {{0.1, 0.21}, {0.25, 0.28}, {0.17, 0.13}, {0.05, 0.3}});
  const Eigen::Vector3d inside = scene.handles[0].At(scene.x),
                        corner = scene.handles[1].At(scene.x);
  rollout.inputs = [scene, targets, inside, corner](double time) {
    StepInputs inputs;
    const Eigen::Vector3d move(0.1 * time * time, 0.0, 0.05 * time * time);
    inputs.handles.push_back({scene.handles[1], corner - move});
    if (time < 0.5) inputs.handles.push_back({scene.handles[0], inside + move});
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d target = targets[i].At(scene.x) + Eigen::Vector3d(0.03, 0.02, -0.1);
      inputs.points.push_back(
          {targets[i], target + move, Eigen::Vector3d(0.2 * time, 0.0, 0.1 * time)});
      const Eigen::Vector3d direction = Eigen::Vector3d(0.2 * i, 1.0, 0.1 + time).normalized();
      const Eigen::Vector3d on_ray = targets[2 + i].At(scene.x) - Eigen::Vector3d(0.02, 0.0, 0.05);
      const Eigen::Vector3d turning = (Eigen::Vector3d::UnitZ() - direction.z() * direction) /
                                      Eigen::Vector3d(0.2 * i, 1.0, 0.1 + time).norm();
      inputs.rays.push_back({targets[2 + i], direction, on_ray.cross(direction),
                             RayTarget::Rates{turning, on_ray.cross(turning)}});
    }
    return inputs;
  };
  for (const char* term : {"attraction_point", "attraction_ray"}) {
    Set(std::string(term) + ".linear", 2.0, &rollout);
    Set(std::string(term) + ".reciprocal", 1e-4, &rollout);
    Set(std::string(term) + ".radius", 0.03, &rollout);
    Set(std::string(term) + ".damping", 0.1, &rollout);
  }
  return rollout;
}

TEST(RolloutDerivative, AttractionAndAReleasedHandleInsideATriangle) {
  Rollout rollout = Attracted();
  rollout.AddParameters(kOfTheTargets);
  rollout.directions.push_back(MoveHandle(0, 1));
  rollout.directions.push_back(MoveHandle(1, 2));
  // Two points, 6 rows, then two rays, 12 rows.
  rollout.directions.push_back(MoveInput("first point, y", 17));
  rollout.directions.push_back(MoveInput("second point, z", 13));
  rollout.directions.push_back(MoveInput("first ray, direction z", 10));
  rollout.directions.push_back(MoveInput("second ray, moment x", 3));
  AddInitial(&rollout);
  GradientCheckOptions options = Options();
  options.first_step = 5e-2;
  ExpectDerivatives(rollout, options);
}

// Handles that jump: the steps fail, and are made as shorter ones. Differences are those of
// rollouts halved alike.
TEST(RolloutDerivative, HalvedSteps) {
  SimulationOptions options = Precise(Integrator::kBdf2);
  options.max_newton_iterations = 8;
  Rollout rollout = MakeRollout(SwingingCloth(5, 0.3), options);
  const auto gentle = rollout.inputs;
  rollout.inputs = [gentle](double time) {
    StepInputs inputs = gentle(time);
    if (time > 0.3) inputs.handles[1].position.z() += 0.1;
    return inputs;
  };
  rollout.steps = 60;
  rollout.AddParameters({"stretch.stiffness", "air_drag.normal", "cloth.areal_density"});
  rollout.directions.push_back(MoveHandle(1, 1));
  AddInitial(&rollout);
  const RolloutResult base = RunRollout(rollout, Eigen::VectorXd::Zero(6), false);
  ASSERT_TRUE(base.converged);
  EXPECT_GT(base.report.halvings, 0);
  GradientCheckOptions check = Options();
  check.first_step = 1e-4;  // so small that the halvings are the same
  ExpectDerivatives(rollout, check, 1);
}

}  // namespace
}  // namespace clothfit
