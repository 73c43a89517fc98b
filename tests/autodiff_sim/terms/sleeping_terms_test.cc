// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Terms that are off cost nothing and change nothing, and may be switched on at any time.
#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/terms/catalogue_cases.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

constexpr double kStep = 1.0 / 120.0;  // s

using TermsThatAct = TypeList<Gravity, StretchSpring, Shear, Bending, AirDrag>;

// The simulation after some steps, with derivatives by these parameters.
struct End {
  State state;
  Eigen::MatrixXd dx;
  Eigen::MatrixXd memory_derivatives;
};

End RunSteps(Simulation* simulation, const TestScene& scene,
             const std::vector<std::string>& directions) {
  const Eigen::Index size = simulation->parameters().size();
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(directions.size()));
  for (Eigen::Index i = 0; i < moved.cols(); ++i)
    moved(RequireParameter(simulation->model().parameters(), directions[i]), i) = 1.0;
  End end;
  end.state = simulation->MakeState(scene.x);
  Sensitivity sensitivity(end.state, moved);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(simulation->Advance(kStep, scene.MakeDrive(), &end.state, &sensitivity).status,
              StepStatus::kConverged);
  }
  end.dx = sensitivity.x();
  if (!sensitivity.lanes().empty()) end.memory_derivatives = sensitivity.lanes().front().memory;
  return end;
}

TEST(SleepingTerms, ChangeNoNumber) {
  const TestScene scene = SwingingCloth(5, 0.3);
  Simulation all(scene.mesh, scene.world, scene.handles);
  UseSuppleCloth(&all);
  Simulation few = Simulation::WithTerms(TermsThatAct{}, scene.mesh, scene.world, scene.handles);
  UseSuppleCloth(&few);
  const std::vector<std::string> directions = {"bending.stiffness", "air_drag.normal"};
  const End with = RunSteps(&all, scene, directions), without = RunSteps(&few, scene, directions);
  EXPECT_EQ(with.state.x, without.state.x);
  EXPECT_EQ(with.state.v, without.state.v);
  EXPECT_EQ(with.dx, without.dx);
  EXPECT_GT(with.dx.lpNorm<Eigen::Infinity>(), 0.0);
}

// A term that is off remembers, where it is asked to, as it does when it is on so little that it
// moves nothing; otherwise it waits with what it has.
TEST(SleepingTerms, Remember) {
  const TestScene scene = SwingingCloth(5, 0.3);
  int count = 0;
  for (const TermInfo& term : AllTerms()) {
    if (term.memory == 0) continue;
    SCOPED_TRACE(term.name);
    SimulationOptions remembering;
    remembering.remember_when_off = true;
    Simulation off(scene.mesh, scene.world, scene.handles, remembering);
    UseSuppleCloth(&off);
    Simulation waiting(scene.mesh, scene.world, scene.handles);
    UseSuppleCloth(&waiting);
    Simulation on(scene.mesh, scene.world, scene.handles, remembering);
    UseSuppleCloth(&on);
    Set(term.name + "." + term.parameters[0].name, 1e-200, &on);
    const End sleeping = RunSteps(&off, scene, {}), awake = RunSteps(&on, scene, {});
    EXPECT_EQ(sleeping.state.x, awake.state.x);
    EXPECT_EQ(sleeping.state.memory, awake.state.memory);
    EXPECT_GT(awake.state.memory.lpNorm<Eigen::Infinity>(), 1e-5);
    EXPECT_EQ(RunSteps(&waiting, scene, {}).state.memory.lpNorm<Eigen::Infinity>(), 0.0);
    ++count;
  }
  EXPECT_GT(count, 0);
}

// Derivatives at off, by the term's own parameter and, beside it, of what is remembered, are those
// of a term that is on by next to nothing.
TEST(SleepingTerms, HaveTheDerivativesOfSwitchingOn) {
  const TestScene scene = SwingingCloth(5, 0.3);
  int count = 0;
  for (const CatalogueCase& one : CatalogueCases()) {
    if (one.on_ground) continue;
    SCOPED_TRACE(one.term);
    Simulation off(scene.mesh, scene.world, scene.handles);
    UseSuppleCloth(&off);
    for (const auto& [name, value] : one.on) Set(one.term + "." + name, value, &off);
    std::string amount;
    for (const NamedParameter& p : off.model().parameters()) {
      if (p.term != one.term || !SwitchesOff(p.parameter)) continue;
      Set(p.name, p.parameter.off, &off);
      amount = p.name;
    }
    Simulation on(scene.mesh, scene.world, scene.handles);
    on.SetParameters(off.parameters());
    Set(amount, Get(amount, off) + 1e-12, &on);
    const std::vector<std::string> directions = {amount, "bending.stiffness"};
    const End at_off = RunSteps(&off, scene, directions), beside = RunSteps(&on, scene, directions);
    EXPECT_GT(at_off.dx.col(0).lpNorm<Eigen::Infinity>(), 0.0);
    for (int i = 0; i < 2; ++i) {
      // The solver leaves 1e-9 of each step's derivatives.
      const double size = beside.dx.col(i).lpNorm<Eigen::Infinity>();
      EXPECT_LE((at_off.dx.col(i) - beside.dx.col(i)).lpNorm<Eigen::Infinity>(), 1e-6 * size);
    }
    // What 1e-12 of the amount does to the motion, over the friction's onset.
    EXPECT_LE((at_off.state.memory - beside.state.memory).lpNorm<Eigen::Infinity>(), 1e-8);
    if (at_off.memory_derivatives.size() > 0) {
      const double size = beside.memory_derivatives.lpNorm<Eigen::Infinity>();
      EXPECT_LE((at_off.memory_derivatives - beside.memory_derivatives).lpNorm<Eigen::Infinity>(),
                1e-6 * size);
    }
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace clothfit
