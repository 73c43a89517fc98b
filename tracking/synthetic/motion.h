// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What happens in a synthetic recording: where the cloth begins and how its handles move.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/recording/recording.h"

namespace clothfit {

enum class SyntheticScenario {
  kTwoCornerSwing,  // hangs from two corners that swing to and fro, turn, and come closer
  kCornerLift,      // lies on the ground; one corner is lifted and drawn over the cloth
  kTwoCornerLift,   // lies on the ground; both corners of an edge are lifted and swung
  kTwoCornerShake,  // hangs from two corners that shake it, faster than a swing
  kTwoCornerTurn,   // hangs from two corners that turn it by a quarter about the vertical
  kFourCornerSag,   // lies in the air, held by four corners that come closer, rise and sink
};

// The names on the command line: two-corner-swing, corner-lift, two-corner-lift, two-corner-shake,
// two-corner-turn, four-corner-sag.
std::vector<std::string> SyntheticScenarioNames();
std::string ToString(SyntheticScenario scenario);
// Throws InputError, naming `place`, where there is no such scenario.
SyntheticScenario ParseSyntheticScenario(const std::string& place, const std::string& name);

struct SyntheticHandle {
  std::string name;
  Eigen::Vector2d uv;  // m, on the cloth
  // Where it is (m, world) at a time (s). Twice continuously differentiable; at rest at the start.
  std::function<Eigen::Vector3d(double time)> path;
};

struct SyntheticMotion {
  FlatPlacement initial;
  std::optional<double> ground_height;  // m
  std::vector<SyntheticHandle> handles;
};

// For a cloth of this size (m). The motion starts and stops smoothly within `duration` seconds;
// its amplitudes are fixed shares of the size, its frequencies (Hz) do not depend on either.
SyntheticMotion MakeSyntheticMotion(SyntheticScenario scenario, const Eigen::Vector2d& size,
                                    double duration);

}  // namespace clothfit
