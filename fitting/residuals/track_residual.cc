// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/track_residual.h"

#include <ceres/jet.h>

namespace clothfit {

TrackResidual ResidualOfTrack(const Scene& scene, const TrackObservation& track,
                              const Eigen::Vector3d& place) {
  using Jet = ceres::Jet<double, 3>;
  const Eigen::Matrix<Jet, 3, 1> point(Jet(place.x(), 0), Jet(place.y(), 1), Jet(place.z(), 2));
  const Eigen::Matrix<Jet, 2, 1> pixel =
      ProjectPoint<Jet>(scene.recording.cameras[track.camera], point);
  TrackResidual residual;
  for (int k = 0; k < 2; ++k) {
    residual.value[k] = (pixel[k].a - track.pixel[k]) / scene.track_sigma;
    residual.by_place.row(k) = pixel[k].v.transpose() / scene.track_sigma;
  }
  return residual;
}

}  // namespace clothfit
