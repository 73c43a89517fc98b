// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which features meet during a step, and how much of the step is free of it. All vertices move on
// straight lines, those of an obstacle too: one that turns shrinks a little on its way.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/collision_surface.h"
#include "autodiff_sim/contact/conservative_advancement.h"
#include "autodiff_sim/contact/feature_pair.h"

namespace clothfit {

// A pair that meets, at `time` in [0, 1] of the step; see Advance() for what that means.
struct Impact {
  FeaturePair pair;
  double time;
};

// A surface's motion during the step.
struct Motion {
  const Eigen::VectorXd& x0;  // 3N, m, at time 0
  const Eigen::VectorXd& x1;  // at time 1
};

// The first time in [0, until] at which one pair has met.
std::optional<double> FirstApproach(const FeaturePair& pair, const FourPoints& x0,
                                    const FourPoints& x1, const Approach& approach,
                                    double until = 1.0);

// All pairs of features of a surface that meet, those with a vertex in common excepted; sorted. A
// pair that starts within the separation has time 0. None is missed and none is late.
template <int Planes>
std::vector<Impact> FindContinuous(const Motion& motion, const Approach& approach,
                                   CollisionSurface<Planes>* surface);
// The same between a cloth and an obstacle.
template <int Planes>
std::vector<Impact> FindContinuous(const Motion& cloth_motion, const Motion& obstacle_motion,
                                   const Approach& approach, CollisionSurface<Planes>* cloth,
                                   CollisionSurface<Planes>* obstacle);

// The smallest time of FindContinuous(), or 1: up to there every pair that starts beyond the
// separation stays beyond it. Faster than the list; meant as the bound of a line search.
template <int Planes>
double EarliestImpact(const Motion& motion, const Approach& approach,
                      CollisionSurface<Planes>* surface);
template <int Planes>
double EarliestImpact(const Motion& cloth_motion, const Motion& obstacle_motion,
                      const Approach& approach, CollisionSurface<Planes>* cloth,
                      CollisionSurface<Planes>* obstacle);

}  // namespace clothfit
