// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/summary.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace clothfit {
namespace {

using Scores = std::vector<TrialScore>;
using Which = std::function<bool(const TrialScore&)>;

Scores Those(const Scores& scores, const Which& which) {
  Scores those;
  std::copy_if(scores.begin(), scores.end(), std::back_inserter(those), which);
  return those;
}

Which IsKind(const std::string& kind) {
  return [kind](const TrialScore& score) {
    return score.status == TrialStatus::kDone && score.kind == kind;
  };
}

std::string Percent(const Coverage& coverage) {
  if (coverage.total == 0) return "-";
  return fmt::format("{}/{} = {:.0f} % ({:.0f} to {:.0f} %)", coverage.covered, coverage.total,
                     100.0 * coverage.share(), 100.0 * coverage.lower(), 100.0 * coverage.upper());
}

template <class T>
std::vector<double> ValuesOf(const Scores& scores, const std::optional<T> TrialScore::*value,
                             double factor = 1.0) {
  std::vector<double> values;
  for (const TrialScore& score : scores) {
    if (score.*value) values.push_back(factor * static_cast<double>(*(score.*value)));
  }
  return values;
}

std::string Number(double value, const char* unit = "") {
  return std::isfinite(value) ? fmt::format("{:.3g}{}", value, unit) : std::string("-");
}

double Mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());  // not a number where there are none
}

Coverage CountNear(const Scores& scores) {
  Coverage near;
  for (const TrialScore& score : scores) {
    if (!score.onset_error) continue;
    ++near.total;
    if (std::abs(*score.onset_error) <= 2) ++near.covered;
  }
  return near;
}

Coverage CountIntervals(const Scores& scores) {
  Coverage intervals;
  for (const TrialScore& score : scores) {
    intervals.covered += score.covered;
    intervals.total += score.intervals;
  }
  return intervals;
}

std::string Row(const std::string& what, const std::string& found, const std::string& asked) {
  return fmt::format("| {} | {} | {} |\n", what, found, asked);
}

Coverage CountUndecided(const Scores& scores) {
  Coverage undecided;
  undecided.total = static_cast<int>(scores.size());
  undecided.covered =
      static_cast<int>(std::count_if(scores.begin(), scores.end(), [](const TrialScore& score) {
        return score.verdict == "undecided";
      }));
  return undecided;
}

std::string AlarmRows(const Scores& scores) {
  const Scores clean = Those(scores, IsKind("clean")), fault = Those(scores, IsKind("fault"));
  return Row("clean: false alarms", Percent(CountYes(clean, &TrialScore::false_alarm)), "0 of 60") +
         Row("clean: undecided", Percent(CountUndecided(clean)), "-") +
         Row("fault: physics blamed", Percent(CountYes(fault, &TrialScore::false_alarm)),
             "at most 3 of 60") +
         Row("fault: undecided", Percent(CountUndecided(fault)), "-") +
         Row("fault: named as such", Percent(CountYes(fault, &TrialScore::fault_named)), "all");
}

std::string NameRows(const Scores& fair) {
  return Row("listed, fair: undecided", Percent(CountUndecided(fair)), "-") +
         Row("listed, fair: named first", Percent(CountYes(fair, &TrialScore::named_first)),
             "at least 85 %") +
         Row("listed, fair: first of the ranking", Percent(CountYes(fair, &TrialScore::top_right)),
             "-") +
         Row("listed, fair: in the ambiguity set",
             Percent(CountYes(fair, &TrialScore::in_ambiguity)), "at least 97 %") +
         Row("listed, fair: size of the set, mean",
             Number(Mean(ValuesOf(fair, &TrialScore::ambiguity_size))), "below 2") +
         Row("listed, fair: parameter error, median",
             Number(Median(ValuesOf(fair, &TrialScore::parameter_error, 100.0)), " %"),
             "within 10 %") +
         Row("listed, fair: in the 90 % interval", Percent(CountIntervals(fair)), "85 to 95 %");
}

std::string PlaceRows(const Scores& fair) {
  return Row("listed, fair: overlap of the region, median",
             Number(Median(ValuesOf(fair, &TrialScore::region_overlap))), "at least 0.5") +
         Row("listed, fair: onset within 2 frames", Percent(CountNear(fair)), "all") +
         Row("listed, fair: class", Percent(CountYes(fair, &TrialScore::class_right)), "-") +
         Row("listed, fair: tied to", Percent(CountYes(fair, &TrialScore::tie_right)), "-") +
         Row("listed, fair: gap closed, median",
             Number(Median(ValuesOf(fair, &TrialScore::gap_closed, 100.0)), " %"), "-");
}

