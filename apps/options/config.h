// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The options by which several commands name a recording and change its config.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "fitting/config/config.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct ConfigOptions {
  std::string recording;                       // empty: the config file names it
  std::string config;                          // empty: the defaults
  std::vector<std::string> set;                // term.parameter=value
  std::vector<std::string> without;            // terms
  std::vector<std::string> fix, free;          // terms or full names
  std::optional<std::vector<int>> resolution;  // particles along u and v
  bool self_contact = false;
  bool keep_outliers = false;  // gross errors of markers and tracks
};

// RECORDING, --config, --set, --without, --self-contact, --resolution and --keep-outliers, in the
// group kModelGroup. `recordings`, where given, takes one RECORDING or more instead.
void AddConfigOptions(CLI::App* command, ConfigOptions* options,
                      std::vector<std::string>* recordings = nullptr);
// --free and --fix, in the same group.
void AddFreeOptions(CLI::App* command, ConfigOptions* options);
inline constexpr const char* kModelGroup = "The model";

// Options that are added to the command from here on stand under this title in its help.
void BeginGroup(CLI::App* command, const std::string& title);
// Shows in the help that a key of the config, "strategy.window", stands where this is left out,
// and `otherwise` after it; returns `option`.
CLI::Option* DefaultIsKey(const std::string& key, CLI::Option* option,
                          const std::string& otherwise = "");

// --frames A B and --every N: which frames are fitted.
struct FramesOptions {
  std::optional<std::vector<int>> range;
  std::optional<int> every;
};
void AddFramesOptions(CLI::App* command, FramesOptions* frames);
void TakeFrames(const FramesOptions& frames, FitConfig* config);

// --threads N, of this process; what it does is the same for any number.
void AddThreadLimit(CLI::App* command);

// FitConfig::Check of what the command line has changed: names the option where one sets the key.
void CheckConfig(const FitConfig& config);

// Reads the recording that the options, or their config file, name.
Recording ReadRecordingOf(const ConfigOptions& options);

// The defaults, then the config file, then --without, --set, --fix and --free in this order, of the
// last two terms before single parameters. Not yet checked as a whole.
FitConfig ReadConfigOf(const ConfigOptions& options, const Recording& recording);

// Leaves the recording's gross errors out, unless the config keeps them, and tells them on stderr,
// unless it is to be quiet.
void LeaveOutOutliers(const FitConfig& config, Recording* recording, bool quiet = false);
// Tells what was left out. `name`: of one of several recordings.
void PrintOutliers(const Recording& recording, const std::string& name = "");

// Prints what is worth knowing about the recording to the standard error.
void PrintWarnings(const Recording& recording, const std::string& name = "");
void PrintWarnings(const Scene& scene, const std::string& name = "");

}  // namespace clothfit
