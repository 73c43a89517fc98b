// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A cloth that gets into its own way never passes through itself, and contact keeps what it must.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/scenes/contact_scenes.h"
#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

Simulation MakeSimulation(const TestScene& scene, bool self_contact) {
  SimulationOptions options;
  options.self_contact = self_contact;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  return simulation;
}

// Every step converges, and none leaves the cloth through itself.
void ExpectClear(const TestScene& scene, int steps, int least_pairs) {
  Simulation simulation = MakeSimulation(scene, true);
  State state = simulation.MakeState(scene.x);
  const Drive drive = scene.handles.empty() ? FreeDrive() : scene.MakeDrive();
  StepReport total;
  int most_pairs = 0;
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.Advance(kStep, drive, &state);
    ASSERT_EQ(report.status, StepStatus::kConverged) << "step " << i;
    ASSERT_EQ(simulation.CountIntersections(state.x), 0) << "step " << i;
    most_pairs = std::max(most_pairs, report.contact_pairs);
    total += report;
  }
  EXPECT_GE(most_pairs, least_pairs);
  EXPECT_GT(total.pattern_rebuilds, 0);
}

TEST(SelfContact, DroppedClothStaysClear) { ExpectClear(DroppedCloth(15, 0.4), 60, 500); }
TEST(SelfContact, FoldedClothStaysClear) { ExpectClear(FoldedCloth(11, 0.3, 0.008), 90, 500); }
TEST(SelfContact, CornerDrawnOverStaysClear) { ExpectClear(CornerDrawnOver(15, 0.4), 150, 5); }

// The scenes are hard: without contact each passes through itself.
TEST(SelfContact, TheScenesNeedIt) {
  for (const TestScene& scene : {DroppedCloth(15, 0.4), FoldedCloth(11, 0.3, 0.008)}) {
    Simulation simulation = MakeSimulation(scene, false);
    State state = simulation.MakeState(scene.x);
    const Drive drive = scene.handles.empty() ? FreeDrive() : scene.MakeDrive();
    int intersections = 0;
    for (int i = 0; i < 60 && intersections == 0; ++i) {
      simulation.Advance(kStep, drive, &state);
      intersections = simulation.CountIntersections(state.x);
    }
    EXPECT_GT(intersections, 0);
  }
}

// What is far from contact moves as it does without, to the bit.
TEST(SelfContact, ChangesNothingWhereNothingMeets) {
  const TestScene scene = SwingingCloth(8, 0.3);
  Simulation with = MakeSimulation(scene, true), without = MakeSimulation(scene, false);
  State a = with.MakeState(scene.x), b = a;
  for (int i = 0; i < 10; ++i) {
    const StepReport report = with.Advance(kStep, scene.MakeDrive(), &a);
    without.Advance(kStep, scene.MakeDrive(), &b);
    ASSERT_EQ(report.contact_pairs, 0);
    ASSERT_EQ(report.pattern_rebuilds, 0);
  }
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
}

// The state after 60 steps in which the cloth goes through itself; contact must take no part.
State Dropped(Simulation* simulation, const TestScene& scene) {
  UseSuppleCloth(simulation);
  State state = simulation->MakeState(scene.x);
  StepReport total;
  for (int i = 0; i < 60; ++i) total += simulation->Advance(kStep, FreeDrive(), &state);
  EXPECT_EQ(total.status, StepStatus::kConverged);
  EXPECT_EQ(total.most_contact_pairs + total.most_obstacle_contacts, 0);
  EXPECT_EQ(total.limited_iterates + total.pattern_rebuilds, 0);
  return state;
}

// Switched off, contact leaves not a bit of a trace: a simulation is what it is without its terms,
// whatever their parameters, and with an obstacle that is off.
TEST(SelfContact, LeavesNoTraceWhereItIsOff) {
  const TestScene scene = DroppedCloth(9, 0.3);
  Simulation without = Simulation::WithTerms(
      TypeList<Gravity, StretchSpring, Shear, Bending, AirDrag, GroundContact>{}, scene.mesh,
      scene.world, {});
  const State expected = Dropped(&without, scene);
  EXPECT_GT(without.CountIntersections(expected.x), 0);

  Simulation off = MakeSimulation(scene, false);
  Set("contact.stiffness", 1e5, &off);
  Set("contact.thickness", 0.01, &off);
  TestScene with_ball = scene;
  with_ball.world.obstacles = ClothOverBall(9, 0.3).world.obstacles;
  Simulation ball_off = MakeSimulation(with_ball, false);
  Set("obstacle.stiffness", 0.0, &ball_off);
  for (Simulation* simulation : {&off, &ball_off}) {
    EXPECT_FALSE(simulation->model().has_self_contacts());
    const State state = Dropped(simulation, scene);
    EXPECT_EQ(state.x, expected.x);
    EXPECT_EQ(state.v, expected.v);
  }
}

