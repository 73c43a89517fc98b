// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Many fits in one YAML file:
//
//     config: common.yaml            # for all, may be left out
//     fits:
//       - recording: takes/silk      # relative to the list
//       - recording: takes/wool
//         name: wool-stiff           # else the folder's name
//         config: wool.yaml          # over the common one
//         set: {bending.stiffness: 1e-3}
//         free: [ground.friction]
//         fix: [air_drag]
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fitting/config/config.h"

namespace clothfit {

struct BatchFit {
  std::string name;  // of its run, and in the table
  std::filesystem::path recording;
  std::vector<std::filesystem::path> configs;  // each over the one before
  std::vector<std::string> set;                // term.parameter=value
  std::vector<std::string> free, fix;          // terms or full names
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BatchFit, name, recording, configs, set, free, fix)

// Throws InputError with file, key and value where the list is malformed, two fits have one name,
// or a recording or config cannot be read.
std::vector<BatchFit> ReadBatchList(const std::filesystem::path& file);

// The recording's defaults with all that the list changes.
FitConfig BatchConfig(const BatchFit& fit, const Recording& recording);

}  // namespace clothfit
