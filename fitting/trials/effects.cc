// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/effects.h"

#include <algorithm>
#include <stdexcept>

#include "autodiff_sim/terms/air_drag.h"
#include "autodiff_sim/terms/bending.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "autodiff_sim/terms/shear.h"
#include "autodiff_sim/terms/spring.h"
#include "fitting/diagnosis/evidence/candidates.h"
#include "fitting/trials/chosen_effects.h"
#include "fitting/trials/default_effects.h"
#include "fitting/trials/terms/trial_terms.h"

namespace clothfit {
namespace {

using Effects = std::vector<PlantableEffect>;

// The rows, and those that follow from what a term says of itself for each term without one.
Effects WithDefaults(Effects rows, const std::vector<TermInfo>& terms) {
  for (const TermInfo& term : terms) {
    const bool has_row = std::any_of(rows.begin(), rows.end(), [&](const PlantableEffect& row) {
      return row.term == term.name;
    });
    if (has_row) continue;
    const Effects more = DefaultEffects(term);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace

std::string ToString(EffectSize size) {
  switch (size) {
    case EffectSize::kSmall:
      return "small";
    case EffectSize::kMiddle:
      return "middle";
    case EffectSize::kLarge:
      break;
  }
  return "large";
}

std::string ToString(Fabric fabric) {
  switch (fabric) {
    case Fabric::kWoven:
      return "woven";
    case Fabric::kKnit:
      return "knit";
    case Fabric::kStiff:
      break;
  }
  return "stiff";
}

std::map<std::string, double> TypicalParameters(Fabric fabric) {
  std::map<std::string, double> typical;
  switch (fabric) {
    case Fabric::kWoven:
      typical = ValuesOf<StretchSpring, Shear, Bending, AirDrag>({400.0, 0.6}, {8.0, 0.2},
                                                                 {4e-5, 3e-6}, {0.5, 1.0, 0.04});
      break;
    case Fabric::kKnit:
      typical = ValuesOf<StretchSpring, Shear, Bending, AirDrag>({40.0, 0.6}, {12.0, 0.3},
                                                                 {3e-5, 3e-6}, {0.4, 1.0, 0.04});
      break;
    case Fabric::kStiff:
      typical = ValuesOf<StretchSpring, Shear, Bending, AirDrag>({600.0, 1.0}, {20.0, 0.4},
                                                                 {5e-4, 8e-6}, {0.5, 1.0, 0.04});
      break;
  }
  typical["cloth.areal_density"] = fabric == Fabric::kWoven ? 0.15 : 0.2;
  return typical;
}

const Effects& ListedEffects() {
  static const Effects effects = WithDefaults(ChosenEffects(), AbsentTerms());
  return effects;
}

const Effects& UnlistedEffects() {
  static const Effects effects = WithDefaults(ChosenUnlistedEffects(), UnlistedTerms());
  return effects;
}

std::vector<TermInfo> AbsentTerms() {
  std::vector<TermInfo> absent;
  for (const TermInfo& term : AllTerms()) {
    if (term.role == Role::kMayBeMissing) absent.push_back(term);
  }
  return absent;
}

const TermInfo& TermOf(const std::string& name) {
  static const std::vector<TermInfo> all = [] {
    std::vector<TermInfo> terms = AllTerms();
    const std::vector<TermInfo> more = UnlistedTerms();
    terms.insert(terms.end(), more.begin(), more.end());
    return terms;
  }();
  for (const TermInfo& term : all) {
    if (term.name == name) return term;
  }
  throw std::out_of_range("no term " + name);
}

bool IsListed(const std::string& name) {
  return std::any_of(AllTerms().begin(), AllTerms().end(),
                     [&](const TermInfo& term) { return term.name == name; });
}

EffectClass ClassOf(const std::string& name) {
  const TermInfo& term = TermOf(name);
  EffectClass effect;
  effect.is_internal = term.internal;
  effect.is_dissipative = term.work == Work::kDissipates;
  effect.is_driving = term.work == Work::kDrives;
  for (const Tie tie : term.ties) effect.tied_to.emplace_back(ToString(tie));
  return effect;
}

}  // namespace clothfit
