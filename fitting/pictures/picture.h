// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted cloth, drawn beside what was measured.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "fitting/runs/prediction.h"

namespace clothfit {

struct PictureOptions {
  std::vector<int> frames;  // one panel each; empty: four, spread over the recording
  double azimuth = 0.6;     // rad, where the view comes from, about the vertical, from -y towards x
  double elevation = 0.25;  // rad above the horizon
  int panel = 420;          // px, width of a panel
  // m, 3N, one a frame: what the upper row shows; empty: the fit's start.
  std::vector<Eigen::VectorXd> before;
  std::array<std::string, 2> titles = {"start", "fit"};  // of the rows
};

// Draws the cloth at the fit's start (upper row) and as fitted (lower row), from afar and to one
// scale, with the measured markers and, red, how far they are from where the simulation has them.
// Obstacles are where the fit has them, in both rows, those that no recording knows of, too;
// orange is where handles hold it along known paths.
// A png or jpg file. Throws InputError where a frame is outside the recording or the file cannot be
// written, std::runtime_error where the simulation does not reach a frame.
void DrawRun(const FittedRun& fitted, const RunFolder& run, const PictureOptions& options,
             const std::filesystem::path& file, Overwrite overwrite);

// One row of a recording that nothing was fitted to: the cloth as the config has it simulated.
// As DrawRun otherwise; options.before and options.titles are not looked at.
void DrawRecording(const FittedRun& unfitted, const PictureOptions& options,
                   const std::filesystem::path& file, Overwrite overwrite);

// A cloth's state as a panel of a picture.
struct ClothPanel {
  std::string title;
  Eigen::VectorXd x;       // m, 3N
  Eigen::Vector3d centre;  // m, of the view
};

// Draws rows of as many panels each, all from afar and to one scale, in which a panel is `width`
// metres wide. As DrawRun otherwise; options.frames is not looked at.
void DrawCloths(const ClothMesh& mesh, const std::vector<std::vector<ClothPanel>>& rows,
                double width, const PictureOptions& options, const std::filesystem::path& file);

}  // namespace clothfit
