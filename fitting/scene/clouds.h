// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The clouds and depth pictures of a recording, thinned to what a fit takes of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/recording/recording.h"

namespace clothfit {

// Points of the surface in one frame, of which nobody knows where on the cloth they are.
struct CloudObservation {
  int frame = 0;
  std::optional<int> camera;            // that saw them; empty: they show the whole cloth
  std::vector<Eigen::Vector3d> points;  // m, world
  // m: about how far apart the points are. The edge of the cells of which each has one of them, or
  // as much as it takes for the points to be spread over the whole cloth, whichever is more.
  double spacing = 0.0;
};

struct Clouds {
  std::vector<CloudObservation> observations;  // by frame; none of them empty
  std::vector<std::string> warnings;           // on those that are, one line
  int most_points = 0;                         // of each
};

// Reads all clouds and depth pictures, and keeps at most so many points of each. Throws InputError
// as LoadCloud and LoadDepth.
Clouds LoadClouds(const Recording& recording, int most_points);

}  // namespace clothfit
