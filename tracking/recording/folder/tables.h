// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The CSV files of a recording, read and written. Readers throw InputError on malformed rows; what
// the values must satisfy is checked by CheckRecording, which is told the lines for its messages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

// Lines of markers.csv and tracks.csv that the entries of a Recording stem from.
struct ObservationLines {
  std::vector<int> markers;
  std::vector<int> tracks;
};

// Rows without a position are left out.
std::vector<Marker> ReadMarkers(const std::filesystem::path& file, std::vector<int>* lines);
std::vector<Track> ReadTracks(const std::filesystem::path& file, const Recording& recording,
                              std::vector<int>* lines);

// The path has recording.frame_count entries. A row without a position is as good as no row.
HandleDescription::Path ReadHandlePath(const std::filesystem::path& file,
                                       const Recording& recording);
// A pose for every frame.
std::vector<ObstacleDescription::Pose> ReadObstaclePath(const std::filesystem::path& file,
                                                        const Recording& recording);
std::vector<PlacedPoint> ReadPlacedPoints(const std::filesystem::path& file);

std::string MarkersAsCsv(const std::vector<Marker>& markers);
std::string TracksAsCsv(const Recording& recording);
std::string HandlePathAsCsv(const HandleDescription::Path& path);
std::string ObstaclePathAsCsv(const std::vector<ObstacleDescription::Pose>& path);
std::string PlacedPointsAsCsv(const std::vector<PlacedPoint>& points);

}  // namespace clothfit
