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

// Reads the columns of type Marker, labelled or not; rigid bodies, bones and where they expect
// their markers are no measurements and left alone. Turned to z up, lengths in metres. Throws
// InputError on anything malformed, an unknown unit, or where there is no marker.
MarkerTake ReadMotiveTake(const std::filesystem::path& file, UpAxis up = UpAxis::kY);

}  // namespace clothfit
