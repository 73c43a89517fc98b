// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The error of Hasler et al. 2007 by which all optimisers and strategies are compared.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/residuals/cloud_residuals.h"
#include "fitting/residuals/hard_silhouette.h"
#include "fitting/scene/scene.h"
#include "tracking/camera/plucker_ray.h"

namespace clothfit {

// E = alpha E_s + beta E_a (sec. 6.2), summed over frames: E_s the pixels in which silhouettes
// differ, of all fitted cameras; E_a the mean length of a frame's attractors in millimetres, that
// is of the distances between points of the cloth and their markers or, of tracks, rays, and those
// of clouds' points from the cloth.
class SynthesisError {
 public:
  // The scene must outlive it.
  SynthesisError(const Scene& scene, const FitConfig& config);

  // E of one fitted frame for particles at x (3N, m, world); 0 in a frame that is not fitted, and
  // infinite where x is not finite.
  double OfFrame(int frame, const Eigen::VectorXd& x) const;
  // E_a of one frame, mm; 0 without attractors.
  double MeanAttractor(int frame, const Eigen::VectorXd& x) const;

 private:
  const Scene& scene_;
  double alpha_, beta_;
  HardSilhouette hard_;
  CloudResiduals clouds_;
  std::vector<PluckerRay<double>> rays_;  // of the scene's tracks; zero where the lens has none
};

}  // namespace clothfit
