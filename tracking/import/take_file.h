// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of optical motion capture, whichever program wrote them.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tracking/import/marker_take.h"
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

// Reads a file by its content: C3D, CSV of OptiTrack Motive or Vicon Nexus, TRC, TSV of Qualisys,
// or a plain table (table_formats.h, c3d.h). Turned to z up, lengths in metres.
//
// Markers "BODY:..." of a rigid body are the body's and not among the take's markers: where the
// body expects them, if the file says that, or else where they were measured. A body is what the
// file calls so, or three markers or more of one prefix that keep their distances.
//
// Throws InputError on anything malformed, where there is no marker, and where neither the file
// nor the options say the rate, the unit or which axis points up. `notes` gets a sentence on
// whatever was left out or taken for granted.
MarkerTake ReadTake(const std::filesystem::path& file, const TakeFileOptions& options,
                    std::vector<std::string>* notes);

// m, of "m", "cm", "mm" or their names in English; empty for any other text.
std::optional<double> MetresPerUnit(const std::string& name);

}  // namespace clothfit
