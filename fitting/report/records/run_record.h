// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a finished fit left in its folder, checked to be complete.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "fitting/runs/run_folder.h"

namespace clothfit {

// One iteration, a row of progress.csv.
struct ProgressRow {
  std::string stage;
  int iteration = 0;
  double cost = 0.0;
  double simulated_frames = 0.0;  // of the stage so far
  double seconds = 0.0;           // since the fit began
};

struct RunRecord {
  nlohmann::ordered_json summary;
  std::string config, log;                  // the files' text
  std::vector<ProgressRow> progress;        // empty where the run has none
  std::vector<Eigen::VectorXd> trajectory;  // m, one a frame that was simulated
};

// Throws InputError, one line, where a file is missing, damaged or of another version of clothfit.
RunRecord ReadRunRecord(const RunFolder& run);

// summary.json of a fit of several recordings. Throws InputError where it is missing, damaged or of
// another version.
nlohmann::ordered_json ReadJointSummary(const std::filesystem::path& folder);

}  // namespace clothfit
