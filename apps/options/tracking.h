// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracking as the commands offer it.
#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "tracking/features/track_recording.h"

namespace clothfit {

void AddTrackingOptions(CLI::App* command, TrackingOptions* options);

// TrackIntoFolder with progress on the standard error; Ctrl-C ends it early.
TrackingResult TrackWithDisplay(const Recording& recording, const TrackingOptions& options,
                                const std::filesystem::path& folder, Overwrite overwrite,
                                bool quiet);

// Some lines: how much was found, and what the filters threw out.
std::string DescribeTracking(const Recording& recording, const TrackingResult& result);

}  // namespace clothfit
