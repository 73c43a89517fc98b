// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// C3D, the binary format of motion capture laboratories.
// Reference: The C3D File Format, A Technical User Guide (Motion Lab Systems 2021; c3d.org).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/import/markers/take_in_file.h"

namespace clothfit {

// Whether these bytes begin as C3D does.
bool IsC3d(std::string_view bytes);

// Reads the points, of all three processors, as integers or floats. A point of a residual below
// zero, or whose coordinates are no numbers, is lost. Angles, forces, moments, powers and scalars
// that models computed (POINT:ANGLES, ...) are left out; analog data are passed over. Up is
// POINT:Y_SCREEN. Sizes are checked against the file before memory is taken. Throws InputError with
// the offset in bytes; with `skip_bad_rows`, frames that the file ends before are left out.
TakeInFile ReadC3d(const std::filesystem::path& file, std::string_view bytes,
                   const TakeFileOptions& options, std::vector<std::string>* notes);

}  // namespace clothfit
