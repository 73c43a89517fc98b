// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which effects are planted into trials, in which motions, and how large small, middle and large
// are: chosen so that middle moves the cloth by about 5 to 15 mm rms, as docs/studies/trials.md
// measures, within what real cloths, draughts and tables do.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "autodiff_sim/term/force_batch.h"
#include "tracking/synthetic/motion.h"

namespace clothfit {

enum class EffectSize { kSmall, kMiddle, kLarge };
constexpr std::array<EffectSize, 3> kEffectSizes = {EffectSize::kSmall, EffectSize::kMiddle,
                                                    EffectSize::kLarge};
std::string ToString(EffectSize size);  // "small", "middle", "large"

// What a cloth of a trial is made of, about: each parameter is drawn around the typical one.
enum class Fabric {
  kWoven,  // hardly stretches, drapes softly
  kKnit,   // stretches by some per cent under its own weight
  kStiff,  // hardly stretches, bends in wide curves
};
constexpr std::array<Fabric, 3> kFabrics = {Fabric::kWoven, Fabric::kKnit, Fabric::kStiff};
std::string ToString(Fabric fabric);
// Full name -> typical value.
std::map<std::string, double> TypicalParameters(Fabric fabric);

// One effect in one motion in which it shows. The cloth of a trial is kTrialClothSize a side.
constexpr double kTrialClothSize = 0.5;  // m
struct PlantableEffect {
  std::string term;
  SyntheticScenario motion = SyntheticScenario::kTwoCornerSwing;
  Fabric fabric = Fabric::kWoven;
  // By the parameter's name within the term, in its unit: small, middle, large.
  std::map<std::string, std::array<double, 3>> amounts;
  std::map<std::string, double> shape;  // the same at all sizes
  bool either_sign = false;             // are the amounts as likely negative?
};

// Every term of clothfit's list that may be missing, in at least two motions.
const std::vector<PlantableEffect>& ListedEffects();
// Those of terms/.
const std::vector<PlantableEffect>& UnlistedEffects();

// Clothfit's terms that may be missing.
std::vector<TermInfo> AbsentTerms();
// What a term of either list says of itself. Throws std::out_of_range where there is none.
const TermInfo& TermOf(const std::string& term);
bool IsListed(const std::string& term);

// What a diagnosis may say of an effect's class, see DiscrepancyClass. `tied_to` holds all words
// that are right; none where any is.
struct EffectClass {
  bool is_internal = false, is_dissipative = false, is_driving = false;
  std::vector<std::string> tied_to;
};
EffectClass ClassOf(const std::string& term);

}  // namespace clothfit
