// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The recording made of a take of optical motion capture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tracking/import/markers/marker_take.h"
#include "tracking/recording/recording.h"

namespace clothfit {

constexpr int kTakeParticles = 21;  // along the longer side of the cloth

struct TakeOptions {
  // Markers that something holds: MARKER or NAME=MARKER. "none" alone: nothing is held. Empty: they
  // are found (held_markers.h).
  std::vector<std::string> handles;
  std::vector<std::string> obstacles;         // shapes of rigid bodies (obstacles.h)
  std::vector<std::string> ignored;           // markers to leave out
  std::optional<LayoutByName> layout;         // empty: found from the distances
  std::filesystem::path layout_file;          // where the layout stands, for messages
  std::optional<Eigen::Vector2d> size;        // m; empty: what the markers span, and the margin
  std::optional<double> margin;               // m of cloth beyond the outermost markers
  std::optional<Eigen::Vector2i> resolution;  // particles; empty: kTakeParticles
  std::optional<double> areal_density;        // kg/m^2
  std::optional<double> ground_height;        // m
  std::optional<double> marker_sigma;         // m; empty: from the jitter and the layout
  int every = 1;                              // of so many frames one is kept
  double held_out_share = 0.0;                // of the frames, at the end
  double least_seen = 0.2;   // a marker seen in a smaller share of them is left out
  bool snap_to_grid = true;  // where a grid explains the layout that was found
};

struct ImportedTake {
  Recording recording;
  std::vector<std::string> marker_names;  // of the markers and handles, as in the file
  std::vector<Eigen::Vector2d> uv;        // m, theirs
  std::vector<std::string> notes;         // what was found and decided, one sentence each
};

// The recording begins at the first frame that has every marker, which is also where its cloth is
// placed. A marker is off by its jitter and by what its place on the cloth is off, which the
// layout's rms tells; both make its sigma. Throws InputError where a name is unknown, there are
// fewer than four markers, no frame has all of them, or they do not fit on the cloth.
ImportedTake MakeTakeRecording(MarkerTake take, const TakeOptions& options);

}  // namespace clothfit
