// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The subcommands of clothfit import, and what they share.
#pragma once

#include <optional>
#include <vector>

#include "apps/commands.h"
#include "tracking/recording/start.h"

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

  SceneStart Start() const;
  bool AnyGiven() const;
};

// --size, --ground, --origin, --u-axis, --v-axis and --rate.
void AddSceneOptions(CLI::App* command, SceneOptions* options);

// Prints which options are still needed to make a recording, if the folder holds none.
void PrintWhatIsMissing(const std::filesystem::path& folder, const SceneStart& start);

}  // namespace clothfit
