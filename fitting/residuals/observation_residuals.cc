// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Residuals of one frame.
#include "fitting/residuals/observation_residuals.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/parallel.h"
#include "fitting/residuals/track_residual.h"

namespace clothfit {
namespace {

template <class Observation>
std::vector<std::size_t> FirstOfFrames(const std::vector<Observation>& sorted, int frames) {
  std::vector<std::size_t> first(static_cast<std::size_t>(frames) + 1, sorted.size());
  for (std::size_t i = sorted.size(); i-- > 0;) first[sorted[i].frame] = i;
  for (int f = frames - 1; f >= 0; --f) first[f] = std::min(first[f], first[f + 1]);
  return first;
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
      silhouette_weight_(std::sqrt(config.alpha)),
      other_weight_(std::sqrt(config.beta)),
      loss_(MakeLoss(config)),
      soft_(scene.recording.cameras.size()),
      first_marker_(FirstOfFrames(scene.markers, scene.recording.frame_count)),
      first_track_(FirstOfFrames(scene.tracks, scene.recording.frame_count)) {
  if (scene.clouds) {
    clouds_ = std::make_unique<CloudResiduals>(scene, config.cloud_coverage);
    first_cloud_ = FirstOfFrames(scene.clouds->observations, scene.recording.frame_count);
  }
  if (!scene.silhouettes) return;
  const std::vector<SilhouetteObservation>& all = scene.silhouettes->observations;
  first_silhouette_ = FirstOfFrames(all, scene.recording.frame_count);
  for (const SilhouetteObservation& s : all) {
    if (s.field && !soft_[s.camera]) {
      soft_[s.camera] =
          std::make_unique<SoftSilhouette>(scene.recording.cameras[s.camera], scene.mesh);
    }
  }
}

int ObservationResiduals::Count(int frame) const {
  if (!scene_.is_fitted[frame]) return 0;
  int count = 3 * static_cast<int>(first_marker_[frame + 1] - first_marker_[frame]);
  for (std::size_t i = first_track_[frame]; i < first_track_[frame + 1]; ++i) {
    if (scene_.IsFitted(scene_.tracks[i])) count += 2;
  }
  for (std::size_t i = clouds_ ? first_cloud_[frame] : 0; clouds_ && i < first_cloud_[frame + 1];
       ++i) {
    const CloudObservation& cloud = scene_.clouds->observations[i];
    if (scene_.IsFitted(cloud)) count += clouds_->Count(cloud);
  }
  if (!scene_.silhouettes) return count;
  for (std::size_t i = first_silhouette_[frame]; i < first_silhouette_[frame + 1]; ++i) {
    const SilhouetteObservation& s = scene_.silhouettes->observations[i];
    if (s.field) count += soft_[s.camera]->Count(s);
  }
  return count;
}

int ObservationResiduals::Count(int first, int last) const {
  int count = 0;
  for (int f = first; f <= last; ++f) count += Count(f);
  return count;
}

int ObservationResiduals::NumObserved(int first, int last) const {
  int count = Count(first, last);
  for (int f = first; clouds_ && f <= last; ++f) {
    for (std::size_t i = first_cloud_[f]; i < first_cloud_[f + 1]; ++i) {
      const CloudObservation& cloud = scene_.clouds->observations[i];
      if (scene_.IsFitted(cloud))
        count -= clouds_->Count(cloud) - static_cast<int>(cloud.points.size());
    }
  }
  if (!scene_.silhouettes) return count;
  for (const SilhouetteObservation& s : scene_.silhouettes->observations) {
    if (s.field && s.frame >= first && s.frame <= last) count -= scene_.mesh.num_particles();
  }
  return count;
}

template <int kRows>
void ObservationResiduals::Store(const Eigen::Matrix<double, kRows, 1>& r,
                                 const Eigen::Matrix<double, kRows, 3>& by_point,
                                 const SurfacePoint& point, double weight,
                                 PointResidual* residuals) const {
  double scale = weight, scale_slope = 0.0;  // sqrt(rho(s) / s) and its derivative by s, weighted
  const double s = r.squaredNorm();
  if (loss_ != nullptr && s > 1e-12) {
    double rho[3];
    loss_->Evaluate(s, rho);
    const double root = std::sqrt(rho[0] / s);
    scale = weight * root;
    scale_slope = weight * (rho[1] - rho[0] / s) / (2.0 * s * root);
  }
  Eigen::Matrix<double, kRows, 3> slopes = scale * by_point;
  if (scale_slope != 0.0) slopes += (2.0 * scale_slope) * r * (r.transpose() * by_point);
  for (int k = 0; k < kRows; ++k) residuals[k] = {scale * r[k], point, slopes.row(k)};
}

bool ObservationResiduals::Evaluate(int frame, const State& state, const Sensitivity* sensitivity,
                                    int row, Eigen::VectorXd* residuals,
                                    RowMajorMatrix* jacobian) const {
  std::vector<PointResidual> all;
  if (!EvaluateAtPoints(frame, state, &all)) return false;
  for (std::size_t i = 0; i < all.size(); ++i)
    (*residuals)[row + static_cast<Eigen::Index>(i)] = all[i].value;
  if (jacobian == nullptr) return true;
  constexpr int kPiece = 256;  // rows at a time
  const int count = static_cast<int>(all.size());
  ParallelFor((count + kPiece - 1) / kPiece, NumThreads(0), [&](int piece, int) {
    for (int i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i)
      SetDirections(all[i], *sensitivity, jacobian->row(row + i));
  });
  return true;
}

bool ObservationResiduals::EvaluateAtPoints(int frame, const State& state,
                                            std::vector<PointResidual>* residuals) const {
  residuals->assign(Count(frame), PointResidual());
  if (!scene_.is_fitted[frame]) return true;
  PointResidual* next = residuals->data();
  for (std::size_t i = first_marker_[frame]; i < first_marker_[frame + 1]; ++i, next += 3) {
    const MarkerObservation& m = scene_.markers[i];
    const Eigen::Vector3d r = (m.on_cloth.At(state.x) - m.position) / scene_.marker_sigma;
    Store<3>(r, Eigen::Matrix3d::Identity() / scene_.marker_sigma, m.on_cloth, other_weight_, next);
  }
  for (std::size_t i = first_track_[frame]; i < first_track_[frame + 1]; ++i) {
    const TrackObservation& t = scene_.tracks[i];
    if (!scene_.IsFitted(t)) continue;
    const Eigen::Vector3d p = t.on_cloth.At(state.x);
    if (!IsInFront(scene_.recording.cameras[t.camera], p)) return false;
    const TrackResidual residual = ResidualOfTrack(scene_, t, p);
    Store<2>(residual.value, residual.by_place, t.on_cloth, other_weight_, next);
    next += 2;
  }
  return EvaluateSilhouettes(frame, state, EvaluateClouds(frame, state, next));
}

PointResidual* ObservationResiduals::EvaluateClouds(int frame, const State& state,
                                                    PointResidual* residuals) const {
  if (!clouds_) return residuals;
  std::vector<PointResidual> distances;
  for (std::size_t i = first_cloud_[frame]; i < first_cloud_[frame + 1]; ++i) {
    const CloudObservation& cloud = scene_.clouds->observations[i];
    if (scene_.IsFitted(cloud)) clouds_->Evaluate(cloud, state.x, &distances);
  }
  for (const PointResidual& r : distances) {
    using Scalar = Eigen::Matrix<double, 1, 1>;
    if (!r.IsZero()) {
      Store<1>(Scalar(r.value / scene_.cloud_sigma), r.slope / scene_.cloud_sigma, r.point,
               other_weight_, residuals);
    }
    ++residuals;
  }
  return residuals;
}

bool ObservationResiduals::EvaluateSilhouettes(int frame, const State& state,
                                               PointResidual* residuals) const {
  if (!scene_.silhouettes) return true;
  std::vector<const SilhouetteObservation*> measured;
  std::vector<PointResidual*> first;
  for (std::size_t i = first_silhouette_[frame]; i < first_silhouette_[frame + 1]; ++i) {
    const SilhouetteObservation& s = scene_.silhouettes->observations[i];
    if (!s.field) continue;
    measured.push_back(&s);
    first.push_back(residuals);
    residuals += soft_[s.camera]->Count(s);
  }
  std::vector<char> has_failed(measured.size(), 0);
  ParallelFor(static_cast<int>(measured.size()), NumThreads(0), [&](int i, int) {
    std::vector<PointResidual> soft;
    if (!soft_[measured[i]->camera]->Evaluate(*measured[i], state.x, &soft)) {
      has_failed[i] = 1;
      return;
    }
    PointResidual* next = first[i];
    for (const PointResidual& r : soft) {
      using Scalar = Eigen::Matrix<double, 1, 1>;
      if (!r.IsZero()) {
        Store<1>(Scalar(r.value / scene_.silhouette_sigma), r.slope / scene_.silhouette_sigma,
                 r.point, silhouette_weight_, next);
      }
      ++next;
    }
  });
  return std::find(has_failed.begin(), has_failed.end(), 1) == has_failed.end();
}

}  // namespace clothfit
