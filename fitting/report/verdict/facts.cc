// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/verdict/facts.h"

#include <cmath>
#include <string>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/rugged_cost.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> NumberAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

void AddErrors(const Json& summary, bool held_out, std::vector<ErrorChange>* errors) {
  const char* const split = held_out ? "held_out" : "fit";
  const Json& after = summary.at(split);
  const Json before = summary.at("before").value(split, Json::object());
  const char* const keys[][3] = {{"markers", "m", "marker_rms_m"},
                                 {"tracks", "px", "track_rms_px"},
                                 {"clouds", "m", "cloud_rms_m"},
                                 {"silhouettes", "px", "silhouette_error_px"}};
  for (const auto& [kind, unit, key] : keys) {
    const ErrorChange change{kind, held_out, unit, NumberAt(before, key), NumberAt(after, key)};
    if (change.before || change.after) errors->push_back(change);
  }
}

}  // namespace

std::optional<Misfit> MisfitOf(const Json& summary) {
  const auto found = summary.find("misfit");  // no earlier version has it
  if (found == summary.end() || !found->is_object()) return std::nullopt;
  Misfit misfit;
  misfit.observed = found->value("observed", 0);
  misfit.chi_square = NumberAt(*found, "chi_square").value_or(NAN);
  misfit.limit = NumberAt(*found, "limit").value_or(NAN);
  misfit.correlation = NumberAt(*found, "correlation").value_or(1.0);
  misfit.discretisation = NumberAt(*found, "discretisation");
  misfit.amplitude = NumberAt(*found, "amplitude");
  misfit.without_discretisation = NumberAt(*found, "without_discretisation");
  return misfit;
}

std::vector<ErrorChange> ErrorsOf(const Json& summary) {
  std::vector<ErrorChange> errors;
  AddErrors(summary, false, &errors);
  AddErrors(summary, true, &errors);
  return errors;
}

VerdictFacts FactsOf(const RunRecord& record) {
  const Json& summary = record.summary;
  VerdictFacts facts;
  facts.status = summary.at("status").get<std::string>();
  facts.errors = ErrorsOf(summary);
  facts.noise_factor = NumberAt(summary, "noise_factor");
  facts.recorded_frames = summary.at("frames").value("recorded", 0);
  facts.misfit = MisfitOf(summary);
  const Json none = Json::object();
  facts.put_right = summary.value("put_right", "");
  facts.left_out = summary.value("left_out", none).value("in_words", "");
  if (const auto places = summary.find("marker_places");
      places != summary.end() && !places->is_null())
    facts.marker_places = places->value("in_words", "");
  facts.lack_of_support = summary.value("lack_of_support", "");
  facts.rugged_cost = RuggedCostAmong(summary.value("statements", std::vector<std::string>()));
  facts.unknown_handles = summary.value("unknown_in_held_out_frames", std::vector<std::string>());
  facts.recording = summary.value("recording", none).value("path", "");
  facts.simulated_frames = summary.at("frames").value("simulated", 0);
  facts.is_predicted = summary.at("frames").value("fitted", 1) == 0;
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const auto& [name, estimate] : summary.at("parameters").items()) {
    if (!estimate.value("free", false) || FindParameter(table, name) < 0) continue;
    ++facts.num_free;
    if (estimate.at("determined") == false) facts.undetermined.push_back(name);
    if (estimate.at("at_bound") == true) facts.at_bound.push_back(name);
  }
  return facts;
}

}  // namespace clothfit
