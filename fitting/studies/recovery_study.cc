// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/recovery_study.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/search.h"

namespace clothfit {
namespace {

constexpr double kTwoSided95 = 1.959964;

RecoveredParameter Compare(const ParameterEstimate& estimate, double truth, bool is_log) {
  RecoveredParameter result;
  result.name = estimate.name;
  result.unit = estimate.unit;
  result.truth = truth;
  result.start = estimate.start;
  result.estimate = estimate.value;
  result.lower95 = estimate.lower95;
  result.upper95 = estimate.upper95;
  result.determined = estimate.determined;
  const auto scaled = [is_log](double value) { return is_log ? std::log(value) : value; };
  result.error = scaled(estimate.value) - scaled(truth);
  const double end = result.error > 0.0 ? estimate.lower95 : estimate.upper95;
  result.z = kTwoSided95 * result.error / std::abs(scaled(estimate.value) - scaled(end));
  return result;
}

}  // namespace

double Coverage::Wilson(double side) const {
  if (total == 0) return side < 0.0 ? 0.0 : 1.0;
  const double n = total, z = kTwoSided95, p = share();
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return std::clamp((p + z * z / (2.0 * n) + side * half) / (1.0 + z * z / n), 0.0, 1.0);
}

RecoveredSeed RecoverSeed(const RecoveryOptions& options, int seed) {
  SyntheticOptions recording_options = options.recording;
  recording_options.seed = static_cast<std::uint64_t>(seed);
  const SyntheticRecording synthetic =
      MakeSyntheticRecording(recording_options, {}, options.generator);
  FitConfig config = DefaultConfig(synthetic.recording);
  config.max_iterations = options.max_iterations;
  config.finest = options.finest;
  const FitResult fit = FitOnChosenMesh(MakeScene(synthetic.recording, config), config).result;
  RecoveredSeed result;
  result.seed = seed;
  result.status = fit.status;
  result.iterations = fit.iterations;
  result.seconds = fit.seconds;
  result.marker_rms = fit.after.marker_rms.value_or(NAN);
  result.held_out_rms = fit.after.held_out_marker_rms.value_or(NAN);
  result.noise_factor = fit.noise_factor;
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const ParameterEstimate& estimate : fit.estimates) {
    const int index = FindParameter(table, estimate.name);
    if (!estimate.free || index < 0) continue;
    result.parameters.push_back(Compare(estimate, synthetic.truth_parameters.at(estimate.name),
                                        table[index].parameter.scale == Scale::kLog));
  }
  return result;
}

std::vector<RecoveredSeed> RunRecoveryStudy(const RecoveryOptions& options,
                                            const std::function<void(const RecoveredSeed&)>& done) {
  std::vector<RecoveredSeed> results(static_cast<std::size_t>(options.num_seeds));
  std::mutex mutex;
  ParallelFor(options.num_seeds, options.num_threads, [&](int i, int) {
    RecoveredSeed result = RecoverSeed(options, options.first_seed + i);
    const std::lock_guard<std::mutex> lock(mutex);
    if (done) done(result);
    results[static_cast<std::size_t>(i)] = std::move(result);
  });
  return results;
}

Coverage CountCoverage(const std::vector<RecoveredSeed>& seeds, const std::string& name) {
  Coverage coverage;
  for (const RecoveredSeed& seed : seeds) {
    for (const RecoveredParameter& parameter : seed.parameters) {
      if (!parameter.determined || (!name.empty() && parameter.name != name)) continue;
      ++coverage.total;
      if (parameter.IsCovered()) ++coverage.covered;
    }
  }
  return coverage;
}

SyntheticOptions DemoRecording() {
  SyntheticOptions options;
  options.name = "demo";
  options.seed = 2;
  options.parameters = {
      {"stretch.stiffness", 400.0}, {"stretch.damping", 0.4},     {"shear.stiffness", 8.0},
      {"shear.damping", 0.2},       {"bending.stiffness", 5e-5},  {"bending.damping", 4e-6},
      {"air_drag.normal", 0.3},     {"air_drag.saturation", 1.0}, {"air_drag.tangential", 0.05}};
  return options;
}

}  // namespace clothfit
