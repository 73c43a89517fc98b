// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a recording's cloth passes through, and values of a term's parameters that make sense there:
// for a term of which nothing is known but what it says of itself.
#pragma once

#include <map>
#include <string>

#include <Eigen/Core>

#include "autodiff_sim/term/force_batch.h"

namespace clothfit {

struct Extent {
  Eigen::Vector3d low, high;                    // m, world
  Eigen::Vector2d size;                         // m, of the cloth
  double duration = 0.0;                        // s
  Eigen::Vector3d gravity = {0.0, 0.0, -9.81};  // m/s^2, world
};

// A share of what was recorded (see Probes) as a value in the parameter's unit. Places along a
// tilted direction are those at no tilt.
double AtShare(const Parameter& parameter, double share, const Extent& extent);

// A parameter's value that many sigmas of its default prior away from `off`, within its bounds: to
// more where there is room, else to less.
double AwayFromOff(const Parameter& parameter, double sigmas);

// Each parameter that only shapes the term's force, by its name within the term, at the middle one
// of its probes; upright where they tilt.
std::map<std::string, double> MiddleShape(const TermInfo& term, const Extent& extent);

}  // namespace clothfit
