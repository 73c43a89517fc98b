// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether frames that no fit has seen are predicted better.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/held_out_proof.h"
#include "fitting/diagnosis/rows.h"

namespace clothfit {

// Times a held-out error: no worse than that.
inline constexpr double kAsGood = 1.05;

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
inline constexpr int kMarkers = -1;

// How far what one source saw in the held-out frames is from a motion that follows everything else
// that was seen, there too: all other markers and tracks pull at the cloth (Start::kGuided). What
// is wrong with one source shows in that whatever becomes of an open-loop prediction. Markers (m),
// a camera's tracks (px). Empty where it saw nothing, or nothing else did.
std::optional<HeldOutErrors> MeasureAgainstOthers(const FittedScene& fitted, int source);

// How far apart two models have what is seen in held-out frames, root mean square: markers (m)
// where there are any, else tracks (px), else 0. Both of one recording. Infinite where one of them
// fails before the last frame.
double HeldOutDistance(const FittedScene& a, const FittedScene& b);

// Errors that no model of the physics takes away, in the unit of the errors.
struct HeldOutFloor {
  double noise = 0.0, numerical = 0.0;  // of the observations; of mesh and step
};
// By how much the root mean square is lower, and the lower end of its one-sided 95 % interval, by
// a moving-block bootstrap (Kuensch 1989) of the frames with blocks of this many. Proven is what
// lies above a twentieth of the noise, and whose squares fall by more than those of the numerical
// floor.
HeldOutProof Prove(const HeldOutErrors& before, const HeldOutErrors& after, int block,
                   const HeldOutFloor& floor, std::uint64_t seed);

// Holds out the last share of the frames where the recording holds none out.
Recording WithHeldOutFrames(const Recording& recording, double share);

}  // namespace clothfit
