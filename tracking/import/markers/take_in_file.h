// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A take as its file has it, before it is turned and scaled: the result of a reader of one format.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tracking/import/markers/marker_take.h"
#include "tracking/text/csv.h"

namespace clothfit {

// What a file says of itself, or a user says of it.
struct TakeFacts {
  std::optional<double> frame_rate;       // Hz
  std::optional<double> metres_per_unit;  // of its lengths
  std::optional<std::string> up;          // its axis that points up: "y" or "-z", for example
};

struct TakeFileOptions {
  TakeFacts facts;             // go before those of the file
  bool skip_bad_rows = false;  // a row that cannot be read has lost all its markers
};

// A take in the units and axes of its file.
struct TakeInFile {
  TakeFacts facts;
  std::vector<MarkerPath> markers;   // equally long paths; distinct names
  std::vector<MarkerPath> expected;  // where rigid bodies have theirs; not measured
  std::set<std::string> bodies;      // names of rigid bodies
};

// Frames times markers that a take may have: they become the rows of its markers.csv.
inline constexpr std::size_t kMostPlaces = kMostTableRows;

// m, of "m", "cm", "mm" or their names in English; empty for any other text.
std::optional<double> MetresPerUnit(const std::string& name);

}  // namespace clothfit
