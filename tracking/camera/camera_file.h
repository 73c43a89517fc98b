// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// cameras.yaml of a recording.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracking/camera/camera.h"

namespace clothfit {

// Throws InputError when the file is missing or malformed, or a K is not that of a pinhole camera.
// What the values must satisfy is checked by CheckRecording.
std::vector<Camera> ReadCameras(const std::filesystem::path& file);

// The text of such a file.
std::string CamerasAsYaml(const std::vector<Camera>& cameras);

// "'lefd' is no camera of cameras.yaml; did you mean 'left'?"
std::string IsNoCamera(const std::string& name, const std::vector<Camera>& cameras);

}  // namespace clothfit
