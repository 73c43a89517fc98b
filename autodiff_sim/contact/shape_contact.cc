// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/shape_contact.h"

#include <algorithm>
#include <limits>

namespace clothfit {
namespace {

using Eigen::Vector3d;

// Seen from the body, the point moves with R^T (v + w x r), where v is its velocity against the
// body's origin, w the body's turning and r its place against the origin. The shape is convex, so
// its distance is at least that of its tangential plane at the closest point: the gap closes no
// faster than the point moves along the normal n. At the time at hand v closes it with -n . v;
// until the end of the step R^T v changes by no more than |w| |v|, and w x r is at most |w| |r|.
class MovingPoint {
 public:
  MovingPoint(const Vector3d& p0, const Vector3d& p1, const ObstacleShape& shape,
              const RigidMotion& motion)
      : p0_(p0), velocity_(p1 - p0), shape_(shape), motion_(motion) {
    const double reach = std::max((p0 - motion.At(0.0).origin_in_world).norm(),
                                  (p1 - motion.At(1.0).origin_in_world).norm());
    const Vector3d relative = velocity_ - motion.velocity();
    turning_ = motion.angle() * (relative.norm() + reach);
    const double size = std::max({reach, p0.norm(), p1.norm()});
    rounding_ = 64.0 * std::numeric_limits<double>::epsilon() * size;
  }

  double rounding() const { return rounding_; }

  double Distance(double t) {
    found_ = DistanceInWorld<double>(shape_, motion_.At(t), p0_ + t * velocity_);
    return found_.distance;
  }

  double SafeStep(double target) const {
    const double along = found_.gradient.dot(motion_.velocity() - velocity_);
    const double closing = std::max(along, 0.0) + turning_;
    if (closing == 0.0) return std::numeric_limits<double>::infinity();
    return (found_.distance - target) / closing;
  }

 private:
  Vector3d p0_, velocity_;
  const ObstacleShape& shape_;
  const RigidMotion& motion_;
  double turning_ = 0.0;  // m a step, a bound
  double rounding_ = 0.0;
  SignedDistance<double> found_;
};

// visit(particle, time) for those that meet up to *until, which visit may lower.
template <class Visit>
void VisitImpacts(const Motion& cloth_motion, const ObstacleShape& shape, const RigidMotion& motion,
                  const Approach& approach, const double* until, const Visit& visit) {
  for (int i = 0; i < static_cast<int>(cloth_motion.x0.size()) / 3; ++i) {
    const std::optional<double> time =
        FirstShapeApproach(cloth_motion.x0.segment<3>(3 * i), cloth_motion.x1.segment<3>(3 * i),
                           shape, motion, approach, *until);
    if (time) visit(i, *time);
  }
}

}  // namespace

std::vector<ShapeContact> FindShapeProximity(const Eigen::VectorXd& x, const ObstacleShape& shape,
                                             const RigidPose& pose, double distance) {
  std::vector<ShapeContact> contacts;
  for (int i = 0; i < static_cast<int>(x.size()) / 3; ++i) {
    const SignedDistance<double> found = DistanceInWorld<double>(shape, pose, x.segment<3>(3 * i));
    if (found.distance < distance) contacts.push_back({i, found.distance, found.gradient});
  }
  return contacts;
}

std::optional<double> FirstShapeApproach(const Vector3d& p0, const Vector3d& p1,
                                         const ObstacleShape& shape, const RigidMotion& motion,
                                         const Approach& approach, double until) {
  MovingPoint point(p0, p1, shape, motion);
  return Advance(approach, until, &point);
}

std::vector<ShapeImpact> FindShapeContinuous(const Motion& cloth_motion, const ObstacleShape& shape,
                                             const RigidMotion& motion, const Approach& approach) {
  constexpr double kWholeStep = 1.0;
  std::vector<ShapeImpact> impacts;
  VisitImpacts(cloth_motion, shape, motion, approach, &kWholeStep, [&](int particle, double time) {
    impacts.push_back({particle, time});
  });
  return impacts;
}

double EarliestShapeImpact(const Motion& cloth_motion, const ObstacleShape& shape,
                           const RigidMotion& motion, const Approach& approach) {
  double until = 1.0;
  VisitImpacts(cloth_motion, shape, motion, approach, &until,
               [&](int, double time) { until = std::min(until, time); });
  return until;
}

}  // namespace clothfit
