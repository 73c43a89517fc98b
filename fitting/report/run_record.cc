// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/run_record.h"

#include <optional>

#include "autodiff_sim/error.h"
#include "autodiff_sim/parameter_table.h"
#include "fitting/npy_file.h"
#include "fitting/version.h"
#include "tracking/csv.h"
#include "tracking/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path RequireFile(const RunFolder& run, const char* name) {
  fs::path file = run.path() / name;
  if (fs::exists(file)) return file;
  throw InputError(file.string(), "is missing; expected the run of a fit that has ended");
}

Json ReadSummary(const fs::path& file) {
  Json summary = Json::parse(ReadTextFile(file), nullptr, false);
  if (!summary.is_object()) throw InputError(file.string(), "is damaged; expected a JSON object");
  const std::string version = summary.value("clothfit", "");
  if (version != Version()) {
    throw InputError(file.string(), "was written by clothfit " +
                                        (version.empty() ? "of no known version" : version) +
                                        "; expected " + Version() + ", so fit again");
  }
  for (const char* key : {"status", "fit", "held_out", "before", "frames", "parameters"}) {
    if (!summary.contains(key)) {
      throw InputError(file.string(), std::string(key) +
                                          " is missing; expected what 'clothfit fit'"
                                          " writes");
    }
  }
  return summary;
}

std::vector<ProgressRow> ReadProgress(const fs::path& file) {
  std::vector<ProgressRow> rows;
  if (!fs::exists(file)) return rows;
  ReadCsv(
      file, {"stage", "iteration", "cost", "simulated_frames", "seconds"}, [&](const CsvRow& row) {
        rows.push_back({row.Text(0), row.Integer(1), row.Number(2), row.Number(3), row.Number(4)});
      });
  return rows;
}

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
                                 {"silhouettes", "px", "silhouette_error_px"}};
  for (const auto& [kind, unit, key] : keys) {
    const ErrorChange change{kind, held_out, unit, NumberAt(before, key), NumberAt(after, key)};
    if (change.before || change.after) errors->push_back(change);
  }
}

}  // namespace

RunRecord ReadRunRecord(const RunFolder& run) {
  RunRecord record;
  record.summary = ReadSummary(RequireFile(run, "summary.json"));
  record.config = ReadTextFile(RequireFile(run, "config.yaml"));
  RequireFile(run, "parameters.yaml");
  record.log = ReadTextFile(RequireFile(run, "log.txt"));
  record.progress = ReadProgress(run.path() / "progress.csv");
  record.trajectory = ReadPointsNpy(RequireFile(run, "trajectory.npy"));
  return record;
}

VerdictFacts FactsOf(const RunRecord& record) {
  const Json& summary = record.summary;
  VerdictFacts facts;
  facts.status = summary.at("status").get<std::string>();
  AddErrors(summary, false, &facts.errors);
  AddErrors(summary, true, &facts.errors);
  facts.noise_factor = NumberAt(summary, "noise_factor");
  facts.recorded_frames = summary.at("frames").value("recorded", 0);
  facts.simulated_frames = summary.at("frames").value("simulated", 0);
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
