// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A cloth stays outside obstacles, at rest and on the move, and feels them as it should.
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/obstacle_contacts.h"
#include "autodiff_sim/contact/proximity.h"
#include "autodiff_sim/scenes/contact_scenes.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/step/rollout.h"

namespace clothfit {
namespace {

Simulation MakeWatchedSimulation(const TestScene& scene, bool self_contact) {
  SimulationOptions options;
  options.self_contact = self_contact;
  options.check_intersections = true;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  return simulation;
}

// Every step converges and leaves the cloth outside all there is.
StepReport ExpectClearOfObstacles(const TestScene& scene, int steps, bool self_contact) {
  Simulation simulation = MakeWatchedSimulation(scene, self_contact);
  State state = simulation.MakeState(scene.x);
  simulation.CheckStart(state);
  const bool alone = scene.handles.empty();
  const Drive drive = alone ? FreeDrive() : scene.MakeDrive();
  const double energy = Total(simulation.Energies(state));
  StepReport total;
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.Advance(kStep, drive, &state);
    EXPECT_EQ(report.status, StepStatus::kConverged) << "step " << i;
    EXPECT_EQ(report.intersections, 0) << "step " << i;
    if (report.status != StepStatus::kConverged) return report;
    // No obstacle moves where nothing holds the cloth.
    if (alone) {
      EXPECT_LE(Total(simulation.Energies(state)), energy) << "step " << i;
    }
    total += report;
  }
  return total;
}

TEST(ObstacleContact, ClothOverABallStaysClear) {
  EXPECT_GT(ExpectClearOfObstacles(ClothOverBall(13, 0.4), 80, true).most_obstacle_contacts, 30);
}

TEST(ObstacleContact, ClothDrawnOverABarStaysClear) {
  EXPECT_GT(ExpectClearOfObstacles(ClothOverBar(13, 0.4), 130, true).most_obstacle_contacts, 30);
}

TEST(ObstacleContact, BoxThatRunsIntoTheClothStaysOutside) {
  const StepReport report = ExpectClearOfObstacles(BoxIntoCloth(13, 0.4), 90, true);
  EXPECT_GT(report.most_obstacle_contacts, 10);
  EXPECT_GT(report.limited_iterates, 0);
}

// Without self-contact obstacles act all the same.
TEST(ObstacleContact, ActsByItself) {
  const TestScene scene = BoxIntoCloth(9, 0.4);
  Simulation simulation = MakeWatchedSimulation(scene, false);
  State state = simulation.MakeState(scene.x);
  for (int i = 0; i < 60; ++i) {
    ASSERT_EQ(simulation.Advance(kStep, scene.MakeDrive(), &state).status, StepStatus::kConverged);
    ASSERT_EQ(simulation.CountObstacleIntersections(state.x, state.time), 0);
  }
}

// The scenes are hard: where obstacles are off, the cloth goes through them.
TEST(ObstacleContact, TheScenesNeedIt) {
  for (const TestScene& scene : {ClothOverBall(13, 0.4), BoxIntoCloth(11, 0.4)}) {
    Simulation simulation = MakeWatchedSimulation(scene, false);
    Set("obstacle.stiffness", 0.0, &simulation);
    State state = simulation.MakeState(scene.x);
    const Drive drive = scene.handles.empty() ? FreeDrive() : scene.MakeDrive();
    int intersections = 0;
    for (int i = 0; i < 60 && intersections == 0; ++i)
      intersections = simulation.Advance(kStep, drive, &state).intersections;
    EXPECT_GT(intersections, 0);
  }
}

// However hard it falls, cloth that keeps clear of itself stays above the ground.
TEST(ObstacleContact, GroundGivesWayByNoMoreThanItsDistance) {
  TestScene scene;
  scene.mesh = MakeGrid({0.2, 0.2}, {5, 5});
  scene.world.ground_height = 0.1;
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, 0.11}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  for (const bool self_contact : {true, false}) {
    Simulation simulation = MakeWatchedSimulation(scene, self_contact);
    Set("ground.stiffness", 3e3, &simulation);
    State state = simulation.MakeState(scene.x);
    for (Eigen::Index i = 2; i < state.v.size(); i += 3) state.v[i] = -6.0;
    double lowest = 1.0;
    for (int i = 0; i < 20; ++i) {
      ASSERT_EQ(simulation.Advance(kStep, FreeDrive(), &state).status, StepStatus::kConverged);
      for (Eigen::Index k = 2; k < state.x.size(); k += 3) lowest = std::min(lowest, state.x[k]);
    }
    EXPECT_EQ(lowest > 0.1, self_contact) << lowest;
  }
}

