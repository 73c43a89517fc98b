// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far what was seen in held-out frames is from what is predicted there.
#pragma once

#include <optional>
#include <vector>

#include "fitting/diagnosis/fitted/rows.h"

namespace clothfit {

// Mean squared errors of single held-out frames: of markers (m^2) where there are any, else of
// tracks (px^2), else pixels in which silhouettes differ, squared.
struct HeldOutErrors {
  std::vector<double> squared;  // one a held-out frame that was observed
  bool is_complete = false;     // the simulation got there
  double Rms() const;
};

// One open-loop simulation at what was fitted, through all frames or up to `last`.
HeldOutErrors MeasureHeldOut(const FittedScene& fitted, std::optional<int> last = std::nullopt);

// The source of an observation: a camera's index, or the markers.
inline constexpr int kMarkerSource = -1;

// Errors of one source in the held-out frames: the distance of its markers (m) or tracks (px) from
// a nudged motion that follows all other markers and tracks in all frames. It
// shows a fault of the source even if an open-loop prediction is poor. Empty where the source, or
// all others, saw nothing.
std::optional<HeldOutErrors> MeasureAgainstOthers(const FittedScene& fitted, int source);

// How far apart two models have what is seen in held-out frames, root mean square: markers (m)
// where there are any, else tracks (px), else 0. Both of one recording. Infinite where one of them
// fails before the last frame.
double HeldOutDistance(const FittedScene& a, const FittedScene& b);

// Holds out the last share of the frames where the recording holds none out.
Recording WithHeldOutFrames(const Recording& recording, double share);

}  // namespace clothfit
