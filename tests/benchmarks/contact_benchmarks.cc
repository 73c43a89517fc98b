// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What self-contact costs a step: the same scene with and without, in turns, step after step, so
// that whatever else the machine does slows both alike. Names end in the particles a side.
//   ratio       time with contact to time without
//   detection   the share of the step with contact that finding pairs and checking motions takes,
//               as timed by doing it again for the step's motion: once around it, and the pairs at
//               its end
#include <algorithm>

#include <benchmark/benchmark.h>

#include "tests/benchmarks/cholmod_reference.h"
#include "tests/support/contact_scenes.h"

namespace clothfit {
namespace {

constexpr double kStep = 1.0 / 120.0;  // s
constexpr double kThickness = 0.002;   // m, contact.thickness's initial value

// One simulation, and the time it took.
struct Run {
  Run(const TestScene& scene, bool self_contact)
      : simulation(scene.mesh, scene.world, scene.handles, Options(self_contact)),
        drive(scene.handles.empty() ? FreeDrive() : scene.MakeDrive()) {
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
    most_pairs = std::max(most_pairs, report.contact_pairs);
    return report.status == StepStatus::kConverged;
  }

  Simulation simulation;
  Drive drive;
  State state;
  StepReport total;
  int most_pairs = 0;
  double seconds = 0.0;
};

void Compare(const TestScene& scene, int steps, benchmark::State* state) {
  double with = 0.0, without = 0.0, detection = 0.0;
  for (auto _ : *state) {
    Run contact(scene, true), plain(scene, false);
    SelfContacts again(scene.mesh);
    int intersections = 0;
    for (int step = 0; step < steps; ++step) {
      const Eigen::VectorXd before = contact.state.x;
      if (!contact.Advance()) return state->SkipWithError("a step did not converge");
      plain.Advance();
      const double start = Now();
      again.Prepare(before, contact.state.x, kThickness);
      benchmark::DoNotOptimize(again.FreeShare(before, contact.state.x, kThickness));
      benchmark::DoNotOptimize(again.Find(contact.state.x, kThickness).size());
      detection += Now() - start;
      intersections += contact.simulation.CountIntersections(contact.state.x);
    }
    with += contact.seconds;
    without += plain.seconds;
    state->SetIterationTime(contact.seconds);
    state->counters["pairs"] = contact.most_pairs;
    state->counters["newton"] = contact.total.newton_iterations / static_cast<double>(steps);
    state->counters["factors"] = contact.total.factorizations / static_cast<double>(steps);
    state->counters["rebuilds"] = contact.total.pattern_rebuilds / static_cast<double>(steps);
    state->counters["halvings"] = contact.total.halvings;
    state->counters["intersections"] = intersections;
  }
  state->counters["ms_per_step"] = 1e3 * with / (static_cast<double>(state->iterations()) * steps);
  state->counters["ratio"] = with / without;
  state->counters["detection"] = detection / with;
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

BENCHMARK(Lifted)->Arg(15)->Arg(30)->Arg(60)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(DrawnOver)->Arg(15)->Arg(30)->Arg(60)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(Dropped)->Arg(15)->Arg(30)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clothfit
