// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/records/run_record.h"

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/files/npy_file.h"
#include "fitting/report/records/record_file.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json ReadSummary(const fs::path& file) {
  Json summary = ReadRecordFile(file, "so fit again");
  for (const char* key : {"status", "fit", "held_out", "before", "frames", "parameters"}) {
    if (!summary.contains(key)) {
      throw InputError(file.string(),
                       fmt::format("{} is missing; expected what 'clothfit fit' writes", key));
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

}  // namespace

RunRecord ReadRunRecord(const RunFolder& run) {
  const auto require = [&run](const char* name) {
    return RequireFile(run.path() / name, "the run of a fit that has ended");
  };
  RunRecord record;
  record.summary = ReadSummary(require("summary.json"));
  record.config = ReadTextFile(require("config.yaml"));
  require("parameters.yaml");
  record.log = ReadTextFile(require("log.txt"));
  record.progress = ReadProgress(run.path() / "progress.csv");
  record.trajectory = ReadPointsNpy(require("trajectory.npy"));
  return record;
}

Json ReadJointSummary(const std::filesystem::path& folder) {
  const std::filesystem::path file =
      RequireFile(folder / "summary.json", "a fit of several recordings that has ended");
  Json summary = ReadRecordFile(file, "so fit again");
  for (const char* key : {"status", "recordings", "parameters"}) {
    if (!summary.contains(key))
      throw InputError(file.string(), fmt::format("{} is missing; expected what 'clothfit fit' "
                                                  "writes of several recordings",
                                                  key));
  }
  return summary;
}

}  // namespace clothfit
