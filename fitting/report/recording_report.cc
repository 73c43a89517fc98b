// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of a recording, before anything is fitted: what was measured, where the handles are, how
// the cloth lies, and how it would move with the material parameters that a fit begins with.
#include <sstream>

#include <fmt/format.h>

#include "fitting/report/kinds.h"
#include "fitting/report/scene_page.h"
#include "fitting/runs/fit_run.h"
#include "tracking/outliers/outliers.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/recording/warnings/summary.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// Good where there is nothing to warn of.
PageVerdict VerdictOf(const Recording& recording, const std::string& outliers,
                      const std::vector<std::string>& unknown) {
  PageVerdict verdict;
  const double seconds = (recording.frame_count - 1) / recording.frame_rate;
  verdict.headline =
      fmt::format("{}: {} frames, {:.3g} s.", recording.name, recording.frame_count, seconds);
  verdict.sentences = Warnings(recording);
  if (!outliers.empty())
    verdict.sentences.push_back("Gross errors, which fits leave out: " + outliers + ".");
  if (!unknown.empty()) {
    verdict.sentences.push_back("Held-out frames cannot be judged: where " + JoinNames(unknown) +
                                (unknown.size() == 1 ? " is" : " are") + " then is not known.");
  }
  verdict.grade =
      verdict.sentences.empty() ? PageVerdict::Grade::kGood : PageVerdict::Grade::kPartial;
  if (verdict.sentences.empty()) verdict.sentences.emplace_back("There is nothing to warn of.");
  return verdict;
}

ReportJson ContentSection(const Recording& recording) {
  ReportJson rows = ReportJson::array();
  std::istringstream lines(DescribeRecording(recording));
  for (std::string line; std::getline(lines, line);) {
    if (line.size() <= kLabelWidth) continue;
    const std::string_view label = TrimBlanks(std::string_view(line).substr(0, kLabelWidth));
    rows.push_back({std::string(label), line.substr(kLabelWidth)});
  }
  return SectionOf("content", "What it holds",
                   {{{"kind", "table"},
                     {"columns", {{{"title", "part"}}, {{"title", "contents"}}}},
                     {"rows", rows}}},
                   "Contents");
}

// How many points each frame has: what is seen now and then only says little.
ReportJson SeenSection(const Scene& scene) {
  const auto frames = static_cast<std::size_t>(scene.recording.frame_count);
  std::vector<int> markers(frames), tracks(frames), clouds(frames);
  for (const MarkerObservation& one : scene.markers) ++markers[static_cast<std::size_t>(one.frame)];
  for (const TrackObservation& one : scene.tracks) ++tracks[static_cast<std::size_t>(one.frame)];
  for (std::size_t i = 0; scene.clouds && i < scene.clouds->observations.size(); ++i) {
    const CloudObservation& one = scene.clouds->observations[i];
    clouds[static_cast<std::size_t>(one.frame)] += static_cast<int>(one.points.size());
  }
  ReportJson blocks = ReportJson::array();
  const auto add = [&](bool is_there, const char* title, const std::vector<int>& counts) {
    if (!is_there) return;
    blocks.push_back({{"kind", "lines"},
                      {"title", title},
                      {"frames", true},
                      {"y", {{"title", title}, {"unit", ""}, {"from_zero", true}}},
                      {"series", {{{"name", title}, {"role", "after"}, {"values", counts}}}}});
  };
  add(!scene.markers.empty(), "Markers seen", markers);
  add(!scene.tracks.empty(), "Tracked points seen, all cameras", tracks);
  add(scene.clouds != nullptr, "Points of clouds that a fit takes", clouds);
  return SectionOf("seen", "Seen over time", blocks, "Seen");
}

}  // namespace

ReportPage MakeRecordingReport(const std::filesystem::path& folder, const ReportAssets& assets,
                               const ReportOptions& options) {
  FittedRun unfitted = ReadUnfitted(folder);
  const Recording whole = unfitted.scene.recording;
  Recording recording = whole;
  LeaveOutOutliers(&recording);
  const std::string outliers = DescribeOutliers(recording);
  ReportScene report = GatherReportScene(std::move(unfitted), options.pictures);
  report.motions = {{"after", "Default material", SimulateStart(report.fitted)}};
  const std::vector<std::string> unknown = HandlesUnknownInHeldOutFrames(report.scene());
  std::vector<ScalarField> fields = CommonFields(report);
  ReportJson errors = ErrorSection(report, MeasureMotions(report));
  errors["title"] = "How far the default material is off";
  std::vector<ReportJson> sections = {CameraSection(report), ContentSection(whole),
                                      SeenSection(report.scene()), std::move(errors),
                                      ClothMapSection(report, fields)};
  return MakeScenePage({report,
                        VerdictOf(whole, outliers, unknown),
                        "Recording " + whole.name,
                        "",
                        {},
                        std::move(fields),
                        ObstaclesOf(report),
                        std::move(sections),
                        {}},
                       assets, options);
}

}  // namespace clothfit
