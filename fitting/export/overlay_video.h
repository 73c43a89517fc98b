// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What one camera saw, with the outline of the simulated cloth drawn over it, as a video.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/export/run_motion.h"

namespace clothfit {

struct OverlayOptions {
  std::filesystem::path pictures;  // a recording; empty: where the run's recording has them
  std::string camera;              // empty: the first
};

// Writes an .mp4 (MPEG-4 part 2) or .avi (Motion JPEG) file with the frames that the simulation
// reached and the camera has a picture of. Throws InputError where there is no such camera or no
// picture, or the file cannot be written.
void WriteOverlayVideo(const RunFolder& run, const RunMotion& motion, const OverlayOptions& options,
                       const std::filesystem::path& file, Overwrite overwrite);

}  // namespace clothfit
