// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis left in its folder, checked to be complete.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "tracking/recording/recording.h"

namespace clothfit {

struct DiagnosisRecord {
  std::filesystem::path folder;
  nlohmann::ordered_json json;           // diagnosis.json
  std::string verdict, headline, words;  // words begin with the headline
  std::vector<std::string> effects;      // that were found, faults of the observation among them
  // What cannot be told from an effect, itself first: of the first effect, and of each later one
  // that does not stand alone.
  std::vector<std::vector<std::string>> confidence_sets;
  std::array<int, 2> resolution = {0, 0};  // particles of the motions; 0 where there is no grid
  std::optional<Splits::FrameRange> held_out;
  std::string config, log;             // the files' text
  std::vector<Eigen::VectorXd> force;  // N/m^2 by frame: normal, warp, weft of each particle
};

// Throws InputError, one line, where a file is missing, damaged or of another version of clothfit.
DiagnosisRecord ReadDiagnosisRecord(const std::filesystem::path& folder);

}  // namespace clothfit
