// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/commands/fits/fit_result_text.h"

#include <fmt/format.h>

#include "autodiff_sim/base/printable.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/rugged_cost.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::string Number(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "-";
}

// One row; nothing where the recording has no such observation.
std::string ErrorRow(const char* label, const char* unit, const std::optional<double>& before,
                     const std::optional<double>& after) {
  if (!before && !after) return "";
  return fmt::format("  {:<24}{:>12}{:>12}  {}\n", label, Number(before), Number(after), unit);
}

std::string ErrorTable(const Evaluation& before, const Evaluation& after) {
  const std::string rows =
      ErrorRow("markers, fitted", "m", before.marker_rms, after.marker_rms) +
      ErrorRow("markers, held out", "m", before.held_out_marker_rms, after.held_out_marker_rms) +
      ErrorRow("tracks, fitted", "px", before.track_rms, after.track_rms) +
      ErrorRow("tracks, held out", "px", before.held_out_track_rms, after.held_out_track_rms) +
      ErrorRow("clouds, fitted", "m", before.cloud_rms, after.cloud_rms) +
      ErrorRow("clouds, held out", "m", before.held_out_cloud_rms, after.held_out_cloud_rms) +
      ErrorRow("silhouettes, fitted", "pixels that differ in a picture, mean",
               before.silhouette_error, after.silhouette_error) +
      ErrorRow("silhouettes, held out", "pixels that differ in a picture, mean",
               before.held_out_silhouette_error, after.held_out_silhouette_error);
  return fmt::format("  {:<24}{:>12}{:>12}\n", "root mean square error", "before", "after") + rows;
}

std::string EstimateRow(const ParameterEstimate& estimate) {
  std::string note;
  if (!estimate.determined) note += "  not determined by the data";
  if (estimate.at_bound) note += "  at its bound";
  return fmt::format(
      "  {:<24}{:>12.4g}{:>12.4g}  {:<26}{}{}\n", estimate.name, estimate.start, estimate.value,
      fmt::format("{:.4g} .. {:.4g}", estimate.lower95, estimate.upper95), estimate.unit, note);
}

// The free physical parameters; the others, which are `of_what`, are only counted.
std::string EstimateTable(const std::vector<ParameterEstimate>& estimates,
                          const std::string& of_what) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  std::string rows, shrinkage;
  int others = 0;
  for (const ParameterEstimate& estimate : estimates) {
    if (!estimate.free) continue;
    if (FindParameter(table, estimate.name) >= 0) {
      rows += EstimateRow(estimate);
      if (StartsWith(estimate.name, "cloth.shrink"))
        shrinkage =
            "  cloth.shrink_*: free, since the markers' places on the cloth are known to some "
            "millimetres only\n";
    } else {
      ++others;
    }
  }
  const std::string head = fmt::format("  {:<24}{:>12}{:>12}  {:<26}{}\n", "parameter", "start",
                                       "value", "95 % interval", "unit");
  std::string text = rows.empty() ? "  all parameters are held at their values\n" : head + rows;
  text += shrinkage;
  if (others > 0) {
    text += fmt::format("  and {} entries of {}\n", others, of_what);
  }
  return text;
}

std::string DescribeWork(const FitResult& result) {
  return fmt::format("{}: {} iterations, {} simulations, {:.1f} s\n\n", ToString(result.status),
                     result.iterations, result.simulations, result.seconds);
}

std::string DescribeStatements(const FitResult& result) {
  const std::string of_verdict = RuggedCostAmong(result.statements);
  std::string text;
  for (const std::string& statement : result.statements)
    if (statement != of_verdict) text += "  " + statement + "\n";
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string DescribeFitResult(const FitResult& result) {
  std::string text = DescribeWork(result);
  text += ErrorTable(result.before, result.after) + "\n" +
          EstimateTable(result.estimates, "handle paths and the initial state");
  return text + DescribeStatements(result);
}

std::string DescribeJointResult(const FitResult& result, const std::vector<std::string>& names) {
  std::string text = DescribeWork(result);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const FitResult& one = result.recordings[i];
    text += fmt::format("{}\n{}", Printable(names[i]), ErrorTable(one.before, one.after));
  }
  return text + "\n" + EstimateTable(result.estimates, "single recordings") +
         DescribeStatements(result);
}

std::string DescribeVerdict(const PageVerdict& verdict) {
  std::string text = verdict.headline + "\n";
  for (const std::string& sentence : verdict.sentences) text += "  " + sentence + "\n";
  return text;
}

}  // namespace clothfit
