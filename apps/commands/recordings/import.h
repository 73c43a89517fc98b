// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The subcommands of clothfit import, and what they share.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "apps/commands/commands.h"
#include "tracking/camera/camera.h"
#include "tracking/recording/folder/start.h"

namespace clothfit {

void AddImportMarkers(CLI::App* import, Action* action);
void AddImportColmap(CLI::App* import, Action* action);
void AddImportOpencv(CLI::App* import, Action* action);
void AddImportVideo(CLI::App* import, Action* action);

// The scene as the command line tells it, for a folder that has no recording.yaml yet.
struct SceneOptions {
  std::vector<double> size, origin, u_axis, v_axis;
  std::optional<double> ground, rate;
  std::optional<int> frames;
  // Of each: camera, u, v (m), x and y (px).
  std::vector<std::tuple<std::string, double, double, double, double>> corners;
  std::vector<std::string> handles;  // NAME=U,V of each, m
  std::optional<double> areal_density;
  double held_out_share = 0.0;

  // With corners, the sheet is placed by these cameras, and `notes` gets how.
  SceneStart Start(const std::vector<Camera>& cameras, std::vector<std::string>* notes) const;
  bool DescribesScene() const;  // beyond what videos say: the rate and the number of frames
};

// Throws InputError where the folder has a recording already, which the options would not change.
void CheckIsNew(const std::filesystem::path& folder);

// --size, --ground, --origin, --u-axis, --v-axis, --corner, --handle, --density, --rate and
// --held-out.
void AddSceneOptions(CLI::App* command, SceneOptions* options);

// The same in all imports.
void AddDensityOption(CLI::App* command, std::optional<double>* areal_density);
void AddHeldOutOption(CLI::App* command, double* share);

// Prints which options are still needed to make a recording, if the folder holds none.
void PrintWhatIsMissing(const std::filesystem::path& folder, const SceneStart& start);

}  // namespace clothfit
