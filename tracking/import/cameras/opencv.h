// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A camera from a calibration that OpenCV's FileStorage wrote: YAML, XML or JSON.
#pragma once

#include <filesystem>
#include <optional>

#include <Eigen/Core>

#include "tracking/camera/camera.h"

namespace clothfit {

struct OpencvOptions {
  std::optional<Eigen::Vector2i> image_size;  // px; for a file that does not give it
  bool camera_to_world = false;               // the file's R and t are of that direction
};

// Reads, under the names in use for them, the camera matrix, the distortion (any coefficient beyond
// the fifth has to be zero), the size of the image and the pose: a rotation matrix or vector, and a
// translation in the unit of the calibration. The camera is named by the file's stem. Throws
// InputError on what is missing or malformed.
Camera ReadOpencvCamera(const std::filesystem::path& file, const OpencvOptions& options = {});

}  // namespace clothfit
