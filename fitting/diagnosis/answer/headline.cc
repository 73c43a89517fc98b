// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/headline.h"

#include <algorithm>

#include "fitting/diagnosis/answer/effect_words.h"
#include "fitting/diagnosis/answer/verdict.h"
#include "fitting/diagnosis/compare/two_meshes.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Names = std::vector<std::string>;

Names AllInBrief(const Diagnosis& diagnosis, const Names& effects) {
  Names words;
  for (const std::string& effect : effects) words.push_back(InBrief(diagnosis, effect));
  return words;
}

// What was found, beside what cannot be told from it; without a full stop.
std::string Found(const Diagnosis& diagnosis) {
  const Names& set = diagnosis.confidence_set;
  if (set.size() < 2) return JoinNames(AllInBrief(diagnosis, diagnosis.effects), ", ", " and ");
  Names besides;
  for (const std::string& effect : diagnosis.effects)
    if (effect != set.front()) besides.push_back(effect);
  const std::string words =
      JoinNames(AllInBrief(diagnosis, set), ", ", ", or ") + ": this recording cannot tell";
  if (besides.empty()) return words;
  return words + "; besides, " + JoinNames(AllInBrief(diagnosis, besides), ", ", " and ");
}

std::string OfNoneOfTheAbove(const Diagnosis& diagnosis) {
  if (diagnosis.law)
    return "Something is missing that no effect of the catalogue explains; a law was learned "
           "from it.";
  if (diagnosis.effects.empty()) {
    return "Something is missing, and nothing in the catalogue explains it.";
  }
  return "Something is missing, of which this is only a part: " + Found(diagnosis) + ".";
}

}  // namespace

const Model* ModelWith(const Diagnosis& diagnosis, const std::string& effect) {
  const auto model = std::find_if(
      diagnosis.models.begin(), diagnosis.models.end(),
      [&](const Model& one) { return !one.effects.empty() && one.effects.back() == effect; });
  return model == diagnosis.models.end() ? nullptr : &*model;
}

std::string InBrief(const Diagnosis& diagnosis, const std::string& effect) {
  const Names& found = diagnosis.effects;
  const bool is_of_answer = std::find(found.begin(), found.end(), effect) != found.end();
  const Model* const model =
      is_of_answer && diagnosis.answer ? &*diagnosis.answer : ModelWith(diagnosis, effect);
  return InBrief(effect, model == nullptr ? std::vector<EffectParameter>() : model->parameters);
}

bool MayBeMesh(const Diagnosis& diagnosis) {
  return !IsOnItsWay(diagnosis, BeyondNoise(diagnosis.residual_rms * diagnosis.residual_rms));
}

std::string HeadlineOf(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case Verdict::kNothingMissing:
      return "Nothing is missing that this recording could show.";
    case Verdict::kNamed:
      return Capitalised(Found(diagnosis)) + ".";
    case Verdict::kObservationFault:
      return Capitalised(Found(diagnosis)) +
             (diagnosis.confidence_set.size() < 2
                  ? ": a fault of the observation, not of the physics."
                  : ".");
    case Verdict::kNoneOfTheAbove:
      return OfNoneOfTheAbove(diagnosis);
    case Verdict::kUndecided:
      return MayBeMesh(diagnosis)
                 ? "Undecided: another mesh and step might leave as much as the baseline does."
                 : "Undecided: the baseline's fit has come to no minimum.";
    case Verdict::kInterrupted:
      break;
  }
  return diagnosis.effects.empty() ? "Interrupted before anything was found."
                                   : "Interrupted; so far: " + Found(diagnosis) + ".";
}

}  // namespace clothfit
