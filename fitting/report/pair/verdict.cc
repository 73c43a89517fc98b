// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/report/pair/run_pair.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kEqual = 0.05;  // share of the smaller error within which two are equally good

// The kind of observation by which the two are told apart: that which says most, and of which both
// have an error in such frames.
const PairedError* MainError(const std::vector<PairedError>& errors, bool held_out) {
  for (const char* kind : {"markers", "tracks", "clouds", "silhouettes"})
    for (const PairedError& error : errors)
      if (error.kind == kind && error.held_out == held_out && error.first && error.second)
        return &error;
  return nullptr;
}

bool MayJudgeHeldOut(const RunPair& pair) {
  return pair.first.facts.unknown_handles.empty() && pair.second.facts.unknown_handles.empty();
}

std::string Headline(const RunPair& pair, const PairedError* held_out, const PairedError* fitted) {
  const std::string &first = pair.first.name, &second = pair.second.name;
  if (!pair.is_one_recording) return fmt::format("{} and {} are of two recordings.", first, second);
  const PairedError* const error = held_out != nullptr ? held_out : fitted;
  if (error == nullptr) return fmt::format("{} and {} have no error in common.", first, second);
  const char* const verb = held_out != nullptr ? "predicts" : "follows";
  const char* const what = held_out != nullptr ? "the held-out frames" : "the recording";
  const double least = std::min(*error->first, *error->second);
  const double most = std::max(*error->first, *error->second);
  if (most <= (1.0 + kEqual) * least) {
    return fmt::format("{} and {} {} {} equally well.", first, second,
                       held_out != nullptr ? "predict" : "follow", what);
  }
  const bool is_first = *error->first < *error->second;
  return fmt::format("{} {} {} better than {}.", is_first ? first : second, verb, what,
                     is_first ? second : first);
}

// ": 31 % less"
std::string Change(double first, double second) {
  if (!(first > 0.0)) return "";
  const double change = 100.0 * (second / first - 1.0);
  if (std::abs(change) < 1.0) return ": the same";
  if (change >= 900.0) return fmt::format(": {:.0f} times as much", second / first);
  return fmt::format(": {:.0f} % {}", std::abs(change), change < 0.0 ? "less" : "more");
}

std::string ErrorSentence(const RunPair& pair, const PairedError& error) {
  const std::string what = error.kind == "silhouettes" ? "the outlines' area" : "the " + error.kind;
  return fmt::format("On the {} frames {} {} off by {} in {} and by {} in {}{}.",
                     error.held_out ? "held-out" : "fitted", what,
                     error.kind == "silhouettes" ? "is" : "are",
                     QuantityInWords(*error.first, error.unit), pair.first.name,
                     QuantityInWords(*error.second, error.unit), pair.second.name,
                     pair.is_one_recording ? Change(*error.first, *error.second) : "");
}

std::string MisfitSentence(const RunPair& pair) {
  const std::optional<Misfit>&a = pair.first.facts.misfit, &b = pair.second.facts.misfit;
  if (!a || !b) return "";
  return fmt::format(
      "The residuals' chi-square is {:.3g} in {} and {:.3g} in {} (1 is expected of noise).",
      a->chi_square, pair.first.name, b->chi_square, pair.second.name);
}

std::string SettingsSentence(const RunPair& pair) {
  const auto count = DifferentSettings(pair).size();
  if (count == 0) return "All settings are the same.";
  return count == 1 ? "One setting differs." : fmt::format("{} settings differ.", count);
}

std::string ParameterSentence(const std::vector<PairedParameter>& parameters) {
  int common = 0;
  std::vector<std::string> apart;
  for (const PairedParameter& parameter : parameters) {
    common += parameter.in_joint_intervals ? 1 : 0;
    if (parameter.Disagrees()) apart.push_back(parameter.name);
  }
  if (common == 0) return "No parameter was determined in both.";
  const std::string of = common == 1
                             ? "The one parameter that both have determined"
                             : fmt::format("The {} parameters that both have determined", common);
  if (apart.empty()) return of + (common == 1 ? " agrees" : " agree") + " within their intervals.";
  if (common == 1) return of + " differs beyond its joint interval: " + apart.front() + ".";
  return fmt::format(
      "Of the {} parameters that both have determined {} {} beyond the joint "
      "interval: {}.",
      common, apart.size(), apart.size() == 1 ? "differs" : "differ", JoinNames(apart));
}

}  // namespace

PageVerdict JudgePair(const RunPair& pair, const std::vector<PairedParameter>& parameters) {
  const std::vector<PairedError> errors = PairErrors(pair.first.facts, pair.second.facts);
  const PairedError* const fitted = MainError(errors, false);
  const PairedError* const held_out = MayJudgeHeldOut(pair) ? MainError(errors, true) : nullptr;
  PageVerdict verdict;
  verdict.grade = std::min(pair.first.verdict.grade, pair.second.verdict.grade);  // the better one
  verdict.headline = Headline(pair, held_out, fitted);
  if (held_out != nullptr) verdict.sentences.push_back(ErrorSentence(pair, *held_out));
  if (fitted != nullptr) verdict.sentences.push_back(ErrorSentence(pair, *fitted));
  for (const PairedRun* run : {&pair.first, &pair.second})
    verdict.sentences.push_back(run->name + ": " + run->verdict.headline);
  const std::string misfit = MisfitSentence(pair);
  if (!misfit.empty()) verdict.sentences.push_back(misfit);
  verdict.sentences.push_back(SettingsSentence(pair));
  verdict.sentences.push_back(ParameterSentence(parameters));
  return verdict;
}

}  // namespace clothfit
