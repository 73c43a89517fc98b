// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What tracking finds, as a recording on disk.
#pragma once

#include <filesystem>
#include <optional>

#include "tracking/features/track_recording.h"

namespace clothfit {

// Tracks and writes into the folder what a fit needs, as a recording without pictures:
// recording.yaml, cameras.yaml, handles and the like as they are, masks/ as they are found or
// copied, tracks.csv and markers.csv; beside it pictures.csv, filters.csv and origin.txt. Stopped
// early, the folder holds what was found so far, and recording.yaml is written all the same.
// Throws InputError as TrackRecording and OutputFolder do: where the folder already holds a
// recording (unless allowed; then what clothfit wrote there is replaced) or something else.
TrackingResult TrackIntoFolder(const Recording& recording, const TrackingOptions& options,
                               const std::filesystem::path& folder, Overwrite overwrite,
                               const TrackingCallbacks& callbacks = {});

// The recording whose pictures were tracked into this folder, as origin.txt names it; empty where
// nothing was.
std::optional<std::filesystem::path> OriginOfTracking(const std::filesystem::path& folder);

}  // namespace clothfit