TEST(SelfContact, SameResultAfterReset) {
  const TestScene scene = FoldedCloth(7, 0.2, 0.004);
  Simulation simulation = MakeSimulation(scene, true);
  State first = simulation.MakeState(scene.x);
  for (int i = 0; i < 20; ++i) simulation.Advance(kStep, scene.MakeDrive(), &first);
  simulation.Reset();
  State again = simulation.MakeState(scene.x);
  for (int i = 0; i < 20; ++i) simulation.Advance(kStep, scene.MakeDrive(), &again);
  EXPECT_EQ(first.x, again.x);
  EXPECT_EQ(first.v, again.v);
}

// A folded cloth in free fall without air, its layers thrown against each other: the contact gives
// no momentum and no moment, and no energy.
TEST(SelfContact, KeepsMomentumAndGainsNoEnergy) {
  TestScene scene = FoldedCloth(7, 0.2, 0.006);
  scene.handles.clear();
  scene.world.ground_height.reset();
  Simulation simulation = MakeSimulation(scene, true);
  KeepOnly({"stretch", "shear", "contact"}, &simulation);
  Set("contact.friction", 0.3, &simulation);
  State state = simulation.MakeState(scene.x);
  const std::vector<double>& areas = simulation.model().topology().areas;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const bool upper = state.x[row + 2] > 0.004;
    state.v.segment<3>(row) = Eigen::Vector3d(upper ? 0.2 : 0.0, 0.1, upper ? -0.5 : 0.5);
  }
  const auto momentum = [&](const State& s) {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const auto row = 3 * static_cast<Eigen::Index>(i);
      const Eigen::Vector3d p = areas[i] * s.v.segment<3>(row), x = s.x.segment<3>(row);
      sum.head<3>() += p;
      sum.tail<3>() += x.cross(p);
    }
    return sum;
  };
  const Eigen::Matrix<double, 6, 1> before = momentum(state);
  const double energy = Total(simulation.Energies(state));
  int most_pairs = 0;
  for (int i = 0; i < 40; ++i) {
    const StepReport report = simulation.Advance(kStep, FreeDrive(), &state);
    ASSERT_EQ(report.status, StepStatus::kConverged);
    most_pairs = std::max(most_pairs, report.contact_pairs);
    // The step's own tolerance, 1e-9 of an edge in 8 ms, on each of the particles.
    EXPECT_LE((momentum(state) - before).head<3>().norm(), 1e-7 * before.head<3>().norm());
    EXPECT_LE(Total(simulation.Energies(state)), energy);
  }
  EXPECT_GT(most_pairs, 50);
}

// The same with nothing that takes energy: how much of it is lost by this many steps a second, as a
// share. None may be gained on the way.
double LossOfABounce(double rate) {
  TestScene scene = FoldedCloth(7, 0.2, 0.006);
  scene.handles.clear();
  scene.world.ground_height.reset();
  Simulation simulation = MakeSimulation(scene, true);
  KeepOnly({"stretch", "shear", "contact"}, &simulation);
  Set("stretch.stiffness", 20.0, &simulation);
  for (const char* loss : {"stretch.damping", "shear.damping", "contact.friction"})
    Set(loss, 0.0, &simulation);
  State state = simulation.MakeState(scene.x);
  for (Eigen::Index i = 2; i < state.v.size(); i += 3) state.v[i] = state.x[i] > 0.004 ? -0.2 : 0.2;
  const double energy = Total(simulation.Energies(state));
  double stored = 0.0;
  for (int i = 0; i < static_cast<int>(0.05 * rate); ++i) {
    const StepReport report = simulation.Advance(1.0 / rate, FreeDrive(), &state);
    EXPECT_EQ(report.status, StepStatus::kConverged);
    const std::vector<NamedEnergy> now = simulation.Energies(state);
    EXPECT_LE(Total(now), energy);
    for (const NamedEnergy& part : now) {
      if (part.name == "contact") stored = std::max(stored, part.energy);
    }
  }
  EXPECT_GT(stored, 0.05 * energy);  // contact had some to give back
  return 1.0 - Total(simulation.Energies(state)) / energy;
}

// What the barrier takes it gives back; what is lost is the integrator's, of second order and more
// in the step.
TEST(SelfContact, GivesBackTheEnergyOfABounce) {
  const double coarse = LossOfABounce(8000.0), fine = LossOfABounce(16000.0);
  EXPECT_LE(fine, 0.01);
  EXPECT_LE(fine, 0.25 * coarse);
}

