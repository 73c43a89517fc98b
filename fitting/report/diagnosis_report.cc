// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of a diagnosis: the baseline beside the model with what was found.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/titles.h"
#include "fitting/files/npy_file.h"
#include "fitting/report/diagnosis/record.h"
#include "fitting/report/diagnosis/sections.h"
#include "fitting/report/kinds.h"
#include "fitting/report/page/markdown_blocks.h"
#include "fitting/report/scene_page.h"
#include "tracking/outliers/outliers.h"
#include "tracking/outliers/swapped_markers.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using Grade = PageVerdict::Grade;

// Are all of them physics of one kind: as tied, as internal, and doing the same work?
bool AreOfOneClass(const std::vector<std::string>& effects) {
  std::set<std::tuple<bool, Work, std::vector<Tie>>> classes;
  for (const std::string& effect : effects) {
    const std::string name = effect.substr(0, effect.find('.'));
    const auto& terms = AllTerms();
    const auto term = std::find_if(terms.begin(), terms.end(),
                                   [&](const TermInfo& one) { return one.name == name; });
    if (term == terms.end()) return effects.size() < 2;  // a fault of the observation
    classes.insert({term->internal, term->work, term->ties});
  }
  return classes.size() < 2;
}

std::string TitleOfErrors(const DiagnosisRecord& record) {
  if (record.effects.empty()) return "Error of the baseline";
  const std::string title = "Error of the baseline → with what was found";
  // The page's recording is the one that was given.
  return record.verdict == "observation fault" ? title + ", against the recording with its fault"
                                               : title;
}

Grade GradeOf(const DiagnosisRecord& record) {
  if (record.verdict == "nothing is missing") return Grade::kGood;
  if (record.verdict == "named")
    return std::all_of(record.confidence_sets.begin(), record.confidence_sets.end(), AreOfOneClass)
               ? Grade::kGood
               : Grade::kPartial;
  return record.verdict == "observation fault" ? Grade::kPartial : Grade::kPoor;
}

// What follows the headline, as its sentences.
std::vector<std::string> Sentences(const DiagnosisRecord& record) {
  const std::string& words = record.words;
  const bool has_headline = StartsWith(words, record.headline);
  std::vector<std::string> sentences;
  const std::size_t begin = has_headline ? record.headline.size() + 1 : 0;
  for (std::string rest = words.substr(std::min(begin, words.size())); !rest.empty();) {
    auto [first, others] = FirstSentence(rest);
    sentences.push_back(std::move(first));
    rest = std::move(others);
  }
  return sentences;
}

using Member = std::optional<double> FrameMisfit::*;

// Root mean square over the frames that are held out, or over those that are fitted.
std::optional<double> OverFrames(const Scene& scene, const std::vector<FrameMisfit>& frames,
                                 Member member, bool held_out) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::optional<double>& value = frames[f].*member;
    if (!value || scene.IsHeldOut(static_cast<int>(f)) != held_out) continue;
    sum += *value * *value;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / count);
}

std::vector<ErrorChange> ChangesOf(const ReportScene& report,
                                   const std::vector<std::vector<FrameMisfit>>& misfits) {
  const struct {
    const char *kind, *unit;
    Member member;
  } kinds[] = {{"markers", "m", &FrameMisfit::markers},
               {"tracks", "px", &FrameMisfit::tracks},
               {"silhouettes", "px", &FrameMisfit::silhouettes}};
  std::vector<ErrorChange> errors;
  for (const auto& [kind, unit, member] : kinds) {
    for (const bool held_out : {false, true}) {
      const auto before = OverFrames(report.scene(), misfits.front(), member, held_out);
      std::optional<double> after;  // there is none where nothing was found
      if (misfits.size() > 1) after = OverFrames(report.scene(), misfits.back(), member, held_out);
      if (before || after) errors.push_back({kind, held_out, unit, before, after});
    }
  }
  return errors;
}

