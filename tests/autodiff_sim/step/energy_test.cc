// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The energies that terms give are those of their forces, and a simulation adds them up.
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/terms/force_of_energy.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

TEST(Energy, IsThatOfTheForces) {
  ExpectForceOfEnergy<Gravity>(Numbers({0.7}));
  ExpectForceOfEnergy<StretchSpring>(Numbers({150.0, 0.2}));
  ExpectForceOfEnergy<Shear>(Numbers({20.0, 0.1}));
  // The stress changes within strains of 1e-4, for which differences take smaller steps.
  constexpr double kOfDifferences = 3e-6;
  ExpectForceOfEnergy<StretchSpring>(Numbers({150.0, 0.2}), MakeBucklingTermScenes(),
                                     kOfDifferences);
  ExpectForceOfEnergy<Shear>(Numbers({20.0, 0.1}), MakeBucklingTermScenes(), kOfDifferences);
  ExpectForceOfEnergy<Bending>(Numbers({1e-3, 1e-5}));
  ExpectForceOfEnergy<GroundContact>(Numbers({1e5, 0.4, 0.0, 0.002, 0.005}));
}

// The features within 12 mm that the scenes have, and no friction, since obstacles move.
TEST(Energy, OfContactIsThatOfTheForces) {
  ExpectForceOfEnergy<SelfContact>(Numbers({200.0, 0.013, 0.0, 0.005}));
  ExpectForceOfEnergy<ObstacleBarrier>(
      Numbers({200.0, 0.013, 0.0, 0.005, 1e-4, -2e-4, 3e-4, 2e-4}));
}

double Part(const std::string& name, const std::vector<NamedEnergy>& energies) {
  for (const NamedEnergy& part : energies) {
    if (part.name == name) return part.energy;
  }
  ADD_FAILURE() << name;
  return 0.0;
}

// A cloth that is moved, stretched along the warp and let go.
TEST(Energy, OfASimulationIsWhatItsShapeAndMotionSay) {
  const TestScene scene = LiftedCloth(6, 0.3);
  Simulation simulation(scene.mesh, scene.world, scene.handles);
  UseSuppleCloth(&simulation);
  State state = simulation.MakeState(scene.x);
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    state.x[3 * i] *= 1.01;
    state.x[3 * i + 2] = 0.4;
    state.v.segment<3>(3 * i) = Eigen::Vector3d(0.0, 3.0, 4.0);
  }
  const double area = 0.09, mass = 0.15 * area;
  const std::vector<NamedEnergy> energies = simulation.Energies(state);
  EXPECT_NEAR(Part("kinetic", energies), 0.5 * mass * 25.0, 1e-12);
  EXPECT_NEAR(Part("gravity", energies), mass * 9.81 * 0.4, 1e-12);
  EXPECT_NEAR(Part("stretch", energies), 0.5 * 200.0 * area * 1e-4, 1e-12);
  EXPECT_GT(Part("shear", energies), 0.0);
  for (const char* none : {"bending", "ground", "contact", "obstacle"})
    EXPECT_NEAR(Part(none, energies), 0.0, 1e-15) << none;
  Set("gravity.scale", 0.0, &simulation);
  EXPECT_EQ(Part("gravity", simulation.Energies(state)), 0.0);
}

// Lifted slowly and without loss, the weight's energy is the handle's work.
TEST(Energy, OfAWeightLiftedIsTheHandlesWork) {
  TestScene scene = SwingingCloth(4, 0.2);
  Simulation simulation(scene.mesh, scene.world, scene.handles);
  UseSuppleCloth(&simulation);
  KeepOnly({"gravity", "stretch", "shear", "bending"}, &simulation);
  // Hangs straight down at first.
  scene.x =
      LayFlat(scene.mesh, {0.0, 0.0, 0.5}, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
  const std::vector<Eigen::Vector3d> start = {scene.handles[0].At(scene.x),
                                              scene.handles[1].At(scene.x)};
  scene.path = [start](double time) {
    const double s = std::min(time, 1.0), up = 0.3 * s * s * (3.0 - 2.0 * s);
    const Eigen::Vector3d lift(0.0, 0.0, up);
    return std::vector<Eigen::Vector3d>{start[0] + lift, start[1] + lift};
  };
  State state = simulation.MakeState(scene.x);
  const double before = Total(simulation.Energies(state));
  double work = 0.0;
  for (int i = 0; i < 480; ++i) {
    const StepReport report = simulation.Advance(1.0 / 240.0, scene.MakeDrive(), &state);
    ASSERT_EQ(report.status, StepStatus::kConverged);
    work += report.handle_work;
  }
  const double lifted = 0.15 * 0.04 * 9.81 * 0.3;  // J
  EXPECT_NEAR(work, lifted, 0.05 * lifted);
  // What damping takes while the cloth settles into its weight at the start.
  EXPECT_NEAR(Total(simulation.Energies(state)) - before, work, 0.02 * lifted);
}

}  // namespace
}  // namespace clothfit
