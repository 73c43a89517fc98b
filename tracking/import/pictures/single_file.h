// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of which a recording has one a camera: videos/CAMERA.* and background/CAMERA.*.
#pragma once

#include <filesystem>
#include <string>

#include "tracking/files/output_folder.h"

namespace clothfit {

// Throws InputError where the camera has another file in this folder of the recording, by whatever
// extension, that is not to be replaced.
void CheckMayCopySingle(const std::filesystem::path& file, const std::string& folder,
                        const std::string& camera, const OutputFolder& recording);

// Copies the file there, with its own extension, and removes those that it replaces.
void CopySingle(const std::filesystem::path& file, const std::string& folder,
                const std::string& camera, OutputFolder* recording);

}  // namespace clothfit
