// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/scene/frame_misfit.h"

#include <cmath>

#include "autodiff_sim/base/parallel.h"
#include "fitting/residuals/cloud_residuals.h"
#include "fitting/residuals/hard_silhouette.h"
#include "tracking/camera/camera.h"

namespace clothfit {
namespace {

struct Sum {
  double sum = 0.0;
  int count = 0;
  void Add(double value) {
    sum += value;
    ++count;
  }
};

std::vector<std::optional<double>> Roots(const std::vector<Sum>& sums) {
  std::vector<std::optional<double>> roots(sums.size());
  for (std::size_t f = 0; f < sums.size(); ++f) {
    if (sums[f].count > 0) roots[f] = std::sqrt(sums[f].sum / sums[f].count);
  }
  return roots;
}

std::vector<std::optional<double>> MarkerErrors(const Scene& scene, const Motion& motion) {
  std::vector<Sum> sums(scene.is_fitted.size());
  for (const MarkerObservation& marker : scene.markers) {
    const auto frame = static_cast<std::size_t>(marker.frame);
    if (frame >= motion.positions.size()) continue;
    sums[frame].Add((marker.on_cloth.At(motion.positions[frame]) - marker.position).squaredNorm());
  }
  return Roots(sums);
}

std::vector<std::optional<double>> TrackErrors(const Scene& scene, const Motion& motion) {
  std::vector<Sum> sums(scene.is_fitted.size());
  for (const TrackObservation& track : scene.tracks) {
    const auto frame = static_cast<std::size_t>(track.frame);
    if (frame >= motion.positions.size()) continue;
    const Camera& camera = scene.recording.cameras[track.camera];
    const Eigen::Vector3d point = track.on_cloth.At(motion.positions[frame]);
    if (!IsInFront(camera, point)) continue;
    sums[frame].Add((ProjectPoint(camera, point) - track.pixel).squaredNorm());
  }
  return Roots(sums);
}

std::vector<std::optional<double>> CloudErrors(const Scene& scene, const Motion& motion) {
  std::vector<Sum> sums(scene.is_fitted.size());
  const CloudResiduals to_surface(scene, 0.0);
  for (std::size_t i = 0; scene.clouds && i < scene.clouds->observations.size(); ++i) {
    const CloudObservation& cloud = scene.clouds->observations[i];
    const auto frame = static_cast<std::size_t>(cloud.frame);
    if (frame >= motion.positions.size()) continue;
    for (const PointResidual& r : to_surface.OfPoints(cloud, motion.positions[frame]))
      sums[frame].Add(r.value * r.value);
  }
  return Roots(sums);
}

std::vector<std::optional<double>> SilhouetteErrors(const ReportScene& report,
                                                    const Motion& motion) {
  std::vector<std::optional<double>> errors(report.scene().is_fitted.size());
  if (report.silhouettes == nullptr) return errors;
  Scene with_masks = report.scene();
  with_masks.silhouettes = report.silhouettes;
  const HardSilhouette hard(with_masks);
  ParallelFor(static_cast<int>(motion.positions.size()), 0, [&](int frame, int) {
    Sum sum;
    for (const auto& difference : hard.Differences(frame, motion.positions[frame])) {
      sum.Add(static_cast<double>(difference.pixels));
    }
    if (sum.count > 0) errors[frame] = sum.sum / sum.count;
  });
  return errors;
}

std::vector<std::optional<double>> TruthErrors(const ReportScene& report, const Motion& motion) {
  std::vector<Sum> sums(report.scene().is_fitted.size());
  std::vector<Eigen::Vector2d> uv;
  for (const TruthPoint& point : report.truth) uv.push_back(point.uv);
  const std::vector<SurfacePoint> on_cloth = LocateOnCloth(report.scene().mesh, uv);
  for (std::size_t i = 0; i < report.truth.size(); ++i) {
    const auto frame = static_cast<std::size_t>(report.truth[i].frame);
    if (frame >= motion.positions.size()) continue;
    sums[frame].Add(
        (on_cloth[i].At(motion.positions[frame]) - report.truth[i].position).squaredNorm());
  }
  return Roots(sums);
}

}  // namespace

std::vector<FrameMisfit> MeasureFrames(const ReportScene& report, const Motion& motion) {
  const auto markers = MarkerErrors(report.scene(), motion);
  const auto tracks = TrackErrors(report.scene(), motion);
  const auto clouds = CloudErrors(report.scene(), motion);
  const auto silhouettes = SilhouetteErrors(report, motion);
  const auto truth = TruthErrors(report, motion);
  std::vector<FrameMisfit> frames(markers.size());
  for (std::size_t f = 0; f < frames.size(); ++f) {
    frames[f] = {markers[f], tracks[f], clouds[f], silhouettes[f], truth[f]};
  }
  return frames;
}

std::vector<std::vector<FrameMisfit>> MeasureMotions(const ReportScene& report) {
  std::vector<std::vector<FrameMisfit>> misfits;
  for (const Motion& motion : report.motions) misfits.push_back(MeasureFrames(report, motion));
  return misfits;
}

}  // namespace clothfit
