// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/point_residual.h"

#include <algorithm>

namespace clothfit {

void SetDirections(const PointResidual& residual, const Sensitivity& sensitivity,
                   Eigen::Ref<Eigen::RowVectorXd> row) {
  const int directions = sensitivity.num_directions();
  for (int c = 0; c < directions; c += kLanes) {
    const int count = std::min(kLanes, directions - c);
    const StateLanes& lanes = sensitivity.lanes()[c / kLanes];
    Eigen::Matrix<double, 1, kLanes> sum = Eigen::Matrix<double, 1, kLanes>::Zero();
    for (int k = 0; k < 3 && !lanes.is_zero; ++k) {
      const double weight = residual.point.weights[k];
      if (weight != 0.0)
        sum += weight * (residual.slope * lanes.x.middleRows<3>(3 * residual.point.nodes[k]));
    }
    row.segment(c, count) = sum.head(count);
  }
}

}  // namespace clothfit
