// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What contact costs a step. Names end in the particles a side. All times are processor times.
//   ratio       time with contact to time without, the same scene in turns, step after step
//   detection, response   shares of the step with contact: finding pairs and checking motions;
//   forces
//               and Jacobians of contact, patterns and matrices made anew. The rest is solving.
// What the hard scenes cost tells clothfit study contact.
#include <cstdint>

#include <benchmark/benchmark.h>

#include "autodiff_sim/contact/contact_clock.h"
#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/proximity.h"
#include "autodiff_sim/contact/self_contacts.h"
#include "autodiff_sim/scenes/contact_scenes.h"
#include "tests/benchmarks/cholmod_reference.h"
#include "tests/support/all_pairs.h"

namespace clothfit {
namespace {

constexpr double kStep = 1.0 / 120.0;  // s
constexpr double kThickness = 0.002;   // m, contact.thickness's initial value

// One simulation, and the time it took.
struct Run {
  Run(const ClothScene& scene, bool self_contact)
      : simulation(scene.mesh, scene.world, scene.handles, Options(self_contact)),
        drive(scene.MakeDrive()) {
    UseSuppleCloth(&simulation);
    state = simulation.MakeState(scene.x);
  }

  static SimulationOptions Options(bool self_contact) {
    SimulationOptions options;
    options.self_contact = self_contact;
    return options;
  }

  bool Advance() {
    const double start = Now();
    const StepReport report = simulation.Advance(kStep, drive, &state);
    seconds += Now() - start;
    total += report;
    return report.status == StepStatus::kConverged;
  }

  Simulation simulation;
  Drive drive;
  State state;
  StepReport total;
  double seconds = 0.0;
};

void SetCounters(const Run& run, int steps, benchmark::State* state) {
  state->counters["pairs"] = run.total.most_contact_pairs;
  state->counters["obstacle_contacts"] = run.total.most_obstacle_contacts;
  state->counters["newton"] = run.total.newton_iterations / static_cast<double>(steps);
  state->counters["jacobians"] = run.total.jacobians / static_cast<double>(steps);
  state->counters["linear"] = run.total.linear_iterations / static_cast<double>(steps);
  state->counters["factors"] = run.total.factorizations / static_cast<double>(steps);
  state->counters["rebuilds"] = run.total.pattern_rebuilds / static_cast<double>(steps);
  state->counters["halvings"] = run.total.halvings;
  state->counters["ms_per_step"] = 1e3 * run.seconds / steps;
  state->counters["detection"] = contact_times.detection / run.seconds;
  state->counters["response"] = contact_times.response / run.seconds;
}

void Compare(const ClothScene& scene, int steps, benchmark::State* state) {
  for (auto _ : *state) {
    Run contact(scene, true), plain(scene, false);
    contact_times = {};
    int intersections = 0;
    for (int step = 0; step < steps; ++step) {
      if (!contact.Advance()) return state->SkipWithError("a step did not converge");
      plain.Advance();
      intersections += contact.simulation.CountIntersections(contact.state.x);
    }
    state->SetIterationTime(contact.seconds);
    SetCounters(contact, steps, state);
    state->counters["intersections"] = intersections;
    state->counters["ratio"] = contact.seconds / plain.seconds;
  }
}

// A square metre, one corner of which is lifted: nothing meets.
void Lifted(benchmark::State& state) {
  Compare(LiftedCloth(static_cast<int>(state.range(0)), 1.0), 120, &state);
}

// The corner is lifted, drawn over the cloth and put down on it.
void DrawnOver(benchmark::State& state) {
  Compare(CornerDrawnOver(static_cast<int>(state.range(0)), 1.0), 150, &state);
}

// It falls from standing into a heap of many layers.
void Dropped(benchmark::State& state) {
  Compare(DroppedCloth(static_cast<int>(state.range(0)), 0.5), 60, &state);
}

// What a step grows with: 20 steps, when the corner that is drawn over has come down.
void Growth(benchmark::State& state) {
  const bool in_contact = state.range(1) != 0;
  const int n = static_cast<int>(state.range(0));
  ClothScene scene = in_contact ? FoldedCloth(n, 1.0, 0.0019) : LiftedCloth(n, 1.0);
  Compare(scene, 20, &state);
}

// Finding what is close and what meets, in a scene's state after 60 steps, by trees of k planes and
// by all pairs (0): ms. Names end in the scene, 0 crumpled, 1 over a ball, 2 folded, and k.
ClothScene DetectionScene(int64_t scene) {
  if (scene == 0) return DroppedCloth(20, 0.5);
  return scene == 1 ? ClothOverBall(20, 0.5) : FoldedCloth(20, 0.4, 0.008);
}

template <int kPlanes>
void TimeTrees(const ClothMesh& mesh, const Eigen::VectorXd& x0, const Eigen::VectorXd& x1) {
  CollisionSurface<kPlanes> surface(mesh);
  benchmark::DoNotOptimize(FindProximity(x1, 2.0 * kThickness, &surface).size());
  benchmark::DoNotOptimize(FindContinuous(Motion{x0, x1}, Approach{}, &surface).size());
}

void TimeAllPairs(const ClothMesh& mesh, const Eigen::VectorXd& x0, const Eigen::VectorXd& x1) {
  const MeshFeatures features = FindFeatures(mesh.triangles);
  const PlacedMesh start{features, x0}, end{features, x1};
  int found = 0;
  VisitAllPairs(features, mesh.num_particles(), [&](const FeaturePair& pair) {
    const FourPoints there = PairPoints(pair, end, end);
    if (MeasureContact(pair, there).distance < 2.0 * kThickness) ++found;
    if (FirstApproach(pair, PairPoints(pair, start, start), there, Approach{})) ++found;
  });
  benchmark::DoNotOptimize(found);
}

void Detection(benchmark::State& state) {
  Run run(DetectionScene(state.range(0)), true);
  Eigen::VectorXd before;
  for (int step = 0; step < 60; ++step) {
    before = run.state.x;
    if (!run.Advance()) return state.SkipWithError("a step did not converge");
  }
  const ClothMesh& mesh = run.simulation.model().mesh();
  for (auto _ : state) {
    if (state.range(1) == 0) TimeAllPairs(mesh, before, run.state.x);
    if (state.range(1) == 6) TimeTrees<6>(mesh, before, run.state.x);
    if (state.range(1) == 14) TimeTrees<14>(mesh, before, run.state.x);
    if (state.range(1) == 18) TimeTrees<18>(mesh, before, run.state.x);
    if (state.range(1) == 26) TimeTrees<26>(mesh, before, run.state.x);
  }
}

BENCHMARK(Lifted)->Arg(15)->Arg(30)->Arg(60)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(DrawnOver)->Arg(15)->Arg(30)->Arg(60)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(Dropped)->Arg(15)->Arg(30)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(Growth)
    ->ArgsProduct({{15, 30, 60, 100}, {0, 1}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(Detection)->ArgsProduct({{0, 1, 2}, {0, 6, 14, 18, 26}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clothfit
