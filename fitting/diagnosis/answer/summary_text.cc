// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/summary_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/diagnosis/answer/effect_words.h"
#include "fitting/diagnosis/answer/headline.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// Where mesh and step might make as much, no share is known (ShareBeyondMesh), and none is told.
std::string SayShare(const Model& model) {
  constexpr double kShown = 0.005;  // less is 0 % in print
  if (model.explained < kShown) return "What mesh and step leave is as large as what it takes";
  return fmt::format("It explains {:.0f} % of what the baseline cannot", 100.0 * model.explained);
}

std::string NameEffects(const Diagnosis& diagnosis) {
  const Model& answer = *diagnosis.answer;
  const bool is_none = diagnosis.verdict == Verdict::kNoneOfTheAbove;
  const bool is_fault = diagnosis.verdict == Verdict::kObservationFault;
  std::string words = is_none    ? "None of the effects that clothfit knows; what comes nearest: "
                      : is_fault ? "Put right in the observation: "
                                 : "What was left out: ";
  words += PlainNames(diagnosis.effects) + ".";
  const std::string amounts =
      AmountsInWords(diagnosis.effects, answer.parameters, HeadlineOf(diagnosis));
  if (!amounts.empty()) words += " " + amounts;
  const double odds = answer.log_evidence;
  return words + fmt::format(" {}; the natural logarithm of the odds for it is {:.{}f}.",
                             SayShare(answer), odds, std::abs(odds) < 10.0 ? 1 : 0);
}

std::string SayWhyUndecided(const Diagnosis& diagnosis) {
  const double left = diagnosis.residual_rms;
  if (!MayBeMesh(diagnosis)) {
    return fmt::format(
        "The baseline leaves {:.2g} sigmas, but a full step of its fit still promises {:.0f} % "
        "less.",
        left, 100.0 * diagnosis.promised);
  }
  // Of points that is known on the mesh that decides.
  if (diagnosis.misfit) {
    return fmt::format("The baseline leaves {:.2g} sigmas; noise is 1, mesh and step make {:.2g}.",
                       left, diagnosis.discretisation_rms);
  }
  return fmt::format(
      "The baseline leaves {:.2g} sigmas, where noise, mesh and step leave at least as much with "
      "p = {:.2g}.",
      left, diagnosis.gate_p_value);
}

// Where only the last of several effects is taken out, it says which.
std::string SayValidation(const Model& answer) {
  const HeldOutValidation& validation = answer.validation;
  const auto amount = [&](double value) {
    return QuantityInWords(value, validation.is_in_pixels ? "px" : "m");
  };
  const std::string newest =
      answer.effects.size() > 1 ? TitleOf(answer.effects.back()) + " besides" : "it";
  if (!std::isfinite(validation.before) || !std::isfinite(validation.after)) {
    return std::isfinite(validation.after)
               ? fmt::format(
                     "Without {} the simulation breaks down in the held-out frames; with "
                     "it the error there is {}.",
                     newest, amount(validation.after))
               : fmt::format("With {} the simulation breaks down in the held-out frames.", newest);
  }
  std::string words = fmt::format("With {}, the error on the held-out frames", newest);
  if (validation.is_against_others)
    words = "With it put right, how far it is on the held-out frames from what all else saw";
  words +=
      fmt::format(" {} from {} to {}", validation.after < validation.before ? "falls" : "rises",
                  amount(validation.before), amount(validation.after));
  words += validation.noise > 0.0 ? fmt::format("; noise is {}.", amount(validation.noise)) : ".";
  const double by_mesh =
      validation.irreducible * validation.irreducible - validation.noise * validation.noise;
  const double squared = validation.before * validation.before;
  constexpr double kWorthSaying = 0.05;
  if (by_mesh >= squared) {
    words += " Mesh and step alone might make all of it.";
  } else if (by_mesh > kWorthSaying * squared) {
    words += fmt::format(" Mesh and step alone might make it fall to {}.",
                         amount(std::sqrt(squared - by_mesh)));
  }
  return words;
}

