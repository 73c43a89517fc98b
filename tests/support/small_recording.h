// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A small recording made by the simulator itself, with parameters that are known.
#pragma once

#include <map>
#include <string>

#include "tracking/recording/recording.h"

namespace clothfit {

struct SmallRecordingOptions {
  int particles = 6;  // along u and along v
  int frames = 30;
  double marker_noise = 0.0005;  // m, one sigma of each coordinate, by a fixed seed
  // Values that are not the initial ones, by full name.
  std::map<std::string, double> parameters = {{"air_drag.normal", 2.5},
                                              {"bending.stiffness", 1e-4}};
};

// A cloth of 0.4 m x 0.4 m, flat at first, that falls while two handles hold it by its corners and
// swing it; 30 Hz, 16 markers a frame, the last fifth of the frames held out.
Recording MakeSmallRecording(const SmallRecordingOptions& options = {});

}  // namespace clothfit
