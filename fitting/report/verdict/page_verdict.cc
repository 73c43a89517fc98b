// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/verdict/page_verdict.h"

#include <fmt/format.h>

#include "fitting/report/verdict/sentences.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Grade = PageVerdict::Grade;

constexpr double kPartialNoise = 5.0;    // times the stated sigmas
constexpr double kPartialHeldOut = 2.5;  // times the fitted error

const ErrorChange* Find(const VerdictFacts& facts, const std::string& kind, bool held_out) {
  for (const ErrorChange& error : facts.errors) {
    if (error.kind == kind && error.held_out == held_out && error.after) return &error;
  }
  return nullptr;
}

// The kind that says most: places in space before places in pictures before outlines.
std::string MainKind(const VerdictFacts& facts) {
  for (const char* kind : {"markers", "tracks", "clouds", "silhouettes"}) {
    if (Find(facts, kind, false) != nullptr) return kind;
  }
  return "";
}

// Held-out over fitted error of the main kind; empty where nothing is held out that can be judged.
std::optional<double> HeldOutRatio(const VerdictFacts& facts) {
  if (!facts.unknown_handles.empty()) return std::nullopt;
  const ErrorChange* const fitted = Find(facts, MainKind(facts), false);
  const ErrorChange* const held_out = Find(facts, MainKind(facts), true);
  if (fitted == nullptr || held_out == nullptr || *fitted->after <= 0.0) return std::nullopt;
  return *held_out->after / *fitted->after;
}

bool IsBetter(const VerdictFacts& facts) {
  const ErrorChange* const error = Find(facts, MainKind(facts), false);
  return error != nullptr && (!error->before || *error->after < *error->before);
}

bool ReachesTheEnd(const VerdictFacts& facts) {
  return facts.simulated_frames >= facts.recorded_frames;
}

bool IsWithinNoise(const VerdictFacts& facts) {
  return facts.misfit ? facts.misfit->IsNoise() : facts.noise_factor.value_or(1.0) <= kGoodNoise;
}

Grade GradeOf(const VerdictFacts& facts) {
  if (facts.status == "failed" || !ReachesTheEnd(facts) || !facts.noise_factor) return Grade::kPoor;
  const double noise = *facts.noise_factor, held_out = HeldOutRatio(facts).value_or(1.0);
  const bool good = IsWithinNoise(facts) && held_out <= kGoodHeldOut;
  if (good && facts.status == "converged") return Grade::kGood;
  const bool partial = noise <= kPartialNoise && held_out <= kPartialHeldOut && IsBetter(facts);
  return partial ? Grade::kPartial : Grade::kPoor;
}

std::string Headline(const VerdictFacts& facts, Grade grade) {
  if (!ReachesTheEnd(facts)) return "The simulation breaks down before the recording ends.";
  if (grade == Grade::kGood) return "The simulated cloth moves as the recorded one did.";
  if (grade == Grade::kPoor) return "The simulated cloth does not move as the recorded one did.";
  if (!IsWithinNoise(facts)) {
    if (facts.misfit && facts.misfit->IsNoiseAndMesh())
      return "The simulated cloth follows the recorded one as far as its mesh can.";
    return "The simulated cloth follows the recorded one, but not to within its noise.";
  }
  if (HeldOutRatio(facts).value_or(1.0) > kGoodHeldOut) {
    return "The simulated cloth follows the recorded one, but predicts it less well.";
  }
  return "The simulated cloth follows the recorded one; the fit is not finished.";
}

std::vector<std::string> Reservations(const VerdictFacts& facts) {
  std::vector<std::string> sentences;
  if (!facts.at_bound.empty()) {
    sentences.push_back(
        "At a bound, so that the model may be wrong there: " + JoinNames(facts.at_bound) + ".");
  }
  if (!facts.rugged_cost.empty()) {
    sentences.push_back(AsSentence(facts.rugged_cost));
  } else if (facts.status != "converged") {
    sentences.push_back(SayHowItEnded(facts.status));
  }
  if (!ReachesTheEnd(facts)) {
    sentences.push_back(fmt::format("Only {} of {} frames could be simulated.",
                                    facts.simulated_frames, facts.recorded_frames));
  }
  return sentences;
}

