// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// With CGAL's predicates: floating point with error bounds first, exact numbers where these do not
// decide. The only file that sees CGAL.
#include "autodiff_sim/contact/edge_triangle_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

namespace clothfit {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;

Point ToPoint(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

// Closed; p and r may be the same point.
bool LiesBetween(const Point& p, const Point& q, const Point& r) {
  return CGAL::collinear(p, q, r) && CGAL::collinear_are_ordered_along_line(p, q, r);
}

bool SegmentsMeet(const Segment& a, const Segment& b) {
  if (a.is_degenerate()) return LiesBetween(b.source(), a.source(), b.target());
  if (b.is_degenerate()) return LiesBetween(a.source(), b.source(), a.target());
  return CGAL::do_intersect(a, b);
}

}  // namespace

bool EdgeMeetsTriangle(const std::array<Eigen::Vector3d, 2>& edge,
                       const std::array<Eigen::Vector3d, 3>& triangle) {
  const Segment segment(ToPoint(edge[0]), ToPoint(edge[1]));
  const Point a = ToPoint(triangle[0]), b = ToPoint(triangle[1]), c = ToPoint(triangle[2]);
  const Triangle whole(a, b, c);
  if (whole.is_degenerate()) {  // its three sides cover it
    return SegmentsMeet(segment, {a, b}) || SegmentsMeet(segment, {b, c}) ||
           SegmentsMeet(segment, {c, a});
  }
  if (segment.is_degenerate()) return CGAL::do_intersect(whole, segment.source());
  return CGAL::do_intersect(whole, segment);
}

}  // namespace clothfit
