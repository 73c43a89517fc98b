// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/default_effects.h"

#include "autodiff_sim/term/extent.h"

namespace clothfit {
namespace {

constexpr double kDuration = 2.5;                       // s, of the fast motions
constexpr std::array<double, 3> kSigmas = {0.3, 1, 3};  // small, middle, large
constexpr int kFoldNodes = 4;                           // of a term that acts on folds

struct Stage {
  std::array<SyntheticScenario, 2> motions;
  Fabric fabric;
};

// Folds show in a stiff cloth that is lifted, strains in a knit that hangs, and what comes from
// outside in a cloth that hangs and swings or turns.
Stage StageOf(const TermInfo& term) {
  constexpr std::array kLifts = {SyntheticScenario::kCornerLift, SyntheticScenario::kTwoCornerLift};
  if (term.needs == Needs::kGround) return {kLifts, Fabric::kWoven};
  if (term.internal && term.nodes == kFoldNodes) return {kLifts, Fabric::kStiff};
  if (term.internal) {
    return {{SyntheticScenario::kTwoCornerSwing, SyntheticScenario::kFourCornerSag}, Fabric::kKnit};
  }
  return {{SyntheticScenario::kTwoCornerSwing, SyntheticScenario::kTwoCornerTurn}, Fabric::kWoven};
}

// About what the cloth passes through: it hangs below its handles, or lies on the ground.
Extent ExtentOf(SyntheticScenario scenario) {
  constexpr int kSamples = 20;
  const Eigen::Vector2d size(kTrialClothSize, kTrialClothSize);
  const SyntheticMotion motion = MakeSyntheticMotion(scenario, size, kDuration);
  Extent extent{motion.handles.front().path(0.0), motion.handles.front().path(0.0), size,
                kDuration};
  for (const SyntheticHandle& handle : motion.handles) {
    for (int i = 0; i <= kSamples; ++i) {
      const Eigen::Vector3d place = handle.path(kDuration * i / kSamples);
      extent.low = extent.low.cwiseMin(place);
      extent.high = extent.high.cwiseMax(place);
    }
  }
  extent.low.z() = motion.ground_height.value_or(extent.low.z() - kTrialClothSize);
  return extent;
}

// The first parameter that switches the term on; of a vector, the one across a hanging cloth.
const Parameter* AmountOf(const TermInfo& term) {
  const Parameter* first = nullptr;
  for (const Parameter& p : term.parameters) {
    if (!SwitchesOff(p)) continue;
    if (first == nullptr) first = &p;
    if (first->meaning == Meaning::kVectorX && p.meaning == Meaning::kVectorY) return &p;
  }
  return first;
}

}  // namespace

std::vector<PlantableEffect> DefaultEffects(const TermInfo& term) {
  const Parameter* amount = AmountOf(term);
  if (amount == nullptr || term.needs == Needs::kObstacles) return {};
  std::array<double, 3> amounts;
  for (std::size_t i = 0; i < amounts.size(); ++i) amounts[i] = AwayFromOff(*amount, kSigmas[i]);
  const bool either_sign = amount->off == 0.0 && amount->lower <= -amounts.back();
  const Stage stage = StageOf(term);
  std::vector<PlantableEffect> effects;
  for (const SyntheticScenario motion : stage.motions) {
    effects.push_back({term.name,
                       motion,
                       stage.fabric,
                       {{amount->name, amounts}},
                       MiddleShape(term, ExtentOf(motion)),
                       either_sign});
  }
  return effects;
}

}  // namespace clothfit
