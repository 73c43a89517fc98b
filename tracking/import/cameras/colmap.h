// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Cameras of a sparse model that COLMAP wrote as text (cameras.txt and images.txt).
// Reference: COLMAP documentation, "Output Format", and its camera models.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracking/camera/camera.h"

namespace clothfit {

// What becomes a camera: every image under the stem of its name, or every folder of images under
// the folder's, with the pose of its first image.
enum class ColmapNaming { kAutomatic, kStem, kFolder };

struct ColmapCameras {
  std::vector<Camera> cameras;     // by name; poses in COLMAP's world and unit
  std::vector<std::string> notes;  // such as a folder whose images do not share one pose
};

// Automatic naming goes by folder where the images lie in several. COLMAP's pixels have the corner
// of the top-left pixel at (0, 0), ours its centre: the principal point moves by half a pixel.
// Throws InputError on what is missing, malformed or no lens of OpenCV with five coefficients.
ColmapCameras ReadColmapCameras(const std::filesystem::path& folder,
                                ColmapNaming naming = ColmapNaming::kAutomatic);

}  // namespace clothfit
