// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/seen_cloth.h"

#include <algorithm>
#include <array>

#include "fitting/optimise/checked_factor.h"
#include "fitting/residuals/track_residual.h"

namespace clothfit {
namespace {

constexpr int kNodes = 5;  // along a side
constexpr int kUnknowns = 3 * kNodes * kNodes;
constexpr double kSigma = 0.02;  // m, of a node's displacement

struct NodeWeight {
  int node;
  double weight;
};

// Of the four nodes around a place on the cloth.
std::array<NodeWeight, 4> WeightsAt(const Eigen::Vector2d& uv, const Eigen::Vector2d& size) {
  std::array<int, 2> first;
  Eigen::Vector2d share;
  for (int k = 0; k < 2; ++k) {
    const double at = std::clamp(uv[k] / size[k], 0.0, 1.0) * (kNodes - 1);
    first[k] = std::min(static_cast<int>(at), kNodes - 2);
    share[k] = at - first[k];
  }
  std::array<NodeWeight, 4> weights;
  for (int k = 0; k < 4; ++k) {
    const int i = k % 2, j = k / 2;
    weights[k] = {(first[1] + j) * kNodes + first[0] + i,
                  (i == 1 ? share[0] : 1.0 - share[0]) * (j == 1 ? share[1] : 1.0 - share[1])};
  }
  return weights;
}

// Normal equations of the nodes' displacements.
class Equations {
 public:
  explicit Equations(const Scene& scene) : scene_(scene) {
    information_.setIdentity(kUnknowns, kUnknowns);
    information_ /= kSigma * kSigma;
    gradient_.setZero(kUnknowns);
  }

  // A residual (in sigmas) of a point of the cloth and its derivative by the point's place.
  template <int Rows>
  void Add(const SurfacePoint& point, const Eigen::Matrix<double, Rows, 1>& residual,
           const Eigen::Matrix<double, Rows, 3>& by_place) {
    const auto weights = WeightsAt(point.At(scene_.mesh.uv), scene_.recording.cloth.size);
    for (const NodeWeight& a : weights) {
      gradient_.segment<3>(3 * a.node) += a.weight * (by_place.transpose() * residual);
      for (const NodeWeight& b : weights) {
        information_.block<3, 3>(3 * a.node, 3 * b.node) +=
            a.weight * b.weight * (by_place.transpose() * by_place);
      }
    }
    is_any_ = true;
  }

  Eigen::VectorXd Moved(const Eigen::VectorXd& x) const {
    if (!is_any_) return x;
    const auto factor = TrySemidefinite(information_);
    if (!factor) return x;  // what was seen is no number
    const Eigen::VectorXd by = -factor->solve(gradient_);
    Eigen::VectorXd moved = x;
    for (std::size_t i = 0; i < scene_.mesh.uv.size(); ++i) {
      for (const NodeWeight& w : WeightsAt(scene_.mesh.uv[i], scene_.recording.cloth.size))
        moved.segment<3>(3 * static_cast<Eigen::Index>(i)) += w.weight * by.segment<3>(3 * w.node);
    }
    return moved;
  }

 private:
  const Scene& scene_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
  bool is_any_ = false;
};

}  // namespace

Eigen::VectorXd MovedToWhatWasSeen(const Scene& scene, int frame, const Eigen::VectorXd& x) {
  Equations equations(scene);
  for (const MarkerObservation& m : scene.markers) {
    if (m.frame != frame) continue;
    equations.Add<3>(m.on_cloth, (m.on_cloth.At(x) - m.position) / scene.marker_sigma,
                     Eigen::Matrix3d::Identity() / scene.marker_sigma);
  }
  for (const TrackObservation& t : scene.tracks) {
    const Eigen::Vector3d place = t.on_cloth.At(x);
    if (t.frame != frame || !IsInFront(scene.recording.cameras[t.camera], place)) continue;
    const TrackResidual residual = ResidualOfTrack(scene, t, place);
    equations.Add<2>(t.on_cloth, residual.value, residual.by_place);
  }
  return equations.Moved(x);
}

}  // namespace clothfit
