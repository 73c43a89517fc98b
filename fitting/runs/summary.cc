// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
#include "fitting/runs/summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/files/version.h"
#include "fitting/runs/fit_run.h"
#include "fitting/runs/run_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/outliers/outliers.h"
#include "tracking/outliers/swapped_markers.h"
#include "tracking/recording/warnings/support.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;

Json FittedErrors(const Evaluation& evaluation) {
  return {{"marker_rms_m", OrNull(evaluation.marker_rms)},
          {"track_rms_px", OrNull(evaluation.track_rms)},
          {"cloud_rms_m", OrNull(evaluation.cloud_rms)},
          {"silhouette_error_px", OrNull(evaluation.silhouette_error)}};
}

Json HeldOutErrors(const Evaluation& evaluation) {
  return {{"marker_rms_m", OrNull(evaluation.held_out_marker_rms)},
          {"track_rms_px", OrNull(evaluation.held_out_track_rms)},
          {"cloud_rms_m", OrNull(evaluation.held_out_cloud_rms)},
          {"silhouette_error_px", OrNull(evaluation.held_out_silhouette_error)}};
}

Json Frames(const Scene& scene, const FitResult& result) {
  const auto fitted = std::count(scene.is_fitted.begin(), scene.is_fitted.end(), true);
  return {{"recorded", scene.recording.frame_count},
          {"fitted", fitted},
          {"simulated", result.after.frames}};
}

Json MisfitAsJson(const std::optional<Misfit>& misfit) {
  if (!misfit) return nullptr;
  return {{"observed", misfit->observed},
          {"chi_square", OrNull(misfit->chi_square)},
          {"limit", OrNull(misfit->limit)},
          {"correlation", OrNull(misfit->correlation)},
          {"discretisation", OrNull(misfit->discretisation)},
          {"amplitude", OrNull(misfit->amplitude)},
          {"without_discretisation", OrNull(misfit->without_discretisation)}};
}

// All of what was left out in words, and the worst few.
Json LeftOutAsJson(const Recording& recording) {
  constexpr std::size_t kWorst = 10;
  const std::vector<Outlier>& out = recording.left_out;
  const auto markers =
      std::count_if(out.begin(), out.end(), [](const Outlier& o) { return o.IsMarker(); });
  Json json = {{"markers", markers},
               {"tracks", static_cast<std::ptrdiff_t>(out.size()) - markers},
               {"in_words", DescribeOutliers(recording)},
               {"worst", Json::array()}};
  for (std::size_t i = 0; i < std::min(kWorst, out.size()); ++i) {
    if (const auto* marker = std::get_if<Marker>(&out[i].point)) {
      json["worst"].push_back(
          {{"marker", marker->id}, {"frame", marker->frame}, {"off_m", out[i].off}});
    } else if (const auto* track = std::get_if<Track>(&out[i].point)) {
      json["worst"].push_back({{"track", track->id},
                               {"camera", recording.cameras[track->camera].name},
                               {"frame", track->frame},
                               {"off_px", out[i].off}});
    }
  }
  return json;
}

// Where markers sit on the cloth beside their given places; null where those are exact.
Json MarkerPlacesAsJson(const Scene& scene, const Evaluation& evaluation) {
  if (evaluation.marker_shifts.empty()) return nullptr;
  constexpr double kMillimetres = 1e3;
  Json shifts = Json::object();
  double sum = 0.0, most = 0.0;
  int worst = 0;
  for (const auto& [id, shift] : evaluation.marker_shifts) {
    shifts[std::to_string(id)] = {shift[0], shift[1]};
    sum += shift.squaredNorm();
    if (shift.norm() > most) worst = id;
    most = std::max(most, shift.norm());
  }
  const double rms = std::sqrt(sum / static_cast<double>(evaluation.marker_shifts.size()));
  return {{"layout_m", scene.layout_sigma},
          {"rms_m", rms},
          {"shifts_m", shifts},
          {"in_words", fmt::format("{:.1f} mm (root mean square), at most {:.1f} mm (marker {})",
                                   kMillimetres * rms, kMillimetres * most, worst)}};
}

Json EstimateAsJson(const ParameterEstimate& estimate) {
  Json json = {{"value", OrNull(estimate.value)},
               {"start", OrNull(estimate.start)},
               {"unit", estimate.unit},
               {"free", estimate.free},
               {"interval", nullptr},
               {"determined", nullptr},
               {"at_bound", nullptr}};
  if (!estimate.free) return json;
  json["interval"] = {OrNull(estimate.lower95), OrNull(estimate.upper95)};
  json["determined"] = estimate.determined;
  json["at_bound"] = estimate.at_bound;
  return json;
}

Json EstimatesAsJson(const FitResult& result) {
  Json json = Json::object();
  for (const ParameterEstimate& estimate : result.estimates)
    json[estimate.name] = EstimateAsJson(estimate);
  return json;
}

void AddWork(const FitResult& result, Json* json) {
  (*json)["status"] = ToString(result.status);
  (*json)["iterations"] = result.iterations;
  (*json)["simulations"] = result.simulations;
  (*json)["simulated_frames"] = result.simulated_frames;
  (*json)["seconds"] = result.seconds;
  (*json)["cost"] = {{"before", OrNull(result.cost_before)}, {"after", OrNull(result.cost_after)}};
}

}  // namespace

Json SummaryAsJson(const Scene& scene, const FitConfig& config, const FitResult& result) {
  Json json;
  json["clothfit"] = Version();
  json["recording"] = {{"name", scene.recording.name}, {"path", config.recording}};
  AddWork(result, &json);
  json["fit"] = FittedErrors(result.after);
  json["held_out"] = HeldOutErrors(result.after);
  json["before"] = {{"fit", FittedErrors(result.before)},
                    {"held_out", HeldOutErrors(result.before)}};
  json["noise"] = {{"marker_m", scene.marker_sigma},
                   {"track_px", scene.track_sigma},
                   {"cloud_m", scene.cloud_sigma},
                   {"silhouette_px", scene.silhouette_sigma}};
  json["frames"] = Frames(scene, result);
  json["halvings"] = result.steps.halvings;
  json["noise_factor"] = OrNull(result.noise_factor);
  json["misfit"] = MisfitAsJson(result.misfit);
  json["put_right"] = DescribeSwaps(scene.recording);
  json["left_out"] = LeftOutAsJson(scene.recording);
  json["marker_places"] = MarkerPlacesAsJson(scene, result.after);
  json["lack_of_support"] = DescribeLackOfSupport(scene.recording);
  json["unknown_in_held_out_frames"] = HandlesUnknownInHeldOutFrames(scene);
  json["statements"] = result.statements;
  json["parameters"] = EstimatesAsJson(result);
  return json;
}

Json JointSummaryAsJson(const FitResult& result) {
  Json json;
  json["clothfit"] = Version();
  AddWork(result, &json);
  json["halvings"] = result.steps.halvings;
  json["noise_factor"] = OrNull(result.noise_factor);
  json["misfit"] = MisfitAsJson(result.misfit);
  json["statements"] = result.statements;
  json["parameters"] = EstimatesAsJson(result);
  return json;
}

void RunFolder::WriteSummary(const Scene& scene, const FitConfig& config,
                             const FitResult& result) const {
  WriteSummary(SummaryAsJson(scene, config, result));
}

void RunFolder::WriteSummary(const Json& json) const {
  WriteWholeFile(path_ / "summary.json",
                 json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace clothfit
