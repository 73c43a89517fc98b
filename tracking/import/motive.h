// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes exported by OptiTrack Motive as CSV.
// Reference: OptiTrack documentation, "Data Export: CSV"; format versions 1.2 and later.
#pragma once

#include <filesystem>

#include "tracking/import/marker_take.h"

namespace clothfit {

// The axis of the file that points up. Motive's own is y.
enum class UpAxis { kY, kZ };

struct MotiveFileOptions {
  UpAxis up = UpAxis::kY;
  bool skip_bad_rows = false;  // a row that cannot be read has lost all its markers
};

// Reads the columns of type Marker, labelled or not. Markers "BODY:..." of a rigid body are the
// body's and not among the take's markers: where the body expects them (type Rigid Body Marker), or
// else where they were measured. A body is what has a column of type Rigid Body, or three markers
// or more of one prefix that keep their distances. Bones are left alone. Turned to z up, lengths in
// metres. Throws InputError on anything malformed, an unknown unit, or where there is no marker.
// `notes` gets a sentence on the rows that were skipped.
MarkerTake ReadMotiveTake(const std::filesystem::path& file, const MotiveFileOptions& options,
                          std::vector<std::string>* notes);

}  // namespace clothfit
