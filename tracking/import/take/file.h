// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of optical motion capture, whichever program wrote them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracking/import/markers/marker_take.h"
#include "tracking/import/markers/take_in_file.h"

namespace clothfit {

// Reads a file by its content: C3D, CSV of OptiTrack Motive or Vicon Nexus, TRC, TSV of Qualisys,
// or a plain table (tables/formats.h, c3d/c3d.h). Turned to z up, lengths in metres.
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

}  // namespace clothfit
