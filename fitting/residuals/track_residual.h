// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A track against a place of the cloth.
#pragma once

#include <Eigen/Core>

#include "fitting/scene/scene.h"

namespace clothfit {

struct TrackResidual {
  Eigen::Vector2d value;                 // sigmas: where it should be seen less where it is
  Eigen::Matrix<double, 2, 3> by_place;  // its derivative, 1/m
};

// `place` (m, world) has to be in front of the track's camera (IsInFront).
TrackResidual ResidualOfTrack(const Scene& scene, const TrackObservation& track,
                              const Eigen::Vector3d& place);

}  // namespace clothfit
