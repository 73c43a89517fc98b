// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Residuals of one frame.
#include "fitting/observation_residuals.h"

#include <algorithm>
#include <cmath>

#include <ceres/jet.h>

namespace clothfit {
namespace {

template <class Observation>
std::vector<std::size_t> FirstOfFrames(const std::vector<Observation>& sorted, int frames) {
  std::vector<std::size_t> first(static_cast<std::size_t>(frames) + 1, sorted.size());
  for (std::size_t i = sorted.size(); i-- > 0;) first[sorted[i].frame] = i;
  for (int f = frames - 1; f >= 0; --f) first[f] = std::min(first[f], first[f + 1]);
  return first;
}

// d (surface point) / d direction, 3 x directions.
Eigen::Matrix<double, 3, Eigen::Dynamic> PointDirections(const SurfacePoint& point,
                                                         const Sensitivity& sensitivity) {
  const int directions = sensitivity.num_directions();
  Eigen::Matrix<double, 3, Eigen::Dynamic> result(3, directions);
  for (int c = 0; c < directions; c += kLanes) {
    const Lanes<kLanes>& x = sensitivity.lanes()[c / kLanes].x;
    Eigen::Matrix<double, 3, kLanes> sum = Eigen::Matrix<double, 3, kLanes>::Zero();
    for (int k = 0; k < 3; ++k) {
      if (point.weights[k] != 0.0) sum += point.weights[k] * x.middleRows<3>(3 * point.nodes[k]);
    }
    result.middleCols(c, std::min(kLanes, directions - c)) =
        sum.leftCols(std::min(kLanes, directions - c));
  }
  return result;
}

std::unique_ptr<ceres::LossFunction> MakeLoss(const FitConfig& config) {
  if (config.loss == LossKind::kHuber) return std::make_unique<ceres::HuberLoss>(config.loss_scale);
  if (config.loss == LossKind::kCauchy)
    return std::make_unique<ceres::CauchyLoss>(config.loss_scale);
  return nullptr;
}

}  // namespace

ObservationResiduals::ObservationResiduals(const Scene& scene, const FitConfig& config)
    : scene_(scene),
      loss_(MakeLoss(config)),
      first_marker_(FirstOfFrames(scene.markers, scene.recording.frame_count)),
      first_track_(FirstOfFrames(scene.tracks, scene.recording.frame_count)) {}

int ObservationResiduals::Count(int frame) const {
  if (!scene_.is_fitted[frame]) return 0;
  int count = 3 * static_cast<int>(first_marker_[frame + 1] - first_marker_[frame]);
  for (std::size_t i = first_track_[frame]; i < first_track_[frame + 1]; ++i) {
    if (scene_.IsFitted(scene_.tracks[i])) count += 2;
  }
  return count;
}

int ObservationResiduals::Count(int first, int last) const {
  int count = 0;
  for (int f = first; f <= last; ++f) count += Count(f);
  return count;
}

template <int kRows>
void ObservationResiduals::Store(const Eigen::Matrix<double, kRows, 1>& r,
                                 const Eigen::Matrix<double, kRows, 3>& by_point,
                                 const SurfacePoint& point, const Sensitivity* sensitivity, int row,
                                 Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) const {
  double scale = 1.0, scale_slope = 0.0;  // sqrt(rho(s) / s) and its derivative by s
  const double s = r.squaredNorm();
  if (loss_ != nullptr && s > 1e-12) {
    double rho[3];
    loss_->Evaluate(s, rho);
    scale = std::sqrt(rho[0] / s);
    scale_slope = (rho[1] - rho[0] / s) / (2.0 * s * scale);
  }
  residuals->segment<kRows>(row) = scale * r;
  if (jacobian == nullptr) return;
  const Eigen::Matrix<double, kRows, Eigen::Dynamic> d =
      by_point * PointDirections(point, *sensitivity);
  jacobian->middleRows<kRows>(row) = scale * d;
  if (scale_slope != 0.0)
    jacobian->middleRows<kRows>(row) += (2.0 * scale_slope) * r * (r.transpose() * d);
}

bool ObservationResiduals::Evaluate(int frame, const State& state, const Sensitivity* sensitivity,
                                    int row, Eigen::VectorXd* residuals,
                                    RowMajorMatrix* jacobian) const {
  if (!scene_.is_fitted[frame]) return true;
  for (std::size_t i = first_marker_[frame]; i < first_marker_[frame + 1]; ++i, row += 3) {
    const MarkerObservation& m = scene_.markers[i];
    const Eigen::Vector3d r = (m.on_cloth.At(state.x) - m.position) / scene_.marker_sigma;
    Store<3>(r, Eigen::Matrix3d::Identity() / scene_.marker_sigma, m.on_cloth, sensitivity, row,
             residuals, jacobian);
  }
  for (std::size_t i = first_track_[frame]; i < first_track_[frame + 1]; ++i) {
    const TrackObservation& t = scene_.tracks[i];
    if (!scene_.IsFitted(t)) continue;
    using Jet = ceres::Jet<double, 3>;
    const Eigen::Vector3d p = t.on_cloth.At(state.x);
    const Camera& camera = scene_.recording.cameras[t.camera];
    if (!IsInFront(camera, p)) return false;
    const Eigen::Matrix<Jet, 3, 1> point(Jet(p.x(), 0), Jet(p.y(), 1), Jet(p.z(), 2));
    const Eigen::Matrix<Jet, 2, 1> pixel = ProjectPoint<Jet>(camera, point);
    Eigen::Vector2d r;
    Eigen::Matrix<double, 2, 3> by_point;
    for (int k = 0; k < 2; ++k) {
      r[k] = (pixel[k].a - t.pixel[k]) / scene_.track_sigma;
      by_point.row(k) = pixel[k].v.transpose() / scene_.track_sigma;
    }
    Store<2>(r, by_point, t.on_cloth, sensitivity, row, residuals, jacobian);
    row += 2;
  }
  return true;
}

}  // namespace clothfit