// Two layers, joined at nothing: a small patch lies on a large one whose corners are held, and
// gravity leans. One mesh of two pieces.
struct Patch {
  TestScene scene;
  int first = 0;  // particle of the patch
};
Patch PatchOnLayer() {
  Patch patch;
  TestScene& scene = patch.scene;
  scene.mesh = MakeGrid({0.3, 0.3}, {4, 4});
  patch.first = scene.mesh.num_particles();
  const ClothMesh small = MakeGrid({0.06, 0.06}, {3, 3});
  for (const Eigen::Vector2d& uv : small.uv)
    scene.mesh.uv.push_back(uv + Eigen::Vector2d(0.5, 0.0));
  for (std::array<int, 3> t : small.triangles) {
    for (int& node : t) node += patch.first;
    scene.mesh.triangles.push_back(t);
  }
  scene.mesh.grid = {0, 0};
  scene.x = LayFlat(scene.mesh, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(),
                    Eigen::Vector3d::UnitY());
  for (int i = patch.first; i < scene.mesh.num_particles(); ++i) {
    // Turned a little, in the middle of the other one.
    const Eigen::Vector2d p = scene.mesh.uv[i] - Eigen::Vector2d(0.53, 0.03);
    scene.x.segment<3>(3 * i) << 0.117 + 0.96 * p.x() - 0.28 * p.y(),
        0.143 + 0.28 * p.x() + 0.96 * p.y(), 0.00185;
  }
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < patch.first; ++i) {
    scene.handles.push_back({{i, i, i}, {1.0, 0.0, 0.0}});
    places.push_back(scene.x.segment<3>(3 * i));
  }
  scene.path = [places](double) { return places; };
  return patch;
}

// The patch's mean velocity along x (m/s) after 0.2 s under gravity that leans by this tangent.
double SlideDown(double lean, double friction) {
  Patch patch = PatchOnLayer();
  patch.scene.world.gravity = {9.81 * lean, 0.0, -9.81};
  Simulation simulation = MakeSimulation(patch.scene, true);
  KeepOnly({"gravity", "stretch", "shear", "bending", "contact"}, &simulation);
  Set("contact.friction", friction, &simulation);
  Set("contact.slip_speed", 1e-4, &simulation);
  State state = simulation.MakeState(patch.scene.x);
  for (int i = 0; i < 24; ++i) {
    EXPECT_EQ(simulation.Advance(kStep, patch.scene.MakeDrive(), &state).status,
              StepStatus::kConverged);
  }
  EXPECT_EQ(simulation.CountIntersections(state.x), 0);
  double sum = 0.0;
  const int count = patch.scene.mesh.num_particles() - patch.first;
  for (int i = patch.first; i < patch.scene.mesh.num_particles(); ++i) sum += state.v[3 * i];
  return sum / count;
}

// Coulomb: below mu it sticks, but for the creep of less than the slip speed; above, it
// accelerates by g (lean - mu).
TEST(SelfContact, FrictionHoldsAndSlidesAsCoulombSays) {
  EXPECT_LE(std::abs(SlideDown(0.2, 0.3)), 1e-4);
  const double time = 24 * kStep;
  for (const double friction : {0.0, 0.1, 0.3}) {
    // The patch settles by 0.1 mm while it slides, in which its weight is not quite constant.
    EXPECT_NEAR(SlideDown(0.5, friction), 9.81 * (0.5 - friction) * time, 0.02 * 9.81 * 0.5 * time);
  }
}

TEST(SelfContact, RefusesWhatPassesThroughItself) {
  TestScene scene = FoldedCloth(7, 0.2, 0.004);
  Simulation simulation = MakeSimulation(scene, true);
  Eigen::VectorXd x = scene.x;
  x[2] += 0.02;  // a corner of the lower layer through the upper one
  EXPECT_GT(simulation.CountIntersections(x), 0);
  State state = simulation.MakeState(scene.x);
  simulation.CheckStart(state);
  state.x = x;
  EXPECT_THROW(simulation.CheckStart(state), InputError);
  EXPECT_EQ(simulation.Advance(kStep, scene.MakeDrive(), &state).status, StepStatus::kDiverged);
  EXPECT_EQ(state.x, x);
}

TEST(SelfContact, RefusesAThicknessBeyondTheMesh) {
  const TestScene scene = FoldedCloth(7, 0.2, 0.02);
  Simulation simulation = MakeSimulation(scene, true);
  Set("contact.thickness", 0.019, &simulation);  // edges are 33 mm
  State state = simulation.MakeState(scene.x);
  EXPECT_THROW(simulation.CheckStart(state), InputError);
  EXPECT_EQ(simulation.Advance(kStep, scene.MakeDrive(), &state).status, StepStatus::kDiverged);
}

TEST(SelfContact, NeedsATermThatAnswers) {
  const TestScene scene = SwingingCloth(4, 0.3);
  SimulationOptions options;
  options.self_contact = true;
  EXPECT_THROW(Simulation::WithTerms(TypeList<Gravity>{}, scene.mesh, scene.world, {}, options),
               InputError);
}

}  // namespace
}  // namespace clothfit
