// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A recovery study as CSV and as a table.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/studies/recovery_study.h"

namespace clothfit {
namespace {

// What all seeds say of one parameter.
struct ParameterSummary {
  RecoveredParameter first;
  int count = 0, determined = 0;
  double mean_error = 0.0, spread = 0.0, mean_sigma = 0.0, mean_abs_z = 0.0;
};

ParameterSummary Summarise(const std::vector<RecoveredSeed>& seeds, std::size_t index) {
  ParameterSummary summary;
  summary.first = seeds.front().parameters[index];
  double squares = 0.0;
  for (const RecoveredSeed& seed : seeds) {
    const RecoveredParameter& parameter = seed.parameters[index];
    ++summary.count;
    if (parameter.determined) ++summary.determined;
    summary.mean_error += parameter.error;
    squares += parameter.error * parameter.error;
    summary.mean_sigma += std::abs(parameter.error / parameter.z);
    summary.mean_abs_z += std::abs(parameter.z);
  }
  const double n = summary.count;
  summary.mean_error /= n;
  summary.mean_sigma /= n;
  summary.mean_abs_z /= n;
  summary.spread = std::sqrt(std::max(0.0, squares / n - summary.mean_error * summary.mean_error));
  return summary;
}

std::string CoverageText(const Coverage& coverage) {
  return fmt::format("{}/{} = {:.1f} % ({:.1f} to {:.1f} %)", coverage.covered, coverage.total,
                     100.0 * coverage.share(), 100.0 * coverage.lower(), 100.0 * coverage.upper());
}

std::string FitsText(const std::vector<RecoveredSeed>& seeds) {
  int converged = 0;
  double iterations = 0.0, fitted = 0.0, held_out = 0.0, noise = 0.0;
  for (const RecoveredSeed& seed : seeds) {
    if (seed.status == FitStatus::kConverged) ++converged;
    iterations += seed.iterations;
    fitted += seed.marker_rms;
    held_out += seed.held_out_rms;
    noise += seed.noise_factor;
  }
  const double n = static_cast<double>(seeds.size());
  return fmt::format(
      "{} of {} fits converged, in {:.1f} iterations on average. Markers: rms {:.3f} mm in the "
      "fitted frames, {:.3f} mm in the held-out ones. Noise factor {:.3f}.\n",
      converged, seeds.size(), iterations / n, 1e3 * fitted / n, 1e3 * held_out / n, noise / n);
}

}  // namespace

std::string RecoveryAsCsv(const std::vector<RecoveredSeed>& seeds) {
  std::string text =
      "seed,status,parameter,unit,truth,start,estimate,lower95,upper95,determined,covered,error,"
      "z\n";
  for (const RecoveredSeed& seed : seeds) {
    for (const RecoveredParameter& p : seed.parameters) {
      text += fmt::format("{},{},{},{},{},{},{:.8g},{:.8g},{:.8g},{},{},{:.6g},{:.6g}\n", seed.seed,
                          ToString(seed.status), p.name, p.unit, p.truth, p.start, p.estimate,
                          p.lower95, p.upper95, p.determined ? 1 : 0, p.IsCovered() ? 1 : 0,
                          p.error, p.z);
    }
  }
  return text;
}

std::string RecoveryAsMarkdown(const std::vector<RecoveredSeed>& seeds) {
  if (seeds.empty()) return "No seeds.\n";
  std::string text =
      "| parameter | truth | start | determined | in the 95 % interval | mean error | spread | "
      "reported sigma | mean abs z |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (std::size_t i = 0; i < seeds.front().parameters.size(); ++i) {
    const ParameterSummary s = Summarise(seeds, i);
    const Coverage coverage = CountCoverage(seeds, s.first.name);
    text += fmt::format(
        "| {} ({}) | {:.4g} | {:.4g} | {}/{} | {}/{} | {:+.3f} | {:.3f} | {:.3f} | {:.2f} |\n",
        s.first.name, s.first.unit, s.first.truth, s.first.start, s.determined, s.count,
        coverage.covered, coverage.total, s.mean_error, s.spread, s.mean_sigma, s.mean_abs_z);
  }
  text += fmt::format("\nOf all determined parameters, {} lie within their 95 % interval.\n\n{}",
                      CoverageText(CountCoverage(seeds)), FitsText(seeds));
  return text;
}

}  // namespace clothfit
