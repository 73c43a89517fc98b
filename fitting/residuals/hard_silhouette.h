// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The hard silhouette error: the pixels in which the simulated and the measured silhouette differ
// (Hasler et al. 2007, sec. 5: E_sf is its sum over the cameras, E_s that over the frames).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "fitting/scene/scene.h"
#include "tracking/silhouette/raster.h"

namespace clothfit {

class HardSilhouette {
 public:
  // The scene must outlive it.
  explicit HardSilhouette(const Scene& scene);

  struct Difference {
    int camera = 0;
    std::int64_t pixels = 0;
  };
  // For particles at x (3N, m, world), of every camera that has a mask in this frame, held out ones
  // included. What is not a number covers nothing.
  std::vector<Difference> Differences(int frame, const Eigen::VectorXd& x) const;

  // E_sf: the sum over the cameras that are fitted; 0 in a frame that is not.
  std::int64_t FittedDifference(int frame, const Eigen::VectorXd& x) const;

 private:
  const Scene& scene_;
  std::vector<std::unique_ptr<SilhouetteRaster>> rasters_;  // by camera; null without a mask
};

}  // namespace clothfit
