// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/continuous.h"

#include <algorithm>

#include "autodiff_sim/contact/candidates.h"
#include "autodiff_sim/contact/first_approach.h"

namespace clothfit {
namespace {

// m. Half of the distance at which a pair may count as having met, so that none is culled that
// would.
double Margin(const Approach& approach) { return 0.5 * (approach.separation + approach.tolerance); }

// Calls visit(pair, time) for the pairs that meet up to *until, which visit may lower.
template <int Planes, class Visit>
void VisitImpacts(const Motion& motion, const Approach& approach, const double* until,
                  CollisionSurface<Planes>* surface, const Visit& visit) {
  surface->RefitSwept(motion.x0, motion.x1, Margin(approach));
  const PlacedMesh start{surface->features(), motion.x0}, end{surface->features(), motion.x1};
  VisitCandidates(*surface, [&](const FeaturePair& pair) {
    const std::optional<double> time = FirstApproach(pair, PairPoints(pair, start, start),
                                                     PairPoints(pair, end, end), approach, *until);
    if (time) visit(pair, *time);
  });
}

template <int Planes, class Visit>
void VisitImpacts(const Motion& cloth_motion, const Motion& obstacle_motion,
                  const Approach& approach, const double* until, CollisionSurface<Planes>* cloth,
                  CollisionSurface<Planes>* obstacle, const Visit& visit) {
  cloth->RefitSwept(cloth_motion.x0, cloth_motion.x1, Margin(approach));
  obstacle->RefitSwept(obstacle_motion.x0, obstacle_motion.x1, Margin(approach));
  const PlacedMesh a0{cloth->features(), cloth_motion.x0}, a1{cloth->features(), cloth_motion.x1};
  const PlacedMesh b0{obstacle->features(), obstacle_motion.x0};
  const PlacedMesh b1{obstacle->features(), obstacle_motion.x1};
  VisitCandidates(*cloth, *obstacle, [&](const FeaturePair& pair) {
    const std::optional<double> time =
        FirstApproach(pair, PairPoints(pair, a0, b0), PairPoints(pair, a1, b1), approach, *until);
    if (time) visit(pair, *time);
  });
}

// visit_all(until, visit) is one of the two above.
template <class VisitAll>
std::vector<Impact> ListImpacts(const VisitAll& visit_all) {
  constexpr double kWholeStep = 1.0;
  std::vector<Impact> impacts;
  visit_all(&kWholeStep, [&](const FeaturePair& pair, double time) {
    impacts.push_back({pair, time});
  });
  std::sort(impacts.begin(), impacts.end(),
            [](const Impact& a, const Impact& b) { return a.pair < b.pair; });
  return impacts;
}

template <class VisitAll>
double SmallestTime(const VisitAll& visit_all) {
  double until = 1.0;
  visit_all(&until, [&](const FeaturePair&, double time) { until = std::min(until, time); });
  return until;
}

}  // namespace

std::optional<double> FirstApproach(const FeaturePair& pair, const FourPoints& x0,
                                    const FourPoints& x1, const Approach& approach, double until) {
  if (pair.kind == PairKind::kEdgeEdge) return FirstEdgeEdgeApproach(x0, x1, approach, until);
  return FirstVertexTriangleApproach(x0, x1, approach, until);
}

template <int Planes>
std::vector<Impact> FindContinuous(const Motion& motion, const Approach& approach,
                                   CollisionSurface<Planes>* surface) {
  return ListImpacts([&](const double* until, const auto& visit) {
    VisitImpacts(motion, approach, until, surface, visit);
  });
}

template <int Planes>
std::vector<Impact> FindContinuous(const Motion& cloth_motion, const Motion& obstacle_motion,
                                   const Approach& approach, CollisionSurface<Planes>* cloth,
                                   CollisionSurface<Planes>* obstacle) {
  return ListImpacts([&](const double* until, const auto& visit) {
    VisitImpacts(cloth_motion, obstacle_motion, approach, until, cloth, obstacle, visit);
  });
}

template <int Planes>
double EarliestImpact(const Motion& motion, const Approach& approach,
                      CollisionSurface<Planes>* surface) {
  return SmallestTime([&](const double* until, const auto& visit) {
    VisitImpacts(motion, approach, until, surface, visit);
  });
}

template <int Planes>
double EarliestImpact(const Motion& cloth_motion, const Motion& obstacle_motion,
                      const Approach& approach, CollisionSurface<Planes>* cloth,
                      CollisionSurface<Planes>* obstacle) {
  return SmallestTime([&](const double* until, const auto& visit) {
    VisitImpacts(cloth_motion, obstacle_motion, approach, until, cloth, obstacle, visit);
  });
}

#define CLOTHFIT_INSTANTIATE(PLANES)                                                         \
  template std::vector<Impact> FindContinuous(const Motion&, const Approach&,                \
                                              CollisionSurface<PLANES>*);                    \
  template std::vector<Impact> FindContinuous(const Motion&, const Motion&, const Approach&, \
                                              CollisionSurface<PLANES>*,                     \
                                              CollisionSurface<PLANES>*);                    \
  template double EarliestImpact(const Motion&, const Approach&, CollisionSurface<PLANES>*); \
  template double EarliestImpact(const Motion&, const Motion&, const Approach&,              \
                                 CollisionSurface<PLANES>*, CollisionSurface<PLANES>*)
CLOTHFIT_INSTANTIATE(6);
CLOTHFIT_INSTANTIATE(14);
CLOTHFIT_INSTANTIATE(18);
CLOTHFIT_INSTANTIATE(26);
#undef CLOTHFIT_INSTANTIATE

}  // namespace clothfit
