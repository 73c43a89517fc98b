// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/verdict.h"

#include <algorithm>
#include <cmath>

#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/gate/gate.h"
#include "fitting/diagnosis/model/explained_share.h"

namespace clothfit {
namespace {

// Of what is missing, that an effect explains which is there; what only stands for it explains
// less. Where even a fit with it comes nowhere near the null, half has to do.
constexpr double kMostFromAfar = 0.5;
constexpr double kWorthKeeping = 0.5;  // of what the best of a round gains

bool IsPhysics(const std::string& effect, const Diagnosis& diagnosis) {
  return std::any_of(diagnosis.ranking.begin(), diagnosis.ranking.end(),
                     [&](const Candidate& candidate) {
                       return candidate.name == effect && candidate.kind == CandidateKind::kPhysics;
                     });
}

// Nothing below the discretisation error is ever held against the physics.
Verdict WithoutAnswer(const Diagnosis& diagnosis, bool is_above_discretisation) {
  const bool is_unexplained = diagnosis.gate_p_value < kGate && is_above_discretisation;
  if (!is_unexplained)
    return diagnosis.residual_rms > kLargeResidual ? Verdict::kUndecided : Verdict::kNothingMissing;
  const bool is_fitted = diagnosis.promised < kAtMinimum;
  return is_fitted ? Verdict::kNoneOfTheAbove : Verdict::kUndecided;
}

}  // namespace

double MostOfIt(const Diagnosis& diagnosis) {
  double left = diagnosis.residual_rms;
  if (diagnosis.answer && diagnosis.baseline_fit.cost_after > 0.0)
    left *= std::sqrt(diagnosis.answer->cost / diagnosis.baseline_fit.cost_after);
  return left > kUnusableResidual ? kMostFromAfar : kMostOfIt;
}

bool TakesPlace(const HeldOutValidation& law, double explained_by_law,
                const HeldOutValidation* names, double explained_by_names) {
  constexpr double kBetter = 0.1, kOfError = 0.8;
  if (explained_by_law >= explained_by_names + std::min(kBetter, 0.5 * (1.0 - explained_by_names)))
    return true;
  if (names == nullptr || explained_by_law < explained_by_names - kBetter) return false;
  const bool are_comparable = law.is_in_pixels == names->is_in_pixels &&
                              !names->is_against_others && !law.earlier && !names->earlier;
  return are_comparable && law.after <= kOfError * names->after;
}

bool StandsOnFinerMesh(double gain, double gain_on_finer) {
  constexpr double kStands = 0.3;
  return gain_on_finer >= kStands * gain;
}

std::optional<Choice> ChooseModel(const std::vector<Model>& models, std::size_t first,
                                  const ChoiceRules& rules) {
  const auto explains_enough = [&](std::size_t i) {
    return models[i].explained >= rules.least_share;
  };
  double least = rules.cost_before;
  for (std::size_t i = first; i < models.size(); ++i) least = std::min(least, models[i].cost);
  const double most = rules.cost_before - kWorthKeeping * (rules.cost_before - least);
  for (std::size_t i = first; i < models.size(); ++i) {
    const bool is_validated = !rules.validate || models[i].validation.is_validated;
    if (explains_enough(i) && is_validated && models[i].cost <= most) return Choice{i, true};
  }
  if (first < models.size() && explains_enough(first)) return Choice{first, false};
  return {};
}

bool FirstDeservesAnotherTest(const std::vector<Model>& models, std::size_t first,
                              const ChoiceRules& rules) {
  const std::optional<Choice> choice = ChooseModel(models, first, rules);
  return choice && choice->model != first && models[first].explained >= rules.least_share &&
         models[first].cost <= kFarLess * models[choice->model].cost;
}

Verdict VerdictOf(const Diagnosis& diagnosis, double explained, bool is_above_discretisation) {
  if (diagnosis.law) return Verdict::kNoneOfTheAbove;
  const std::vector<std::string>& effects = diagnosis.effects;
  if (effects.empty()) return WithoutAnswer(diagnosis, is_above_discretisation);
  const bool is_physics =
      std::any_of(effects.begin(), effects.end(),
                  [&](const std::string& effect) { return IsPhysics(effect, diagnosis); });
  if (!is_physics) return Verdict::kObservationFault;
  return explained >= MostOfIt(diagnosis) ? Verdict::kNamed : Verdict::kNoneOfTheAbove;
}

std::string ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNothingMissing:
      return "nothing is missing";
    case Verdict::kNamed:
      return "named";
    case Verdict::kObservationFault:
      return "observation fault";
    case Verdict::kNoneOfTheAbove:
      return "none of the above";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kInterrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace clothfit
