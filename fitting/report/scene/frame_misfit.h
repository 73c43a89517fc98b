// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far one simulation is from what was observed, frame by frame.
#pragma once

#include <optional>
#include <vector>

#include "fitting/report/scene/scene.h"

namespace clothfit {

// Empty where the frame has no such observation, or was not reached.
struct FrameMisfit {
  std::optional<double> markers;      // m, root mean square
  std::optional<double> tracks;       // px, root mean square
  std::optional<double> clouds;       // m, of clouds' points from the surface, root mean square
  std::optional<double> silhouettes;  // px that differ, mean over the cameras
  std::optional<double> truth;        // m, root mean square
};

// One a frame of the recording; held-out frames and cameras count as the others.
std::vector<FrameMisfit> MeasureFrames(const ReportScene& report, const Motion& motion);
// One list a motion, in their order.
std::vector<std::vector<FrameMisfit>> MeasureMotions(const ReportScene& report);

}  // namespace clothfit
