// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether frames that no fit has seen are predicted better.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/diagnosis.h"
#include "fitting/diagnosis/rows.h"

namespace clothfit {

// Mean squared errors of single held-out frames: of markers (m^2) where there are any, else of
// tracks (px^2), else pixels in which silhouettes differ, squared.
struct HeldOutErrors {
  std::vector<double> squared;  // one a held-out frame that was observed
  bool is_complete = false;     // the simulation got there
  double Rms() const;
};

// One open-loop simulation at what was fitted, through all frames.
HeldOutErrors MeasureHeldOut(const FittedScene& fitted);

// By how much the root mean square is lower, and the lower end of its one-sided 95 % interval, by
// a moving-block bootstrap (Kuensch 1989) of the frames with blocks of this many. `floor`: what is
// left of errors in any case; the improvement has to be above a twentieth of it too.
HeldOutProof Prove(const HeldOutErrors& before, const HeldOutErrors& after, int block, double floor,
                   std::uint64_t seed);

// Holds out the last share of the frames where the recording holds none out.
Recording WithHeldOutFrames(const Recording& recording, double share);

}  // namespace clothfit
