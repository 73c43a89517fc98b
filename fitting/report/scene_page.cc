// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/scene_page.h"

#include <algorithm>
#include <cmath>

#include "fitting/files/version.h"
#include "fitting/report/page/html.h"
#include "fitting/report/scene/observations.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

using Json = ReportJson;

constexpr double kBytesInMegabyte = 1e6;

Json ClockAsJson(const Scene& scene) {
  const Recording& recording = scene.recording;
  Json held_out = Json::array();
  if (recording.splits.held_out_frames) {
    held_out.push_back(
        {recording.splits.held_out_frames->first, recording.splits.held_out_frames->last});
  }
  return {{"frames", recording.frame_count},
          {"rate", recording.frame_rate},
          {"held_out", held_out},
          {"last_fitted", scene.last_fitted_frame}};
}

// What is known before anything moves.
Json SceneAsJson(const Scene& scene) {
  const Recording& recording = scene.recording;
  const Eigen::Vector3d& gravity = recording.gravity;
  Json json;
  json["clock"] = ClockAsJson(scene);
  json["size"] = {recording.cloth.size.x(), recording.cloth.size.y()};
  json["gravity"] = {gravity.x(), gravity.y(), gravity.z()};
  json["ground"] = recording.ground_height ? Json(*recording.ground_height) : Json(nullptr);
  return json;
}

Json ObstaclesAsJson(const std::vector<ObstacleSurface>& obstacles, ReportBlobs* blobs) {
  Json json = Json::array();
  for (const ObstacleSurface& obstacle : obstacles) {
    json.push_back({{"name", obstacle.name},
                    {"positions", blobs->AddNumbers(obstacle.positions, 3)},
                    {"triangles", blobs->AddIntegers(obstacle.triangles, 3)}});
  }
  return json;
}

// The range that colours span: to the 98th of 100 values, so that one outlier does not bleach all;
// of the fit, whose errors are to be seen, rather than of the start, which may be far out.
std::array<double, 2> ColourRange(const ScalarField& field, const std::string& last_motion) {
  const auto chosen = field.values.find(last_motion);
  std::vector<double> values;
  for (const auto& [motion, frames] : field.values) {
    if (chosen != field.values.end() && motion != last_motion) continue;
    for (const Eigen::VectorXd& frame : frames) {
      for (const double value : frame) {
        if (std::isfinite(value)) values.push_back(field.diverging ? std::abs(value) : value);
      }
    }
  }
  if (values.empty()) return {0.0, 1.0};
  const auto high = values.begin() + static_cast<std::ptrdiff_t>(98 * (values.size() - 1) / 100);
  std::nth_element(values.begin(), high, values.end());
  const double end = *high > 0.0 ? *high : 1e-9;
  return {field.diverging ? -end : 0.0, end};
}

Json FieldAsJson(const ScalarField& field, const std::string& last_motion, ReportBlobs* blobs) {
  Json json = {{"name", field.name},
               {"title", field.title},
               {"unit", field.unit},
               {"diverging", field.diverging},
               {"range", ColourRange(field, last_motion)},
               {"values", Json::object()}};
  for (const auto& [motion, frames] : field.values) {
    json["values"][motion] = blobs->AddNumbers(frames, 1);
  }
  return json;
}

Json MotionsAsJson(const ReportScene& report, ReportBlobs* blobs) {
  Json motions = Json::array();
  for (const Motion& motion : report.motions) {
    motions.push_back({{"name", motion.name},
                       {"title", motion.title},
                       {"frames", motion.positions.size()},
                       {"positions", blobs->AddNumbers(motion.positions, 3)}});
  }
  return motions;
}

// Sections in which nothing stands are left out.
Json SectionsThatSay(const std::vector<Json>& sections) {
  Json json = Json::array();
  for (const Json& section : sections) {
    if (!section.at("blocks").empty()) json.push_back(section);
  }
  return json;
}

void AddPicturesThatFit(const ReportScene& report, const ReportAssets& assets,
                        const ReportOptions& options, std::size_t text, ReportBlobs* blobs,
                        Json* cameras, std::vector<std::string>* notes) {
  if (!report.pictures) return;
  constexpr double kBase64 = 4.0 / 3.0, kMargin = 0.95;
  const double used = static_cast<double>(text + blobs->num_characters() + assets.script.size() +
                                          assets.style.size());
  const double left = std::max(0.0, kBytesInMegabyte * options.max_megabytes - used);
  const PictureSize size = ChoosePictureSize(*report.pictures, options.picture,
                                             static_cast<std::int64_t>(kMargin * left / kBase64));
  AddPictures(*report.pictures, size, blobs, cameras, notes);
}

}  // namespace

Json ErrorsAsJson(const std::vector<ErrorChange>& changes) {
  Json errors = Json::array();
  for (const ErrorChange& error : changes) {
    errors.push_back({{"kind", error.kind},
                      {"held_out", error.held_out},
                      {"unit", error.unit},
                      {"before", OrNull(error.before)},
                      {"after", OrNull(error.after)}});
  }
  return errors;
}

ReportPage AsReportPage(ReportJson json, const PageVerdict& verdict, const ReportBlobs& blobs,
                        const ReportAssets& assets) {
  json["format"] = "clothfit-report/1";
  json["version"] = Version();
  if (!json.contains("notes")) json["notes"] = Json::array();
  return {ReportAsHtml(json, verdict, blobs, assets), verdict, json.at("notes")};
}

ReportPage MakeScenePage(const ScenePage& content, const ReportAssets& assets,
                         const ReportOptions& options) {
  const ReportScene& report = content.report;
  const Scene& scene = report.scene();
  std::vector<std::string> notes = report.notes;
  ReportBlobs blobs = content.blobs;
  Json json = SceneAsJson(scene);
  json["title"] = content.title;
  json["errors_title"] = content.errors_title;
  json["errors"] = ErrorsAsJson(content.errors);
  if (content.shows_both) json["shows_both"] = true;
  json["obstacles"] = ObstaclesAsJson(content.obstacles, &blobs);
  json["mesh"] = MeshAsJson(scene.mesh, &blobs);
  json["motions"] = MotionsAsJson(report, &blobs);
  json["sections"] = SectionsThatSay(content.sections);
  json["fields"] = Json::array();
  for (const ScalarField& field : content.fields) {
    json["fields"].push_back(FieldAsJson(field, report.motions.back().name, &blobs));
  }
  json["observations"] = ObservationsAsJson(scene, &blobs, &notes);
  json["handles"] = HandlesAsJson(report, &blobs);
  Json cameras = CamerasAsJson(report, &blobs);
  AddPicturesThatFit(report, assets, options, json.dump().size(), &blobs, &cameras, &notes);
  json["cameras"] = std::move(cameras);
  json["notes"] = notes;
  return AsReportPage(std::move(json), content.verdict, blobs, assets);
}

}  // namespace clothfit
