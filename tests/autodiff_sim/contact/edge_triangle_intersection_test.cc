// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Against integers of 128 bits, which are exact.
#include "autodiff_sim/contact/edge_triangle_intersection.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

using Eigen::Vector3d;

__extension__ using Integer = __int128;
using Lattice = std::array<long long, 3>;  // in units of 2^-20 m

Vector3d ToMetres(const Lattice& p) {
  constexpr double kUnit = 1.0 / (1 << 20);
  return kUnit *
         Vector3d(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

bool Meet(const Lattice& p, const Lattice& q, const std::array<Lattice, 3>& t) {
  return EdgeMeetsTriangle({ToMetres(p), ToMetres(q)},
                           {ToMetres(t[0]), ToMetres(t[1]), ToMetres(t[2])});
}

int Sign(Integer value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// Of a, b, c seen along an axis.
int Turn(const Lattice& a, const Lattice& b, const Lattice& c, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return Sign(Integer(b[u] - a[u]) * (c[v] - a[v]) - Integer(b[v] - a[v]) * (c[u] - a[u]));
}

// On which side of the plane a, b, c p lies.
int Side(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& p) {
  Integer sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    sum += (Integer(b[u] - a[u]) * (c[v] - a[v]) - Integer(b[v] - a[v]) * (c[u] - a[u])) *
           (p[axis] - a[axis]);
  }
  return Sign(sum);
}

// Closed segments in one plane across the axis, both of some length.
bool SegmentsMeet(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& d,
                  int axis) {
  for (int k = 0; k < 3; ++k) {  // their boxes
    if (std::max(a[k], b[k]) < std::min(c[k], d[k])) return false;
    if (std::max(c[k], d[k]) < std::min(a[k], b[k])) return false;
  }
  return Turn(a, b, c, axis) * Turn(a, b, d, axis) <= 0 &&
         Turn(c, d, a, axis) * Turn(c, d, b, axis) <= 0;
}

// For triangles with area.
bool Expected(const Lattice& p, const Lattice& q, const std::array<Lattice, 3>& t) {
  const int side_p = Side(t[0], t[1], t[2], p), side_q = Side(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p != 0 || side_q != 0) {
    int low = 1, high = -1;
    for (int k = 0; k < 3; ++k) {
      const int side = Side(p, q, t[k], t[(k + 1) % 3]);
      low = std::min(low, side);
      high = std::max(high, side);
    }
    return low * high >= 0;
  }
  int axis = 0;
  while (Turn(t[0], t[1], t[2], axis) == 0) ++axis;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    if (SegmentsMeet(p, q, t[k], t[(k + 1) % 3], axis)) return true;
    inside &= Turn(t[k], t[(k + 1) % 3], p, axis) * Turn(t[0], t[1], t[2], axis) > 0;
  }
  return inside;
}

bool HasArea(const std::array<Lattice, 3>& t) {
  return Turn(t[0], t[1], t[2], 0) != 0 || Turn(t[0], t[1], t[2], 1) != 0 ||
         Turn(t[0], t[1], t[2], 2) != 0;
}

Lattice RandomPoint(long long size, std::mt19937* random) {
  std::uniform_int_distribution<long long> place(-size, size);
  const long long x = place(*random), y = place(*random), z = place(*random);
  return {x, y, z};
}

// A point of the triangle's plane, or one unit of 1e-6 m off it.
Lattice NearThePlane(const std::array<Lattice, 3>& t, std::mt19937* random) {
  std::uniform_int_distribution<int> times(-2, 2), off(-1, 1);
  const int i = times(*random), j = times(*random);
  Lattice p;
  for (int k = 0; k < 3; ++k) {
    p[k] = t[0][k] + i * (t[1][k] - t[0][k]) + j * (t[2][k] - t[0][k]);
  }
  p[2] += off(*random);
  return p;
}

TEST(EdgeTriangleIntersection, IsExactNearThePlane) {
  std::mt19937 random(9);
  int met = 0, apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const long long size = i % 2 == 0 ? 3 : 1 << 24;
    std::array<Lattice, 3> t;
    for (Lattice& corner : t) corner = RandomPoint(size, &random);
    const Lattice p = NearThePlane(t, &random);
    const Lattice q = i % 3 == 0 ? RandomPoint(size, &random) : NearThePlane(t, &random);
    if (!HasArea(t) || p == q) continue;
    const bool expected = Expected(p, q, t);
    EXPECT_EQ(Meet(p, q, t), expected) << i;
    EXPECT_EQ(Meet(q, p, {t[1], t[0], t[2]}), expected) << i;
    expected ? ++met : ++apart;
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(apart, 2000);
}

// Doubles that differ in their last bit: the floating-point determinant is noise there.
TEST(EdgeTriangleIntersection, SeesTheLastBit) {
  const std::array<Vector3d, 3> triangle = {Vector3d(12.0, 12.0, 0.0), Vector3d(24.0, 24.0, 1.0),
                                            Vector3d(24.0, 24.0, -1.0)};  // in the plane x = y
  const double epsilon = std::numeric_limits<double>::epsilon();
  int met = 0;
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      // From a point beside the plane to one near it, at the triangle's middle.
      const Vector3d near_plane(16.0 + 16.0 * i * epsilon, 16.0 + 16.0 * j * epsilon, 0.0);
      const bool meets = EdgeMeetsTriangle({Vector3d(17.0, 15.0, 0.0), near_plane}, triangle);
      EXPECT_EQ(meets, i <= j) << i << " " << j;
      met += meets ? 1 : 0;
    }
  }
  EXPECT_EQ(met, 17 * 18 / 2);
}

TEST(EdgeTriangleIntersection, WithoutLengthOrAreaIsWhatRemains) {
  const Lattice o = {0, 0, 0}, x = {4, 0, 0}, y = {0, 4, 0}, inside = {1, 1, 0}, above = {1, 1, 1};
  const Lattice middle = {2, 0, 0}, beyond = {6, 0, 0}, under = {1, 1, -1};
  EXPECT_TRUE(Meet(above, under, {o, x, y}));
  EXPECT_TRUE(Meet(inside, inside, {o, x, y}));
  EXPECT_FALSE(Meet(above, above, {o, x, y}));
  EXPECT_TRUE(Meet(o, above, {o, x, y}));        // touches a corner
  EXPECT_TRUE(Meet(middle, beyond, {o, x, x}));  // along a segment
  EXPECT_FALSE(Meet(beyond, {5, 0, 0}, {o, x, x}));
  EXPECT_TRUE(Meet(inside, {3, -1, 0}, {o, x, o}));  // across it
  EXPECT_TRUE(Meet(middle, middle, {x, o, x}));
  EXPECT_TRUE(Meet(o, x, {middle, middle, middle}));
  EXPECT_FALSE(Meet(o, y, {middle, middle, middle}));
  EXPECT_TRUE(Meet(o, o, {o, o, o}));
  EXPECT_FALSE(Meet(o, o, {x, x, x}));
  EXPECT_TRUE(Meet(middle, under, {o, beyond, x}));  // corners in line, not in order
}

}  // namespace
}  // namespace clothfit
