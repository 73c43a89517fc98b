// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted cloth, drawn beside what was measured.
#pragma once

#include <filesystem>
#include <vector>

#include "fitting/prediction.h"

namespace clothfit {

struct PictureOptions {
  std::vector<int> frames;  // one panel each; empty: four, spread over the recording
  double azimuth = 0.6;     // rad, where the view comes from, about the vertical, from -y towards x
  double elevation = 0.25;  // rad above the horizon
  int panel = 420;          // px, width of a panel
};

// Draws the cloth at the fit's start (upper row) and as fitted (lower row), from afar and to one
// scale, with the measured markers and, red, how far they are from where the simulation has them.
// A png or jpg file. Throws InputError where a frame is outside the recording or the file cannot be
// written, std::runtime_error where the simulation does not reach a frame.
void DrawRun(const FittedRun& fitted, const RunFolder& run, const PictureOptions& options,
             const std::filesystem::path& file);

}  // namespace clothfit
