// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What to record next: the motion in which models that one recording cannot tell apart would differ
// most.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clothfit {

struct FittedScene;

struct SeparatingMotion {
  std::string motion;  // "turned by 90 degrees about the vertical"
  // Between the first model and the nearest of the others, root mean square over particles and
  // frames, in that motion and in the one that was recorded, m.
  double apart = 0.0, apart_here = 0.0;
};

// Each model with its own material parameters and handles is simulated open loop in the recording's
// own motion, in that turned about the vertical by 90 and by 180 degrees, twice and half as fast,
// and held still at its start. What is tied to the world stays where it is. A motion in which one
// of them fails, or which an obstacle of the recording may be in the way of, is left out. Empty
// where there are fewer than two models, or none can be compared.
std::optional<SeparatingMotion> FindSeparatingMotion(const std::vector<const FittedScene*>& models);

// One sentence for people.
std::string Describe(const SeparatingMotion& separating);

}  // namespace clothfit