std::string OtherRows(const Scores& scores) {
  const Scores unlisted = Those(scores, IsKind("unlisted")), pair = Those(scores, IsKind("pair"));
  const Scores weak = Those(
      scores, [](const TrialScore& score) { return IsKind("listed")(score) && !IsFair(score); });
  return Row("listed, below three limits: named first",
             Percent(CountYes(weak, &TrialScore::named_first)), "-") +
         Row("unlisted: none of the above", Percent(CountYes(unlisted, &TrialScore::flagged)),
             "at least 80 %") +
         Row("unlisted: class", Percent(CountYes(unlisted, &TrialScore::class_right)), "all") +
         Row("unlisted: gap closed, median",
             Number(Median(ValuesOf(unlisted, &TrialScore::gap_closed, 100.0)), " %"),
             "at least 50 %") +
         Row("pairs: both named", Percent(CountYes(pair, &TrialScore::both_named, IsFair)),
             "at least 65 %");
}

// What each effect comes to.
std::string EffectRows(const Scores& fair) {
  std::vector<std::string> names;
  for (const TrialScore& score : fair) {
    if (std::find(names.begin(), names.end(), score.truth) == names.end())
      names.push_back(score.truth);
  }
  std::string text =
      "\n| effect | named first | in the set | parameter error, median | gap closed, median |\n"
      "|---|---|---|---:|---:|\n";
  for (const std::string& name : names) {
    const Scores of = Those(fair, [&](const TrialScore& score) { return score.truth == name; });
    text += fmt::format("| {} | {} | {} | {} | {} |\n", name,
                        Percent(CountYes(of, &TrialScore::named_first)),
                        Percent(CountYes(of, &TrialScore::in_ambiguity)),
                        Number(Median(ValuesOf(of, &TrialScore::parameter_error, 100.0)), " %"),
                        Number(Median(ValuesOf(of, &TrialScore::gap_closed, 100.0)), " %"));
  }
  return names.empty() ? std::string() : text;
}

// The refitted baseline is what a user would do instead of a diagnosis.
std::string HeldOutRows(const Scores& scores) {
  std::string text =
      "\n| held-out error, medians | baseline refitted | answer | true model |\n"
      "|---|---:|---:|---:|\n";
  for (const bool has_markers : {true, false}) {
    const Scores those = Those(scores, [&](const TrialScore& score) {
      const bool is_marker = score.observation == "markers" || score.observation == "mixture";
      return score.status == TrialStatus::kDone && is_marker == has_markers && score.held_out_true;
    });
    if (those.empty()) continue;
    const double factor = has_markers ? 1e3 : 1.0;
    text += fmt::format("| {} | {} | {} | {} |\n", has_markers ? "markers (mm)" : "tracks (px)",
                        Number(Median(ValuesOf(those, &TrialScore::held_out_before, factor))),
                        Number(Median(ValuesOf(those, &TrialScore::held_out_after, factor))),
                        Number(Median(ValuesOf(those, &TrialScore::held_out_true, factor))));
  }
  return text;
}

std::string FailedRows(const Scores& scores) {
  const Scores failed =
      Those(scores, [](const TrialScore& score) { return score.status == TrialStatus::kFailed; });
  std::string text = fmt::format("\n{} trials, {} of them failed{}\n", scores.size(), failed.size(),
                                 failed.empty() ? "." : ":");
  if (!failed.empty()) text += "\n";
  for (const TrialScore& score : failed)
    text += fmt::format("- {}: {}\n", score.name, score.problem);
  return text;
}

}  // namespace

bool IsFair(const TrialScore& score) {
  return !score.over_limit || *score.over_limit >= kFairOverLimit;
}

Coverage CountYes(const Scores& scores, const std::optional<bool> TrialScore::*answer,
                  const Which& which) {
  Coverage coverage;
  for (const TrialScore& score : scores) {
    if (!(score.*answer) || (which && !which(score))) continue;
    ++coverage.total;
    if (*(score.*answer)) ++coverage.covered;
  }
  return coverage;
}

double Median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::string ScoresAsMarkdown(const Scores& scores) {
  const Scores fair = Those(
      scores, [](const TrialScore& score) { return IsKind("listed")(score) && IsFair(score); });
  return "| what | found | asked for |\n|---|---|---|\n" + AlarmRows(scores) + NameRows(fair) +
         PlaceRows(fair) + OtherRows(scores) + HeldOutRows(scores) + EffectRows(fair) +
         FailedRows(scores);
}

}  // namespace clothfit