FittedRun ReadModel(const DiagnosisRecord& record) {
  const fs::path file = record.folder / "config.yaml";
  const std::string folder = ReadConfigRecording(file);
  if (folder.empty()) throw InputError(file.string(), "names no recording");
  Recording recording = ReadRecording(folder);
  if (record.held_out) recording.splits.held_out_frames = record.held_out;
  FitConfig config = DefaultConfig(recording);
  ReadConfig(file, &config);
  // What the diagnosis went by: errors on the page are those of its sentences.
  PutLabelsRight(&recording);
  if (config.leave_out_outliers) LeaveOutOutliers(&recording);
  config.resolution = record.resolution;
  Scene scene = MakeScene(recording, config);
  return {std::move(config), std::move(scene)};
}

ReportScene SceneOf(const DiagnosisRecord& record, const ReportOptions& options) {
  ReportScene report = GatherReportScene(ReadModel(record), options.pictures);
  const auto add = [&](const char* file, const char* name, const std::string& title) {
    std::vector<Eigen::VectorXd> positions = ReadPointsNpy(record.folder / file);
    CheckTrajectory(record.folder / file, report.scene(), positions);
    report.motions.push_back({name, title, std::move(positions)});
  };
  add("baseline.npy", "before", "Baseline");
  if (!record.effects.empty())
    add("model.npy", "after", "With " + JoinNames(TitlesOf(record.effects)));
  return report;
}

// What the baseline lacks, on every motion; not known beyond the last frame it was looked for in.
std::vector<ScalarField> ForceFields(const ReportScene& report,
                                     const std::vector<Eigen::VectorXd>& force) {
  if (force.empty()) return {};
  ScalarField size{"missing_force", "Missing force", "N/m^2", false, {}};
  ScalarField normal{"missing_force_normal", "Missing force, normal", "N/m^2", true, {}};
  const Eigen::VectorXd unknown =
      Eigen::VectorXd::Constant(force[0].size() / 3, std::numeric_limits<double>::quiet_NaN());
  for (const Motion& motion : report.motions) {
    for (std::size_t f = 0; f < motion.positions.size(); ++f) {
      const bool is_known = f < force.size();
      const Eigen::VectorXd& numbers = force[std::min(f, force.size() - 1)];
      const Eigen::Map<const Eigen::Matrix3Xd> vectors(numbers.data(), 3, numbers.size() / 3);
      size.values[motion.name].emplace_back(
          is_known ? Eigen::VectorXd(vectors.colwise().norm().transpose()) : unknown);
      normal.values[motion.name].emplace_back(is_known ? Eigen::VectorXd(vectors.row(0).transpose())
                                                       : unknown);
    }
  }
  return {std::move(size), std::move(normal)};
}

}  // namespace

ReportPage MakeDiagnosisReport(const fs::path& folder, const ReportAssets& assets,
                               const ReportOptions& options) {
  const DiagnosisRecord record = ReadDiagnosisRecord(folder);
  const ReportScene report = SceneOf(record, options);
  const std::vector<std::vector<FrameMisfit>> misfits = MeasureMotions(report);
  std::vector<ScalarField> fields = CommonFields(report);
  std::vector<ScalarField> forces = ForceFields(report, record.force);
  ReportBlobs blobs;
  std::vector<ReportJson> sections = {CameraSection(report),
                                      RankingSection(record),
                                      LocationSection(report, record, &blobs),
                                      ClassSection(record),
                                      ValidationSection(report, record),
                                      AnswerSection(report, record),
                                      NullSection(record),
                                      ErrorSection(report, misfits),
                                      ClothMapSection(report, fields),
                                      DiagnosisTimeSection(record),
                                      DiagnosisFilesSection(report, record)};
  fields.insert(fields.begin() + 1, std::make_move_iterator(forces.begin()),
                std::make_move_iterator(forces.end()));
  const ReportExtras extras = ReadReportExtras(folder, report);
  return MakeScenePage({report,
                        {GradeOf(record), record.headline, Sentences(record)},
                        "Diagnosis of " + report.scene().recording.name,
                        TitleOfErrors(record),
                        ChangesOf(report, misfits),
                        std::move(fields),
                        ObstaclesOf(report, extras.obstacles),
                        std::move(sections),
                        std::move(blobs)},
                       assets, options);
}

}  // namespace clothfit