// Of a recording that was held out as a whole.
PageVerdict JudgePrediction(const VerdictFacts& facts) {
  const ErrorChange* error = nullptr;
  for (const char* kind : {"silhouettes", "tracks", "markers"})
    if (const ErrorChange* const found = Find(facts, kind, true)) error = found;
  PageVerdict verdict;
  if (!ReachesTheEnd(facts) || error == nullptr) {
    verdict.headline = "This recording, to which nothing was fitted, is not predicted to its end.";
    return verdict;
  }
  const bool is_noise = facts.misfit && facts.misfit->IsNoise();
  const bool is_better = !error->before || *error->after < *error->before;
  verdict.grade = is_noise ? Grade::kGood : is_better ? Grade::kPartial : Grade::kPoor;
  verdict.headline =
      fmt::format("This recording, to which nothing was fitted, is predicted {}.",
                  is_noise    ? "to within its noise"
                  : is_better ? "better than with the start values, but not to within its noise"
                              : "no better than with the start values");
  verdict.sentences.push_back(FittedSentence(*error));
  if (facts.misfit)
    verdict.sentences.push_back(fmt::format(
        "The residuals' chi-square is {:.3g} (1 is expected, noise leaves up to {:.3g}).",
        facts.misfit->chi_square, facts.misfit->limit));
  if (!facts.unknown_handles.empty())
    verdict.sentences.push_back("Where the handles were is not known of " +
                                JoinNames(facts.unknown_handles) + ", so that this says little.");
  return verdict;
}

}  // namespace

std::string ToString(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return "good";
    case Grade::kPartial:
      return "partial";
    case Grade::kPoor:
      break;
  }
  return "poor";
}

std::string SayHowItEnded(const std::string& status) {
  if (status == "failed") return "The fit failed.";
  if (status == "interrupted") return "The fit was interrupted: it may get better.";
  return "The fit has not converged: it may get better.";
}

PageVerdict JudgeFit(const VerdictFacts& facts) {
  if (facts.is_predicted) return JudgePrediction(facts);
  PageVerdict verdict;
  verdict.grade = GradeOf(facts);
  verdict.headline = Headline(facts, verdict.grade);
  const std::string kind = MainKind(facts);
  if (const ErrorChange* const fitted = Find(facts, kind, false)) {
    verdict.sentences.push_back(FittedSentence(*fitted));
  }
  if (!facts.lack_of_support.empty() && verdict.grade != Grade::kGood)
    verdict.sentences.push_back(AsSentence(facts.lack_of_support));
  if (const std::optional<double> ratio = HeldOutRatio(facts)) {
    verdict.sentences.push_back(HeldOutSentence(*Find(facts, kind, true), *ratio));
  }
  if (!facts.unknown_handles.empty() && Find(facts, kind, true) != nullptr) {
    verdict.sentences.push_back(
        "The frames that were held out cannot be judged: where the handles were then is not known "
        "of " +
        JoinNames(facts.unknown_handles) + ".");
  }
  if (facts.misfit) {
    verdict.sentences.push_back(MisfitSentence(*facts.misfit));
    verdict.sentences.push_back(MeshSentence(*facts.misfit));
  } else if (facts.noise_factor) {
    verdict.sentences.push_back(NoiseSentence(*facts.noise_factor));
  }
  if (!facts.put_right.empty())
    verdict.sentences.push_back("Wrong labels were put right: " + facts.put_right + ".");
  if (!facts.left_out.empty())
    verdict.sentences.push_back("Left out as gross errors: " + facts.left_out + ".");
  if (!facts.marker_places.empty()) {
    verdict.sentences.push_back(
        "On the cloth, markers sit beside their given places, as noise.layout lets them: by " +
        facts.marker_places + ".");
  }
  verdict.sentences.push_back(ParameterSentence(facts));
  for (std::string& sentence : Reservations(facts)) {
    verdict.sentences.push_back(std::move(sentence));
  }
  const bool is_missing =
      facts.misfit && !facts.misfit->IsNoiseAndMesh() && !facts.recording.empty();
  if (is_missing && facts.status == "converged") {
    verdict.sentences.push_back("What is missing: 'clothfit diagnose " + facts.recording + "'.");
  }
  return verdict;
}

}  // namespace clothfit
