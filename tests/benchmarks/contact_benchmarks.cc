// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What contact costs a step. Names end in the particles a side. All times are processor times.
//   ratio       time with contact to time without, the same scene in turns, step after step
//   detection, response   shares of the step with contact: finding pairs and checking motions;
//   forces
//               and Jacobians of contact, patterns and matrices made anew. The rest is solving.
//   gain        of scenes that nothing drives: the most by which kinetic energy and that of the
//               height ever exceed what they were at first, as a share of it
// The hard scenes are run without a counterpart.
#include <algorithm>

#include <benchmark/benchmark.h>

#include "autodiff_sim/contact/contact_clock.h"
#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/proximity.h"
#include "autodiff_sim/contact/self_contacts.h"
#include "tests/benchmarks/cholmod_reference.h"
#include "tests/support/all_pairs.h"
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

void Compare(const TestScene& scene, int steps, benchmark::State* state) {
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

double MotionEnergy(const Simulation& simulation, const State& state) {
  const std::vector<double>& areas = simulation.model().topology().areas;
  double energy = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    energy += areas[i] * (0.5 * state.v.segment<3>(row).squaredNorm() + 9.81 * state.x[row + 2]);
  }
  return energy;
}

// One scene by itself: does all hold?
void Hard(const TestScene& scene, int steps, benchmark::State* state) {
  for (auto _ : *state) {
    Run run(scene, true);
    contact_times = {};
    const double energy = MotionEnergy(run.simulation, run.state);
    double gain = -1.0;
    int intersections = 0, failed = 0;
    for (int step = 0; step < steps && failed == 0; ++step) {
      failed += run.Advance() ? 0 : 1;
      intersections += run.simulation.CountIntersections(run.state.x) +
                       run.simulation.CountObstacleIntersections(run.state.x, run.state.time);
      gain = std::max(gain, MotionEnergy(run.simulation, run.state) / energy - 1.0);
    }
    state->SetIterationTime(run.seconds);
    SetCounters(run, steps, state);
    state->counters["intersections"] = intersections;
    state->counters["failed"] = failed;
    if (scene.handles.empty()) state->counters["gain"] = gain;
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

// A corner goes up and over, and hangs there: 300 frames at 30 Hz.
void LiftedFor300Frames(benchmark::State& state) {
  Hard(LiftedCloth(static_cast<int>(state.range(0)), 1.0), 1200, &state);
}
void Crumpled(benchmark::State& state) {
  Hard(DroppedCloth(static_cast<int>(state.range(0)), 0.5), 120, &state);
}
void FoldedAndDragged(benchmark::State& state) {
  Hard(FoldedCloth(static_cast<int>(state.range(0)), 0.4, 0.008), 120, &state);
}
void OverBall(benchmark::State& state) {
  Hard(ClothOverBall(static_cast<int>(state.range(0)), 0.5), 120, &state);
}
void OverBarAndOff(benchmark::State& state) {
  Hard(ClothOverBar(static_cast<int>(state.range(0)), 0.5), 150, &state);
}
void Twisted(benchmark::State& state) {
  Hard(TwistedCloth(static_cast<int>(state.range(0)), 0.5, 1.0), 120, &state);
}

// What a step grows with: 20 steps, when the corner that is drawn over has come down.
void Growth(benchmark::State& state) {
  const bool in_contact = state.range(1) != 0;
  const int n = static_cast<int>(state.range(0));
  TestScene scene = in_contact ? FoldedCloth(n, 1.0, 0.0019) : LiftedCloth(n, 1.0);
  Compare(scene, 20, &state);
}

// Finding what is close and what meets, in a scene's state after 60 steps, by trees of k planes and
// by all pairs (0): ms. Names end in the scene, 0 crumpled, 1 over a ball, 2 folded, and k.
TestScene DetectionScene(int64_t scene) {
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
BENCHMARK(LiftedFor300Frames)->Arg(15)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK(Crumpled)->Arg(20)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK(FoldedAndDragged)->Arg(20)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK(OverBall)->Arg(20)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK(OverBarAndOff)->Arg(20)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK(Twisted)->Arg(20)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK(Growth)
    ->ArgsProduct({{15, 30, 60, 100}, {0, 1}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(Detection)->ArgsProduct({{0, 1, 2}, {0, 6, 14, 18, 26}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clothfit
