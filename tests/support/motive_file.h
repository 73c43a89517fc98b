// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes of a bent sheet with markers, and files as OptiTrack Motive would export them.
#pragma once

#include <string>
#include <vector>

#include "tracking/import/markers/marker_take.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// Markers at these (u, v), in metres, on a sheet that is bent about one direction after another and
// never stretched. Every distance is once that along the sheet. The markers are named m0, m1, ...;
// 60 frames at 120 Hz, with gaussian noise (m) of a fixed seed.
MarkerTake BentSheetTake(const std::vector<Eigen::Vector2d>& uv, double noise = 0.0);

// The take as CSV with y up; coordinates are divided by metres_per_unit.
std::string MotiveCsv(const MarkerTake& take, const std::string& units = "Meters",
                      double metres_per_unit = 1.0);

// The take that a recording would have come from, its handles first.
MarkerTake TakeOfRecording(const Recording& recording);

// Largest distance (m) between two layouts, after the move and turn, and mirroring where `mirror`,
// that brings them together.
double LayoutDifference(const std::vector<Eigen::Vector2d>& a,
                        const std::vector<Eigen::Vector2d>& b, bool mirror = false);

}  // namespace clothfit