// A small cloth on a wide box, whose velocity (m/s) along x after 0.2 s under gravity that leans.
double SlideOnBox(double lean, double friction, double box_speed) {
  TestScene scene;
  scene.mesh = MakeGrid({0.06, 0.06}, {3, 3});
  scene.x = LayFlat(scene.mesh, {0.013, 0.029, 0.0018}, {0.96, 0.28, 0.0}, {-0.28, 0.96, 0.0});
  scene.world.gravity = {9.81 * lean, 0.0, -9.81};
  auto box = std::make_shared<Obstacle>(MakeBoxObstacle({2.0, 2.0, 0.5}));
  RigidPose before, after;
  before.origin_in_world = {0.0, 0.0, -0.5};
  after.origin_in_world = {box_speed, 0.0, -0.5};
  box->path = {before, after};
  box->frame_rate = 1.0;
  scene.world.obstacles = {box};
  Simulation simulation = MakeWatchedSimulation(scene, false);
  KeepOnly({"gravity", "stretch", "shear", "bending", "obstacle"}, &simulation);
  Set("obstacle.friction", friction, &simulation);
  Set("obstacle.slip_speed", 1e-4, &simulation);
  State state = simulation.MakeState(scene.x);
  for (Eigen::Index i = 0; i < state.v.size(); i += 3) state.v[i] = box_speed;
  for (int i = 0; i < 24; ++i) {
    EXPECT_EQ(simulation.Advance(kStep, FreeDrive(), &state).status, StepStatus::kConverged);
  }
  double sum = 0.0;
  for (Eigen::Index i = 0; i < state.v.size(); i += 3) sum += state.v[i];
  return sum / scene.mesh.num_particles();
}

// Coulomb, as between layers: below mu it sticks, to a box that moves too; above it slides.
TEST(ObstacleContact, FrictionHoldsAndSlidesAsCoulombSays) {
  const double time = 24 * kStep;
  EXPECT_LE(std::abs(SlideOnBox(0.2, 0.3, 0.0)), 1e-4);
  EXPECT_NEAR(SlideOnBox(0.2, 0.3, 0.5), 0.5, 1e-4);
  for (const double friction : {0.0, 0.1, 0.3}) {
    EXPECT_NEAR(SlideOnBox(0.5, friction, 0.0), 9.81 * (0.5 - friction) * time,
                0.02 * 9.81 * 0.5 * time);
  }
}

