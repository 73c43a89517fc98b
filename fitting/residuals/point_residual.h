// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "autodiff_sim/mesh/surface_point.h"
#include "autodiff_sim/step/state.h"

namespace clothfit {

// A residual that one point of the cloth alone moves.
struct PointResidual {
  double value = 0.0;
  SurfacePoint point;
  Eigen::RowVector3d slope = Eigen::RowVector3d::Zero();  // 1/m, by the point's position (world)

  bool IsZero() const { return value == 0.0 && slope.isZero(0.0); }
};

// The residual's derivatives along all directions.
void SetDirections(const PointResidual& residual, const Sensitivity& sensitivity,
                   Eigen::Ref<Eigen::RowVectorXd> row);

}  // namespace clothfit
