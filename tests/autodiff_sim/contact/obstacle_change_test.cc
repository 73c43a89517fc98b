// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Obstacles that stand a little elsewhere, by parameters: as if the scene had placed them there.
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/scenes/contact_scenes.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/step/rollout.h"

namespace clothfit {
namespace {

const Eigen::Vector3d kMoved(0.004, -0.003, -0.004);  // m
constexpr double kThicker = 0.003;                    // m

// The scene's only obstacle as the parameters would place it.
TestScene WithObstacleElsewhere(TestScene scene) {
  auto obstacle = std::make_shared<Obstacle>(*scene.world.obstacles.at(0));
  for (RigidPose& pose : obstacle->path) pose.origin_in_world += kMoved;
  if (!obstacle->IsMesh()) obstacle->radius += kThicker;
  scene.world.obstacles = {obstacle};
  return scene;
}

Rollout RolloutOf(const TestScene& scene, int steps) {
  Rollout rollout = MakeRollout(scene, Precise(SimulationOptions().integrator));
  rollout.steps = steps;
  if (scene.handles.empty()) rollout.inputs = [](double) { return StepInputs(); };
  for (Eigen::Index i = 2; scene.handles.empty() && i < rollout.v.size(); i += 3)
    rollout.v[i] = -1.0;
  rollout.directions.clear();
  return rollout;
}

void PlaceElsewhere(Rollout* rollout) {
  Set("obstacle.shift_x", kMoved.x(), rollout);
  Set("obstacle.shift_y", kMoved.y(), rollout);
  Set("obstacle.shift_z", kMoved.z(), rollout);
  Set("obstacle.growth", kThicker, rollout);
}

void ExpectSameAsElsewhere(const TestScene& scene, int steps) {
  Rollout rollout = RolloutOf(scene, steps);
  const Rollout elsewhere = RolloutOf(WithObstacleElsewhere(scene), steps);
  const RolloutResult unchanged = RunRollout(rollout, Eigen::VectorXd(), false);
  PlaceElsewhere(&rollout);
  const RolloutResult changed = RunRollout(rollout, Eigen::VectorXd(), false);
  const RolloutResult expected = RunRollout(elsewhere, Eigen::VectorXd(), false);
  ASSERT_TRUE(changed.converged && expected.converged && unchanged.converged);
  EXPECT_GE(expected.report.most_obstacle_contacts, 1);
  EXPECT_LT((changed.values - expected.values).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT((changed.values - unchanged.values).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ObstacleChange, IsABallElsewhere) { ExpectSameAsElsewhere(ClothOverBall(6, 0.3), 14); }

TEST(ObstacleChange, IsABarElsewhere) { ExpectSameAsElsewhere(ClothOverBar(6, 0.3), 40); }

// Its radius is 0 and does not grow.
TEST(ObstacleChange, IsABoxOnTheMoveElsewhere) { ExpectSameAsElsewhere(BoxIntoCloth(5, 0.3), 36); }

TEST(ObstacleChange, DerivativesOnABall) {
  Rollout rollout = RolloutOf(ClothOverBall(6, 0.3), 14);
  PlaceElsewhere(&rollout);
  rollout.AddParameters({"obstacle.shift_x", "obstacle.shift_y", "obstacle.shift_z"});
  rollout.AddParameters({"obstacle.growth", "obstacle.stiffness"});
  GradientCheckOptions options;
  options.tolerance = 1e-5;
  options.first_step = 1e-4;
  options.sufficient = 0.3;
  ExpectDerivatives(rollout, options);
}

TEST(ObstacleChange, LeavesATenthOfABall) {
  EXPECT_EQ(GrownRadius(0.02, 0.01), 0.03);
  EXPECT_EQ(GrownRadius(0.02, -0.019), 0.1 * 0.02);
  EXPECT_EQ(GrownRadius(0.0, 0.01), 0.0);  // a mesh
}

// A place that was clear is not so for ever.
TEST(ObstacleChange, IntoTheClothIsNoStart) {
  const TestScene scene = ClothOverBall(6, 0.3);
  Simulation simulation(scene.mesh, scene.world, scene.handles,
                        Precise(SimulationOptions().integrator));
  UseSuppleCloth(&simulation);
  const State start = simulation.MakeState(scene.x);
  State state = start;
  EXPECT_EQ(simulation.Advance(kStep, FreeDrive(), &state).status, StepStatus::kConverged);
  Eigen::VectorXd parameters = simulation.parameters();
  const double gap = scene.x[2] - scene.world.obstacles[0]->path[0].origin_in_world.z() -
                     scene.world.obstacles[0]->radius;
  parameters[FindParameter(simulation.model().parameters(), "obstacle.shift_z")] = gap + 0.01;
  simulation.SetParameters(parameters);
  EXPECT_THROW(simulation.CheckStart(start), InputError);
  state = start;
  EXPECT_EQ(simulation.Advance(kStep, FreeDrive(), &state).status, StepStatus::kDiverged);
}

}  // namespace
}  // namespace clothfit