// What the list gives is what looking at all pairs gives, wherever the cloth has gone since, and
// what is called free is free.
TEST(ObstacleContact, ListIsThatOfAllPairs) {
  TestScene scene = BoxIntoCloth(7, 0.4);
  auto ball = std::make_shared<Obstacle>(MakeBall(0.05));
  auto bar = std::make_shared<Obstacle>(MakeBar(0.03, 0.1));
  ball->path[0].origin_in_world = {0.1, 0.08, 0.25};
  bar->path[0].origin_in_world = {0.3, 0.07, 0.1};
  scene.world.obstacles.push_back(ball);
  scene.world.obstacles.push_back(bar);
  ObstacleContacts followed(scene.mesh, scene.world.obstacles, -0.003);
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0.0, 1e-3);
  Eigen::VectorXd x = scene.x;
  int found = 0, stopped = 0;
  for (int step = 0; step < 60; ++step) {
    followed.BeginStep(step * kStep, (step + 1) * kStep);
    for (int iterate = 0; iterate < 3; ++iterate) {
      Eigen::VectorXd next = x;
      for (Eigen::Index i = 0; i < next.size(); ++i)
        next[i] += normal(random) + (i % 3 == 1 ? 5e-4 : 0.0);
      if (iterate == 0) followed.Prepare(x, next, 0.004);
      ObstacleContacts fresh(scene.mesh, scene.world.obstacles, -0.003);
      fresh.BeginStep(step * kStep, (step + 1) * kStep);
      const auto arrived = ObstacleContacts::Obstacles::kArrived;
      // The box comes over the cloth, which does not yield here; what was clear stays so.
      const bool was_clear = fresh.CountIntersections(x) == 0;
      const double share = followed.FreeShare(x, next, 0.004, arrived);
      EXPECT_NEAR(share, fresh.FreeShare(x, next, 0.004, arrived), 1e-12);
      stopped += was_clear && share < 1.0;
      x += share * (next - x);
      if (was_clear) {
        EXPECT_EQ(fresh.CountIntersections(x), 0) << "step " << step;
      }
      fresh.Forget();
      const std::vector<ObstacleContact> all = fresh.Find(x, 0.004, 5e-4);
      const std::vector<ObstacleContact>& listed = followed.Find(x, 0.004, 5e-4);
      ASSERT_EQ(listed.size(), all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(listed[i].nodes, all[i].nodes);
        EXPECT_EQ(listed[i].kind, all[i].kind);
      }
      found += static_cast<int>(all.size());
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(stopped, 5);
}

TEST(ObstacleContact, RefusesToStartInside) {
  const auto message = [](const TestScene& scene) {
    const Simulation simulation = MakeWatchedSimulation(scene, true);
    try {
      simulation.CheckStart(simulation.MakeState(scene.x));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  TestScene scene = ClothOverBall(9, 0.4);
  EXPECT_EQ(message(scene), "none");
  Eigen::VectorXd lower = scene.x;
  for (Eigen::Index i = 2; i < lower.size(); i += 3) lower[i] = 0.11;
  std::swap(scene.x, lower);
  EXPECT_THAT(message(scene), testing::HasSubstr("obstacles: ball: the cloth is in it"));
  std::swap(scene.x, lower);
  scene.world.ground_height = 0.3;
  EXPECT_THAT(message(scene), testing::HasSubstr("ground.height: the cloth is in it"));
  // Wholly within a box no surfaces meet.
  scene.world.ground_height.reset();
  scene.world.obstacles = {std::make_shared<Obstacle>(MakeBoxObstacle({2.0, 2.0, 2.0}))};
  EXPECT_THAT(message(scene), testing::HasSubstr("the cloth is in it"));
  // Under a board, and within what stands under it.
  for (const double below : {0.0, 3.0}) {
    auto table = std::make_shared<Obstacle>(MakeBoxObstacle({2.0, 2.0, 0.05}, below));
    table->path[0].origin_in_world.z() = 1.0;
    scene.world.obstacles = {table};
    EXPECT_EQ(message(scene) == "none", below == 0.0);
  }
}

SimulationOptions PreciseOptions() {
  SimulationOptions options;
  options.tolerance = 1e-13;
  return options;
}

// The state and the obstacle's parameters, through a rollout in contact, against differences.
void ExpectRolloutDerivatives(const TestScene& scene, int steps, bool is_fast, int contacts = 3,
                              int undecided = 0) {
  Rollout rollout = MakeRollout(scene, PreciseOptions());
  rollout.steps = steps;
  if (scene.handles.empty()) rollout.inputs = [](double) { return StepInputs(); };
  if (is_fast) {
    for (Eigen::Index i = 2; i < rollout.v.size(); i += 3) rollout.v[i] = -1.0;
  }
  rollout.directions.clear();
  rollout.AddParameters({"obstacle.stiffness", "obstacle.thickness", "obstacle.friction"});
  rollout.AddParameters({"obstacle.slip_speed", "gravity.scale", "stretch.stiffness"});
  rollout.AddParameters({"bending.stiffness"});
  const Eigen::VectorXd still =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rollout.directions.size()));
  const RolloutResult result = RunRollout(rollout, still, false);
  ASSERT_TRUE(result.converged);
  EXPECT_GE(result.report.most_obstacle_contacts, contacts);
  GradientCheckOptions options;
  options.tolerance = 1e-5;
  options.first_step = 1e-4;
  options.sufficient = 0.3;
  ExpectDerivatives(rollout, options, undecided);
}

TEST(ObstacleContact, DerivativesOnABall) {
  ExpectRolloutDerivatives(ClothOverBall(7, 0.3), 14, true);
}

TEST(ObstacleContact, DerivativesWithABallOnTheMove) {
  TestScene scene = BoxIntoCloth(5, 0.3);
  auto ball = std::make_shared<Obstacle>(MakeBall(0.04));
  ball->path = scene.world.obstacles[0]->path;
  ball->frame_rate = scene.world.obstacles[0]->frame_rate;
  scene.world.obstacles = {ball};
  ExpectRolloutDerivatives(scene, 36, false, 1);  // one triangle meets the ball
}

// Where edges and corners of a box are closest, other pairs are about to be, and differences are
// less exact: of the two directions of friction they tell no more than that they agree within their
// own error. On a ball they decide both.
TEST(ObstacleContact, DerivativesWithABoxOnTheMove) {
  ExpectRolloutDerivatives(BoxIntoCloth(5, 0.3), 36, false, 3, 2);
}

}  // namespace
}  // namespace clothfit
