// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/pair/run_pair.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/report/records/run_record.h"
#include "fitting/report/verdict/facts.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;
using Side = PairedParameter::Side;

fs::path Normalised(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();  // "a/run/" is "a/run"
}

PairedRun ReadSide(const RunFolder& run, const std::string& name, const char* motion,
                   const fs::path& pictures) {
  RunRecord record = ReadRunRecord(run);
  FittedRun fitted = ReadFittedRun(run);
  CheckTrajectory(run.path() / "trajectory.npy", fitted.scene, record.trajectory);
  PairedRun side{name, GatherReportScene(std::move(fitted), pictures), {}, {}, {}};
  side.facts = FactsOf(record);
  side.facts.recording.clear();  // the page of one run says what to type next
  side.verdict = JudgeFit(side.facts);
  side.scene.motions = {{motion, name, record.trajectory}};
  side.scene.record = std::move(record);
  side.misfits = MeasureFrames(side.scene, side.scene.motions.front());
  return side;
}

bool IsOneRecording(const Recording& first, const Recording& second) {
  std::error_code error;
  return fs::equivalent(first.path, second.path, error) || FilesOf(first) == FilesOf(second);
}

Side SideOf(const Json& summary, const std::string& name) {
  Side side;
  const Json& parameters = summary.at("parameters");
  const auto estimate = parameters.find(name);
  if (estimate == parameters.end()) return side;
  if (estimate->at("value").is_number()) side.value = estimate->at("value").get<double>();
  side.is_free = estimate->value("free", false);
  if (!side.is_free) return side;
  side.is_determined = estimate->at("determined") == true;
  side.is_at_bound = estimate->at("at_bound") == true;
  const Json& ends = estimate->at("interval");
  if (ends.at(0).is_number() && ends.at(1).is_number())
    side.interval = {ends.at(0).get<double>(), ends.at(1).get<double>()};
  return side;
}

// On the parameter's scale; empty where a logarithm has none.
std::optional<double> OnScale(std::optional<double> value, bool is_log) {
  if (!value || !is_log) return value;
  return *value > 0.0 ? std::optional<double>(std::log(*value)) : std::nullopt;
}

// Half the width of the interval, on the parameter's scale. Nothing where the data say nothing.
std::optional<double> HalfWidth(const Side& side, bool is_log) {
  if (!side.interval || !side.is_determined) return std::nullopt;
  const auto lower = OnScale((*side.interval)[0], is_log);
  const auto upper = OnScale((*side.interval)[1], is_log);
  if (!lower || !upper || !(*upper > *lower)) return std::nullopt;
  return 0.5 * (*upper - *lower);
}

void Compare(PairedParameter* pair) {
  const auto first = OnScale(pair->first.value, pair->is_log);
  const auto second = OnScale(pair->second.value, pair->is_log);
  if (!first || !second) return;
  pair->difference = *second - *first;
  const auto of_first = HalfWidth(pair->first, pair->is_log);
  const auto of_second = HalfWidth(pair->second, pair->is_log);
  if (of_first && of_second)
    pair->in_joint_intervals = *pair->difference / std::hypot(*of_first, *of_second);
}

}  // namespace

std::array<std::string, 2> NamesApart(const fs::path& folder, const fs::path& other) {
  const fs::path first = Normalised(folder), second = Normalised(other);
  std::vector<fs::path> of_first(first.begin(), first.end());
  std::vector<fs::path> of_second(second.begin(), second.end());
  fs::path a, b;
  do {  // the two are not one folder, so that this ends
    if (!of_first.empty()) a = a.empty() ? of_first.back() : of_first.back() / a;
    if (!of_second.empty()) b = b.empty() ? of_second.back() : of_second.back() / b;
    if (!of_first.empty()) of_first.pop_back();
    if (!of_second.empty()) of_second.pop_back();
  } while (a == b && !(of_first.empty() && of_second.empty()));
  return {a.string(), b.string()};
}

RunPair ReadRunPair(const fs::path& folder, const fs::path& other, const fs::path& pictures) {
  const RunFolder first = RunFolder::Open(folder), second = RunFolder::Open(other);
  if (fs::equivalent(first.path(), second.path()))
    throw InputError(other.string(),
                     "is the same run as " + folder.string() + "; expected another");
  const auto [name, name_of_other] = NamesApart(folder, other);
  RunPair pair{ReadSide(first, name, "before", pictures),
               ReadSide(second, name_of_other, "after", pictures)};
  pair.is_one_recording =
      IsOneRecording(pair.first.scene.scene().recording, pair.second.scene.scene().recording);
  if (!pair.is_one_recording && !pictures.empty())
    throw InputError("--pictures", "cannot be those of two recordings; leave it out");
  return pair;
}

std::vector<ConfigDifference> DifferentSettings(const RunPair& pair) {
  std::vector<ConfigDifference> differences =
      CompareConfigs(pair.first.scene.fitted.config, pair.second.scene.fitted.config);
  differences.erase(std::remove_if(differences.begin(), differences.end(),
                                   [](const auto& one) { return one.key == "recording"; }),
                    differences.end());
  return differences;
}

std::vector<PairedError> PairErrors(const VerdictFacts& first, const VerdictFacts& second) {
  std::vector<PairedError> pairs;
  const auto place = [&pairs](const ErrorChange& error) -> PairedError& {
    for (PairedError& pair : pairs)
      if (pair.kind == error.kind && pair.held_out == error.held_out) return pair;
    return pairs.emplace_back(PairedError{error.kind, error.held_out, error.unit, {}, {}});
  };
  for (const ErrorChange& error : first.errors)
    if (error.after) place(error).first = error.after;
  for (const ErrorChange& error : second.errors)
    if (error.after) place(error).second = error.after;
  return pairs;
}

std::vector<PairedParameter> PairParameters(const ReportScene& first, const ReportScene& second) {
  std::vector<PairedParameter> pairs;
  for (const NamedParameter& named : MakeParameterTable()) {
    PairedParameter pair;
    pair.first = SideOf(first.record.summary, named.name);
    pair.second = SideOf(second.record.summary, named.name);
    if (!pair.first.is_free && !pair.second.is_free) continue;
    pair.name = named.name;
    pair.doc = named.parameter.doc;
    pair.unit = named.parameter.unit;
    pair.is_log = named.parameter.scale == Scale::kLog;
    const ParameterSetting& a = first.fitted.config.parameters.at(named.name);
    const ParameterSetting& b = second.fitted.config.parameters.at(named.name);
    pair.bounds = {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
    Compare(&pair);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace clothfit
