// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The soft silhouette error: how far the outlines of the simulated and the measured silhouette are
// apart, in pixels, with derivatives. It takes the place of the hard error, the number of pixels in
// which the two differ (Hasler et al. 2007, sec. 5), which has none.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "fitting/residuals/point_residual.h"
#include "fitting/scene/silhouettes.h"
#include "tracking/camera/camera.h"
#include "tracking/silhouette/outline.h"
#include "tracking/silhouette/raster.h"

namespace clothfit {

// One camera. Two kinds of residuals:
// - of each point of the measured outline: the signed distance to the nearest point of the
// simulated
//   one, positive where the simulated cloth does not reach it. Nearest points are found on plain
//   values; as they are nearest, their own sliding along the outline has no derivative.
// - of each particle: how far outside the measured silhouette it lies, 0 within.
// Without the first a hole in the simulated cloth would go unseen, without the second a flap beside
// the measured outline. The sum of their squares over the number of outline points is the mean
// square of the first kind plus that of the second. The gradient is exact but where a nearest point
// jumps from one part of the outline to another, or lies where one part of the cloth begins to hide
// another.
class SoftSilhouette {
 public:
  using Residual = PointResidual;  // in px

  SoftSilhouette(const Camera& camera, const ClothMesh& mesh);

  int Count(const SilhouetteObservation& measured) const {
    return static_cast<int>(measured.outline.size()) + num_particles_;
  }

  // The residuals for particles at x (3N, m, world), Count(measured) of them. `measured` must have
  // a field. False where a particle does not lie in front of the camera, or nothing of the
  // simulated cloth has an outline.
  bool Evaluate(const SilhouetteObservation& measured, const Eigen::VectorXd& x,
                std::vector<Residual>* residuals) const;

 private:
  Residual OfOutline(const Eigen::Vector2d& pixel, const OutlinePoint& nearest,
                     const Eigen::VectorXd& x) const;
  Residual OfParticle(const SignedDistanceField& field, int particle, double weight,
                      const Eigen::VectorXd& x) const;

  Camera camera_;
  SilhouetteRaster raster_;
  std::vector<MeshEdge> edges_;
  int num_particles_;
};

}  // namespace clothfit
