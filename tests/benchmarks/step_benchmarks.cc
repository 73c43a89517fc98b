// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a step costs, alone and with derivatives, in milliseconds and in factorisations. Everything
// that a ratio compares is timed in turns, step after step, so that whatever else the machine does
// slows all of it alike.
#include <algorithm>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>

#include "autodiff_sim/step/simulation.h"
#include "tests/benchmarks/cholmod_reference.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

constexpr int kSteps = 120;
constexpr double kStep = 1.0 / 120.0;
constexpr double kExactly = 1e-9, kAsInFits = 1e-7;  // SimulationOptions::tolerance

// A square metre on the ground, one corner of which is lifted by 0.6 m and drawn inwards by 0.3 m.
TestScene BenchmarkScene(int n) {
  TestScene scene = LiftedCloth(n, 1.0);
  const Eigen::Vector3d origin(0.0, 0.0, 0.0018);
  scene.x = LayFlat(scene.mesh, origin, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  scene.path = [origin](double time) {
    const double t = std::clamp(time / 1.2, 0.0, 1.0), s = t * t * (3.0 - 2.0 * t);
    return std::vector<Eigen::Vector3d>{origin + s * Eigen::Vector3d(0.3, 0.3, 0.6)};
  };
  return scene;
}

// A square metre that swings from one corner.
TestScene HangingScene(int n) {
  TestScene scene = LiftedCloth(n, 1.0);
  scene.world.ground_height.reset();
  const Eigen::Vector3d origin = scene.x.head<3>();
  scene.path = [origin](double) { return std::vector<Eigen::Vector3d>{origin}; };
  return scene;
}

// The whole process, MB.
double ResidentMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmRSS:", 0) == 0) return std::stod(line.substr(6)) / 1024.0;
  }
  return 0.0;
}

// Directions that move one parameter each by its own size; where there are more directions than
// parameters that do something, they begin anew.
Eigen::MatrixXd Directions(const Simulation& simulation, int count) {
  Eigen::MatrixXd directions =
      Eigen::MatrixXd::Zero(static_cast<int>(simulation.model().parameters().size()), count);
  for (int c = 0, p = 0; c < count; p = (p + 1) % static_cast<int>(directions.rows())) {
    const double value = simulation.parameters()[p];
    if (value != 0.0) directions(p, c++) = value;
  }
  return directions;
}

// A cotton that moves freely; these figures do not depend on clothfit's initial values.
Simulation MakeSimulation(const TestScene& scene, double tolerance) {
  SimulationOptions options;
  options.tolerance = tolerance;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  return simulation;
}

// One simulation, and the time it took.
struct Run {
  Run(const TestScene& scene, int num_directions, double tolerance)
      : simulation(MakeSimulation(scene, tolerance)),
        drive(scene.MakeDrive()),
        state(simulation.MakeState(scene.x)),
        sensitivity(state, Directions(simulation, num_directions)) {}

  bool Advance() {
    const double start = Now();
    const StepReport report = simulation.Advance(
        kStep, drive, &state, sensitivity.num_directions() > 0 ? &sensitivity : nullptr);
    seconds += Now() - start;
    total += report;
    return report.status == StepStatus::kConverged;
  }

  Simulation simulation;
  Drive drive;
  State state;
  Sensitivity sensitivity;
  StepReport total;
  double seconds = 0.0;
};

void ReportCounts(const StepReport& total, benchmark::State* state) {
  state->counters["newton"] = total.newton_iterations / static_cast<double>(kSteps);
  state->counters["gmres"] = total.linear_iterations / static_cast<double>(kSteps);
  state->counters["jacobians"] = total.jacobians / static_cast<double>(kSteps);
  state->counters["factors"] = total.factorizations / static_cast<double>(kSteps);
  state->counters["halvings"] = total.halvings;
}

void RunForward(const TestScene& scene, double tolerance, benchmark::State* state) {
  double seconds = 0.0, factorization = 0.0;
  for (auto _ : *state) {
    Run run(scene, 0, tolerance);
    BlockSparseMatrix jacobian(&run.simulation.model().pattern());
    CholmodReference reference(run.simulation.model().pattern());
    for (int step = 0; step < kSteps; ++step) {
      if (!run.Advance()) return state->SkipWithError("a step did not converge");
      const State& s = run.state;
      const Eigen::VectorXd still = Eigen::VectorXd::Zero(s.x.size());
      run.simulation.model().StepJacobian(
          {s.time, kStep, s.x, s.v, still, s.x, run.simulation.parameters(), s.memory},
          kStep * 2.0 / 3.0, &jacobian);
      factorization += reference.Factorize(jacobian);
    }
    seconds += run.seconds;
    state->SetIterationTime(run.seconds);
    ReportCounts(run.total, state);
  }
  const double steps = static_cast<double>(state->iterations()) * kSteps;
  state->counters["ms_per_step"] = 1e3 * seconds / steps;
  state->counters["F_ms"] = 1e3 * factorization / steps;
  state->counters["step_in_F"] = seconds / factorization;
}

void LiftedForward(benchmark::State& state) {
  RunForward(BenchmarkScene(static_cast<int>(state.range(0))), kExactly, &state);
}

void LiftedForwardAsInFits(benchmark::State& state) {
  RunForward(BenchmarkScene(static_cast<int>(state.range(0))), kAsInFits, &state);
}

void HangingForward(benchmark::State& state) {
  RunForward(HangingScene(static_cast<int>(state.range(0))), kExactly, &state);
}

void RunDerivatives(double tolerance, benchmark::State& state) {
  const int directions = static_cast<int>(state.range(1));
  const TestScene scene = BenchmarkScene(static_cast<int>(state.range(0)));
  double forward = 0.0, both = 0.0, early = 0.0, late = 0.0;
  for (auto _ : state) {
    Run plain(scene, 0, tolerance), differentiated(scene, directions, tolerance);
    for (int step = 0; step < kSteps; ++step) {
      if (!plain.Advance() || !differentiated.Advance())
        return state.SkipWithError("a step did not converge");
      if (step == kSteps / 4) early = ResidentMemory();
    }
    late = ResidentMemory();
    forward += plain.seconds;
    both += differentiated.seconds;
    state.SetIterationTime(differentiated.seconds);
    ReportCounts(differentiated.total, &state);
    state.counters["lanes_gmres"] =
        differentiated.total.sensitivity_iterations / static_cast<double>(kSteps);
  }
  state.counters["ms_per_step"] = 1e3 * both / (static_cast<double>(state.iterations()) * kSteps);
  state.counters["ratio_to_forward"] = both / forward;
  state.counters["times_faster_than_central"] = 2.0 * directions * forward / both;
  state.counters["growth_MB"] = late - early;  // over the last three quarters of the steps
}

void LiftedDerivatives(benchmark::State& state) { RunDerivatives(kExactly, state); }
void LiftedDerivativesAsInFits(benchmark::State& state) { RunDerivatives(kAsInFits, state); }

BENCHMARK(LiftedForwardAsInFits)->Arg(30)->Arg(60)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(LiftedDerivativesAsInFits)
    ->Args({30, 10})
    ->Args({30, 33})
    ->Args({60, 33})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(LiftedForward)->Arg(30)->Arg(60)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(HangingForward)->Arg(30)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(LiftedDerivatives)
    ->Args({30, 8})
    ->Args({30, 24})
    ->Args({30, 184})
    ->Args({60, 8})
    ->Args({60, 24})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clothfit
