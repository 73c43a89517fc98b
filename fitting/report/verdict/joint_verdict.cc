// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/verdict/joint_verdict.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/rugged_cost.h"
#include "fitting/report/verdict/facts.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;
using Grade = PageVerdict::Grade;

struct JudgedRecording {
  std::string name;
  bool is_held_out = false, is_noise = false;
  bool is_better = true;        // than with the start values
  std::string lack_of_support;  // see DescribeLackOfSupport
};

struct SimulatedFrames {
  int simulated = 0, recorded = 0;

  bool ReachTheEnd() const { return simulated >= recorded; }
};

SimulatedFrames FramesOf(const Json& entry) {
  const Json frames = entry.value("frames", Json::object());
  return {frames.value("simulated", 0), frames.value("recorded", 0)};
}

JudgedRecording Judge(const Json& entry) {
  JudgedRecording judged;
  judged.is_better = FramesOf(entry).ReachTheEnd();
  judged.name = entry.at("name").get<std::string>();
  judged.is_held_out = entry.at("held_out_whole").get<bool>();
  const std::optional<Misfit> misfit = MisfitOf(entry);
  judged.is_noise = misfit && misfit->IsNoiseAndMesh();
  judged.lack_of_support = entry.value("lack_of_support", "");
  for (const ErrorChange& error : ErrorsOf(entry)) {
    if (error.held_out == judged.is_held_out && error.before && error.after)
      judged.is_better = judged.is_better && *error.after < *error.before;
  }
  return judged;
}

// "9.1 to 12.3 mm", over the fitted recordings; empty where none has such observations.
std::string RangeOf(const Json& recordings, const std::string& kind, bool before) {
  std::vector<double> values;
  std::string unit;
  for (const Json& entry : recordings) {
    for (const ErrorChange& error : ErrorsOf(entry)) {
      const std::optional<double>& value = before ? error.before : error.after;
      if (error.kind != kind || error.held_out || !value) continue;
      values.push_back(*value);
      unit = error.unit;
    }
  }
  if (values.empty()) return "";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::string from = QuantityInWords(*least, unit), to = QuantityInWords(*most, unit);
  return from == to ? from : from + " to " + to;
}

void AddFitted(const Json& recordings, std::vector<std::string>* sentences) {
  for (const char* kind : {"markers", "tracks", "silhouettes"}) {
    const std::string after = RangeOf(recordings, kind, false);
    if (after.empty()) continue;
    sentences->push_back(fmt::format("Fitted {}: {}; with the start values {}.",
                                     kind == std::string("silhouettes") ? "outlines" : kind, after,
                                     RangeOf(recordings, kind, true)));
  }
}

// Of the recordings that are not explained; those that lack the same in one sentence.
void AddLackOfSupport(const std::vector<JudgedRecording>& judged,
                      std::vector<std::string>* sentences) {
  std::map<std::string, std::vector<std::string>> names;
  for (const JudgedRecording& one : judged)
    if (!one.lack_of_support.empty() && !one.is_noise)
      names[one.lack_of_support].push_back(one.name);
  for (const auto& [lack, recordings] : names)
    sentences->push_back(fmt::format("In {} {}.", JoinNames(recordings), lack));
}

void AddHeldOut(const Json& recordings, std::vector<std::string>* sentences) {
  for (const Json& entry : recordings) {
    if (!entry.at("held_out_whole").get<bool>()) continue;
    const std::string name = entry.at("name").get<std::string>();
    if (const SimulatedFrames frames = FramesOf(entry); !frames.ReachTheEnd()) {
      sentences->push_back(fmt::format(
          "{}, which was not fitted, is not predicted to its end: {} of {} frames can be simulated "
          "with what was found.",
          name, frames.simulated, frames.recorded));
      continue;
    }
    for (const ErrorChange& error : ErrorsOf(entry)) {
      if (!error.after) continue;
      const auto noise = NoiseOf(entry, error.kind);
      sentences->push_back(fmt::format(
          "{}, which was not fitted, is predicted to {} ({}){}{}.", name,
          QuantityInWords(*error.after, error.unit), error.kind,
          error.before ? "; with the start values " + QuantityInWords(*error.before, error.unit)
                       : "",
          noise ? "; noise is " + QuantityInWords(*noise, error.unit) : ""));
    }
  }
}

void AddParameters(const Json& parameters, std::vector<std::string>* sentences) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  int num_free = 0;
  std::vector<std::string> open;
  for (const auto& [name, estimate] : parameters.items()) {
    if (estimate.at("free") != true || FindParameter(table, name) < 0) continue;
    ++num_free;
    if (estimate.at("determined") == false) open.push_back(name);
  }
  if (num_free == 0) return;
  if (open.empty()) {
    sentences->push_back(
        fmt::format("All {} shared parameters are determined by the data.", num_free));
  } else {
    sentences->push_back(fmt::format("Of {} shared parameters the data leave {} to the prior: {}.",
                                     num_free, open.size(), JoinNames(open)));
  }
}

Grade GradeOf(const std::string& status, const std::vector<JudgedRecording>& judged) {
  const auto is_good = [](const JudgedRecording& one) { return one.is_held_out || one.is_noise; };
  const auto is_better = [](const JudgedRecording& one) { return one.is_better; };
  if (status == "failed") return Grade::kPoor;
  if (status == "converged" && std::all_of(judged.begin(), judged.end(), is_good))
    return Grade::kGood;
  return std::all_of(judged.begin(), judged.end(), is_better) ? Grade::kPartial : Grade::kPoor;
}

}  // namespace

PageVerdict JudgeJointFit(const Json& summary) {
  const std::string status = summary.at("status").get<std::string>();
  const Json& recordings = summary.at("recordings");
  std::vector<JudgedRecording> judged;
  for (const Json& entry : recordings) judged.push_back(Judge(entry));
  const auto fitted = std::count_if(judged.begin(), judged.end(),
                                    [](const JudgedRecording& one) { return !one.is_held_out; });
  const auto met = std::count_if(judged.begin(), judged.end(), [](const JudgedRecording& one) {
    return !one.is_held_out && one.is_noise;
  });
  PageVerdict verdict;
  verdict.grade = GradeOf(status, judged);
  if (status == "failed") {
    verdict.headline = "The simulation of the fitted recordings fails.";
  } else {
    verdict.headline = fmt::format(
        "One cloth explains {} recordings to within noise, mesh and step.",
        met == fitted ? fmt::format("all {}", fitted) : fmt::format("{} of {}", met, fitted));
  }
  AddFitted(recordings, &verdict.sentences);
  AddLackOfSupport(judged, &verdict.sentences);
  AddHeldOut(recordings, &verdict.sentences);
  AddParameters(summary.at("parameters"), &verdict.sentences);
  const std::string rugged_cost =
      RuggedCostAmong(summary.value("statements", std::vector<std::string>()));
  if (!rugged_cost.empty()) {
    verdict.sentences.push_back(AsSentence(rugged_cost));
  } else if (status != "converged") {
    verdict.sentences.push_back(SayHowItEnded(status));
  }
  return verdict;
}

std::optional<double> NoiseOf(const Json& entry, const std::string& kind) {
  const Json& noise = entry.at("noise");
  if (kind == "markers") return std::sqrt(3.0) * noise.at("marker_m").get<double>();
  if (kind == "tracks") return std::sqrt(2.0) * noise.at("track_px").get<double>();
  return std::nullopt;
}

}  // namespace clothfit
