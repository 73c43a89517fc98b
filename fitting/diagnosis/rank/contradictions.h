// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What cameras and markers say against each other. Several of them see the same cloth: where one of
// them is wrong, they contradict each other whatever the cloth does, so that neither missing
// physics nor mesh and step can be taken for it.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/rank/ranking.h"
#include "fitting/residuals/point_residual.h"

namespace clothfit {

// Products of columns with every motion of the cloth taken out, and how many rows there are more
// than motions that they can follow.
struct MotionlessProducts {
  Eigen::MatrixXd gram;  // columns x columns
  double freedom = 0.0;
};

// Of one frame. points: of the rows, by their slopes; columns: rows x columns. With C the columns,
// H = d residuals / d particles, and a sigma s of 1 m for each coordinate of a particle, products
// are C'C - C'H (H'H + I/s^2)^-1 H'C.
MotionlessProducts WithoutMotion(const std::vector<PointResidual>& points,
                                 const Eigen::MatrixXd& columns);

// Are there points of two sources at least: cameras with tracks, and markers?
bool CanContradict(const Scene& scene);

// Faults of cameras and of all markers together, scored by the points (markers and tracks) of a
// fit, with every motion of its mesh taken out in each frame. The null is noise and the errors of
// well-made recordings. Throws std::runtime_error where the scene cannot be simulated.
Ranking RankContradictions(const FittedScene& fitted, const DiagnosisOptions& options);

// Takes faults off the short list of another ranking that sources would contradict, were they as
// large as is tolerated, and do not.
void TakeOutWhatAgrees(const Ranking& contradictions, Ranking* ranking);

}  // namespace clothfit
