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

std::string AnyOf(const Diagnosis& diagnosis, const Names& set) {
  return JoinNames(AllInBrief(diagnosis, set), ", ", ", or ") + ": this recording cannot tell";
}

// What was found, beside what cannot be told from it; without a full stop.
std::string Found(const Diagnosis& diagnosis) {
  Names alone = diagnosis.effects;
  std::vector<std::string> parts;
  const auto take = [&](const Names& set) {
    parts.push_back(AnyOf(diagnosis, set));
    alone.erase(std::remove(alone.begin(), alone.end(), set.front()), alone.end());
  };
  const bool is_one_of_several = diagnosis.confidence_set.size() > 1;
  if (is_one_of_several) take(diagnosis.confidence_set);
  for (const Names& set : diagnosis.sets_beside) take(set);
  if (!alone.empty()) {
    parts.insert(is_one_of_several ? parts.end() : parts.begin(),
                 JoinNames(AllInBrief(diagnosis, alone), ", ", " and "));
  }
  return JoinNames(parts, "; besides, ");
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
  const auto has_it = [&](const Model& one) {
    return !one.effects.empty() && one.effects.back() == effect;
  };
  const std::vector<Model>& models = diagnosis.models;
  const auto first = std::find_if(models.begin(), models.end(), has_it);
  if (first == models.end()) return nullptr;
  const std::vector<Names>& beside = diagnosis.sets_beside;
  const bool is_beside =
      !IsAmong(diagnosis.confidence_set, effect) &&
      std::any_of(beside.begin(), beside.end(), [&](const Names& s) { return IsAmong(s, effect); });
  return is_beside ? &*std::find_if(models.rbegin(), models.rend(), has_it) : &*first;
}

std::string InBrief(const Diagnosis& diagnosis, const std::string& effect) {
  const bool is_of_answer = IsAmong(diagnosis.effects, effect);
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
