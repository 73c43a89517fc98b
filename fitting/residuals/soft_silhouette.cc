// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/soft_silhouette.h"

#include <algorithm>
#include <cmath>

#include <ceres/jet.h>

namespace clothfit {
namespace {

using Jet = ceres::Jet<double, 3>;

Eigen::Matrix<Jet, 2, 1> Project(const Camera& camera, const Eigen::Vector3d& point) {
  return ProjectPoint<Jet>(camera, {Jet(point.x(), 0), Jet(point.y(), 1), Jet(point.z(), 2)});
}

// The nearest point again, on the edge as the lens bends it: that a point slides has no derivative
// only where it is the nearest indeed. A corner stays one.
double ShareOfNearest(const Camera& camera, const Eigen::VectorXd& x, const OutlinePoint& nearest,
                      const Eigen::Vector2d& pixel) {
  double share = nearest.share;
  const Eigen::Vector3d a = x.segment<3>(3 * nearest.nodes[0]);
  const Eigen::Vector3d along = x.segment<3>(3 * nearest.nodes[1]) - a;
  for (int iteration = 0; iteration < 3 && share > 0.0 && share < 1.0; ++iteration) {
    using Slope = ceres::Jet<double, 1>;
    const Slope s(share, 0);
    const Eigen::Matrix<Slope, 2, 1> at =
        ProjectPoint<Slope>(camera, a.cast<Slope>() + s * along.cast<Slope>());
    const Eigen::Vector2d tangent(at.x().v[0], at.y().v[0]);
    const Eigen::Vector2d away(pixel.x() - at.x().a, pixel.y() - at.y().a);
    share = std::clamp(share + tangent.dot(away) / tangent.squaredNorm(), 0.0, 1.0);
  }
  return share;
}

}  // namespace

SoftSilhouette::SoftSilhouette(const Camera& camera, const ClothMesh& mesh)
    : camera_(camera),
      raster_(camera, mesh.triangles),
      edges_(FindEdges(mesh.triangles)),
      num_particles_(mesh.num_particles()) {}

SoftSilhouette::Residual SoftSilhouette::OfOutline(const Eigen::Vector2d& pixel,
                                                   const OutlinePoint& nearest,
                                                   const Eigen::VectorXd& x) const {
  const double share = ShareOfNearest(camera_, x, nearest, pixel);
  Residual residual;
  residual.point.nodes = {nearest.nodes[0], nearest.nodes[1], nearest.nodes[1]};
  residual.point.weights = {1.0 - share, share, 0.0};
  const Eigen::Matrix<Jet, 2, 1> at = Project(camera_, residual.point.At(x));
  const Eigen::Vector2d away(pixel.x() - at.x().a, pixel.y() - at.y().a);
  const double distance = away.norm();
  residual.value = std::copysign(distance, nearest.side.dot(away));
  // Where the two meet the difference has no direction, but the outline has.
  const Eigen::Vector2d direction =
      distance > 1e-9 ? Eigen::Vector2d(away / residual.value) : nearest.side;
  residual.slope = -(direction.x() * at.x().v + direction.y() * at.y().v).transpose();
  return residual;
}

SoftSilhouette::Residual SoftSilhouette::OfParticle(const SignedDistanceField& field, int particle,
                                                    double weight, const Eigen::VectorXd& x) const {
  Residual residual;
  residual.point.nodes = {particle, particle, particle};
  const Eigen::Matrix<Jet, 2, 1> at = Project(camera_, x.segment<3>(3 * particle));
  const SignedDistance distance = field.At({at.x().a, at.y().a});
  if (distance.value <= 0.0) return residual;
  residual.value = weight * distance.value;
  residual.slope =
      weight * (distance.gradient.x() * at.x().v + distance.gradient.y() * at.y().v).transpose();
  return residual;
}

bool SoftSilhouette::Evaluate(const SilhouetteObservation& measured, const Eigen::VectorXd& x,
                              std::vector<Residual>* residuals) const {
  residuals->clear();
  if (!x.allFinite()) return false;
  for (int i = 0; i < num_particles_; ++i) {
    if (!IsInFront(camera_, x.segment<3>(3 * i))) return false;
  }
  if (!measured.outline.empty()) {
    BitMask covered;
    raster_.Draw(x, &covered);
    const std::vector<OutlinePiece> outline =
        FindOutline(camera_, edges_, raster_.triangles(), x, covered);
    if (outline.empty()) return false;
    for (const Eigen::Vector2d& pixel : measured.outline) {
      residuals->push_back(OfOutline(pixel, *NearestOnOutline(outline, pixel), x));
    }
  }
  // As many in all as there are points of the outline, or one for each where there are none.
  const double weight = measured.outline.empty()
                            ? 1.0
                            : std::sqrt(static_cast<double>(measured.outline.size()) /
                                        static_cast<double>(num_particles_));
  for (int i = 0; i < num_particles_; ++i) {
    residuals->push_back(OfParticle(*measured.field, i, weight, x));
  }
  return true;
}

}  // namespace clothfit
