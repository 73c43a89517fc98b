// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/tracking_evaluation.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "autodiff_sim/base/input_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// Observations by frame, so that each frame's surface is located once.
template <class Observation>
std::map<int, std::vector<const Observation*>> ByFrame(const std::vector<Observation>& all) {
  std::map<int, std::vector<const Observation*>> by_frame;
  for (const Observation& o : all) by_frame[o.frame].push_back(&o);
  return by_frame;
}

template <class Observation>
std::vector<Eigen::Vector3d> Places(const TruthSurface& truth, int frame,
                                    const std::vector<const Observation*>& observations) {
  std::vector<Eigen::Vector2d> uv;
  for (const Observation* o : observations) uv.push_back(o->uv);
  return truth.At(frame, uv);
}

void CompareMasks(const Recording& recording, const fs::path& masks,
                  TrackingEvaluation* evaluation) {
  double intersections = 0.0, unions = 0.0;
  evaluation->worst_silhouette_iou = 1.0;
  for (const Camera& camera : recording.cameras) {
    for (int frame = 0; frame < recording.frame_count; ++frame) {
      const std::string name = fmt::format("{:06d}.png", frame);
      const fs::path true_file = recording.path / "truth" / "masks" / camera.name / name;
      const fs::path found_file = masks / camera.name / name;
      if (!IsThere(true_file) || !IsThere(found_file)) continue;
      for (const fs::path& file : {true_file, found_file}) CheckInputFile(file);
      const cv::Mat is = cv::imread(true_file.string(), cv::IMREAD_GRAYSCALE) > 127;
      const cv::Mat found = cv::imread(found_file.string(), cv::IMREAD_GRAYSCALE) > 127;
      if (is.empty() || is.size() != found.size()) continue;
      const int both = cv::countNonZero(is & found), either = cv::countNonZero(is | found);
      if (either == 0) continue;
      ++evaluation->num_silhouettes;
      intersections += both;
      unions += either;
      evaluation->worst_silhouette_iou =
          std::min(evaluation->worst_silhouette_iou, static_cast<double>(both) / either);
    }
  }
  if (evaluation->num_silhouettes == 0) evaluation->worst_silhouette_iou = 0.0;
  if (unions > 0.0) evaluation->silhouette_iou = intersections / unions;
}

}  // namespace

ErrorSummary Summarise(std::vector<double> errors, double outlier) {
  ErrorSummary summary;
  summary.count = errors.size();
  if (errors.empty()) return summary;
  std::sort(errors.begin(), errors.end());
  const auto quantile = [&](double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  summary.median = quantile(0.5);
  summary.quantile95 = quantile(0.95);
  summary.outliers =
      static_cast<double>(errors.end() - std::upper_bound(errors.begin(), errors.end(), outlier)) /
      static_cast<double>(errors.size());
  return summary;
}

TrackingEvaluation EvaluateTracking(const Recording& recording, const TruthSurface& truth,
                                    const std::vector<Track>& tracks,
                                    const std::vector<Marker>& markers, const fs::path& masks) {
  TrackingEvaluation evaluation;
  evaluation.tracks_in_frame.assign(static_cast<std::size_t>(recording.frame_count), 0);
  evaluation.markers_in_frame = evaluation.tracks_in_frame;
  std::vector<double> pixels, metres;
  for (const auto& [frame, seen] : ByFrame(tracks)) {
    if (frame >= truth.frame_count()) continue;
    const std::vector<Eigen::Vector3d> places = Places(truth, frame, seen);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Eigen::Vector2d pixel = ProjectPoint(recording.cameras[seen[i]->camera], places[i]);
      pixels.push_back((pixel - seen[i]->pixel).norm());
    }
    evaluation.tracks_in_frame[frame] = static_cast<int>(seen.size());
  }
  for (const auto& [frame, seen] : ByFrame(markers)) {
    if (frame >= truth.frame_count()) continue;
    const std::vector<Eigen::Vector3d> places = Places(truth, frame, seen);
    for (std::size_t i = 0; i < seen.size(); ++i)
      metres.push_back((places[i] - seen[i]->position).norm());
    evaluation.markers_in_frame[frame] = static_cast<int>(seen.size());
  }
  evaluation.tracks = Summarise(std::move(pixels), kTrackOutlier);
  evaluation.markers = Summarise(std::move(metres), kMarkerOutlier);
  CompareMasks(recording, masks, &evaluation);
  return evaluation;
}

std::string TrackingTableHeader() {
  return "| recording | silhouette IoU (worst picture) | 2D tracks | median, px | 95 %, px | "
         "outliers | live in the first / middle / last frame | 3D markers | median, mm | 95 %, mm "
         "| "
         "outliers | in the first / middle / last frame |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
}

std::string TrackingTableRow(const std::string& name, const TrackingEvaluation& evaluation) {
  const auto course = [](const std::vector<int>& counts) {
    if (counts.empty()) return std::string("-");
    return fmt::format("{} / {} / {}", counts.front(), counts[counts.size() / 2], counts.back());
  };
  const ErrorSummary& t = evaluation.tracks;
  const ErrorSummary& m = evaluation.markers;
  return fmt::format(
      "| {} | {:.4f} ({:.3f}) | {} | {:.2f} | {:.2f} | {:.2f} % | {} | {} | {:.1f} | {:.1f} | "
      "{:.2f} % | {} |\n",
      name, evaluation.silhouette_iou, evaluation.worst_silhouette_iou, t.count, t.median,
      t.quantile95, 100.0 * t.outliers, course(evaluation.tracks_in_frame), m.count, 1e3 * m.median,
      1e3 * m.quantile95, 100.0 * m.outliers, course(evaluation.markers_in_frame));
}

}  // namespace clothfit
