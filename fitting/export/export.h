// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A run's motion, or its cloth, in the files of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/export/overlay_video.h"

namespace clothfit {

struct ExportFormat {
  std::string name;       // "gltf", "pc2", ...
  std::string extension;  // of the file, or of each file of a sequence
  bool is_sequence;       // a folder with one file a frame
  std::string doc;
};
const std::vector<ExportFormat>& ExportFormats();

// Writes the file, or into the folder 000000.obj and so on, and returns how many frames. Throws
// InputError where the run lacks what is needed or the place cannot be written. `format`: the name
// of one of the formats.
int ExportRun(const RunFolder& run, const std::string& format, const OverlayOptions& overlay,
              const std::filesystem::path& output, Overwrite overwrite = Overwrite::kRefuse);

}  // namespace clothfit
