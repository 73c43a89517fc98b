// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far each planted effect moves the cloth: an effect is a fair trial only where it shows.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fitting/trials/plan.h"

namespace clothfit {

struct MeasuredEffect {
  std::string term;
  SyntheticScenario motion = SyntheticScenario::kTwoCornerSwing;
  Fabric fabric = Fabric::kWoven;
  // By size: root mean square over frames and a grid of points, m; empty where the plan has no such
  // trial or it was not simulated.
  std::array<std::optional<double>, 3> moved;
  std::string problem;  // what went wrong, if anything did
};

// The effects of a plan's trials with one effect, each motion and size once, in the plan's order:
// how far a cloth of the typical fabric is from where it would be without the effect.
// `done` gets the share that is done, from one thread at a time. Effects after a stop are left out.
std::vector<MeasuredEffect> MeasureEffects(const std::vector<Trial>& trials, int num_threads,
                                           const std::function<void(double share)>& done = {},
                                           const std::atomic<bool>* stop = nullptr);

std::string EffectsAsMarkdown(const std::vector<MeasuredEffect>& effects);

}  // namespace clothfit