// set: of `it` and what cannot be told from it.
std::string SayOthers(const Diagnosis& diagnosis, const std::vector<std::string>& set,
                      const std::string& it) {
  if (set.size() < 2) return "";
  const std::vector<std::string> others(set.begin() + 1, set.end());
  std::string words = fmt::format("This recording cannot tell {} from {}.", it, PlainNames(others));
  for (const std::string& other : others) {
    const Model* const model = ModelWith(diagnosis, other);
    const std::string amounts =
        model ? AmountsInWords({other}, model->parameters, HeadlineOf(diagnosis)) : "";
    if (!amounts.empty()) words += " " + amounts;
  }
  return words;
}

}  // namespace

std::vector<std::string> DetailsOf(const Diagnosis& diagnosis) {
  std::vector<std::string> sentences;
  if (diagnosis.confidence_set.size() > 1 && diagnosis.separating)
    sentences.push_back(Describe(*diagnosis.separating));
  if (diagnosis.verdict == Verdict::kNothingMissing) {
    sentences.push_back(fmt::format(
        "The baseline leaves {:.3g} sigmas, where noise alone leaves 1.", diagnosis.residual_rms));
  }
  if (diagnosis.verdict == Verdict::kUndecided) {
    sentences.push_back(SayWhyUndecided(diagnosis));
    sentences.emplace_back(
        "What it leaves is no evidence of missing physics, nor that nothing is missing. A shorter "
        "or gentler recording, or material parameters that are known, would help.");
  }
  // What is named says itself where it acts; the map of what the baseline cannot take for anything
  // else is for what has no name.
  const bool has_map = diagnosis.discrepancy && diagnosis.discrepancy->is_significant;
  if (has_map && !diagnosis.acting_class) {
    sentences.push_back(diagnosis.discrepancy->words);
    if (diagnosis.discrepancy_class) sentences.push_back(diagnosis.discrepancy_class->words);
  }
  if (diagnosis.law) {
    const Model& model = diagnosis.law->model;
    if (!diagnosis.effects.empty())
      sentences.push_back("Put right in the observation: " + PlainNames(diagnosis.effects) + ".");
    sentences.push_back(
        fmt::format("The learned law: {}. {}.", diagnosis.law->formula, SayShare(model)));
    if (diagnosis.acting_class) sentences.push_back(diagnosis.acting_class->words);
    sentences.push_back(SayValidation(model));
  } else if (diagnosis.answer) {
    sentences.push_back(NameEffects(diagnosis));
    if (diagnosis.acting_class) sentences.push_back(diagnosis.acting_class->words);
    sentences.push_back(SayOthers(diagnosis, diagnosis.confidence_set, "it"));
    for (const std::vector<std::string>& set : diagnosis.sets_beside)
      sentences.push_back(SayOthers(diagnosis, set, TitleOf(set.front())));
    sentences.push_back(SayValidation(*diagnosis.answer));
  } else if (!diagnosis.effects.empty()) {
    sentences.push_back("Put right in the observation: " + PlainNames(diagnosis.effects) + ".");
  }
  if (diagnosis.verdict == Verdict::kNoneOfTheAbove && !diagnosis.law && diagnosis.answer) {
    sentences.push_back(
        "No effect in the catalogue explains all of what is missing: what comes nearest may only "
        "stand for it.");
  }
  if (diagnosis.verdict == Verdict::kInterrupted && diagnosis.answer) {
    sentences.push_back("The search was stopped: amounts may still change, and have no intervals.");
  }
  sentences.erase(std::remove(sentences.begin(), sentences.end(), ""), sentences.end());
  return sentences;
}

std::string DescribeDiagnosis(const Diagnosis& diagnosis) {
  std::string words = HeadlineOf(diagnosis);
  for (const std::string& sentence : DetailsOf(diagnosis)) words += " " + sentence;
  return words;
}

std::string DiagnosisAsText(const Diagnosis& diagnosis) {
  const std::string details = fmt::format("{}", fmt::join(DetailsOf(diagnosis), " "));
  return HeadlineOf(diagnosis) + "\n" + details + (details.empty() ? "" : "\n");
}

}  // namespace clothfit
