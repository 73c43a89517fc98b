// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Continuous detection against dense samples of the motion, and against the times at which four
// points are coplanar (Bridson, Fedkiw and Anderson 2002, sec. 6): the roots of a cubic.
#include "autodiff_sim/contact/first_approach.h"

#include <algorithm>
#include <complex>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/autodiff_sim/contact/random_points.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

enum class Kind { kVertexTriangle, kEdgeEdge };
constexpr std::array<Kind, 2> kKinds = {Kind::kVertexTriangle, Kind::kEdgeEdge};

FourPoints At(const FourPoints& x0, const FourPoints& x1, double t) {
  FourPoints x;
  for (int i = 0; i < 4; ++i) x[i] = x0[i] + t * (x1[i] - x0[i]);
  return x;
}

double Distance(Kind kind, const FourPoints& x) {
  return kind == Kind::kEdgeEdge ? ClosestEdgeEdge(x).distance : ClosestVertexTriangle(x).distance;
}

std::optional<double> Find(Kind kind, const FourPoints& x0, const FourPoints& x1,
                           const Approach& approach, double until = 1.0) {
  return kind == Kind::kEdgeEdge ? FirstEdgeEdgeApproach(x0, x1, approach, until)
                                 : FirstVertexTriangleApproach(x0, x1, approach, until);
}

double Determinant(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return a.cross(b).dot(c);
}

// Times in [0, 1], in order, at which the moving points lie in one plane.
std::vector<double> CoplanarTimes(const FourPoints& x0, const FourPoints& x1) {
  std::array<Vector3d, 3> p, v;
  for (int i = 0; i < 3; ++i) {
    p[i] = x0[i + 1] - x0[0];
    v[i] = (x1[i + 1] - x1[0]) - p[i];
  }
  const double c0 = Determinant(p[0], p[1], p[2]), c3 = Determinant(v[0], v[1], v[2]);
  const double c1 =
      Determinant(v[0], p[1], p[2]) + Determinant(p[0], v[1], p[2]) + Determinant(p[0], p[1], v[2]);
  const double c2 =
      Determinant(p[0], v[1], v[2]) + Determinant(v[0], p[1], v[2]) + Determinant(v[0], v[1], p[2]);
  Eigen::Matrix3d companion;
  companion << 0.0, 0.0, -c0 / c3, 1.0, 0.0, -c1 / c3, 0.0, 1.0, -c2 / c3;
  std::vector<double> times;
  for (const std::complex<double>& root : companion.eigenvalues()) {
    const bool real = std::abs(root.imag()) < 1e-9;
    if (real && root.real() >= 0.0 && root.real() <= 1.0) times.push_back(root.real());
  }
  std::sort(times.begin(), times.end());
  return times;
}

std::optional<double> FirstByCubic(Kind kind, const FourPoints& x0, const FourPoints& x1) {
  for (const double time : CoplanarTimes(x0, x1)) {
    if (Distance(kind, At(x0, x1, time)) < 1e-7) return time;  // the roots are good to about 1e-10
  }
  return std::nullopt;
}

// Ends of a motion: another position, the same moved as a whole, a slide past each other, or rest.
FourPoints RandomEnd(Position position, int i, const FourPoints& x0, std::mt19937* random) {
  FourPoints x1 = RandomPoints(position, random);
  if (i % 4 == 1) {
    const Vector3d shift = x1[1] - x1[0];
    for (int k = 0; k < 4; ++k) x1[k] = x0[k] + shift;
  } else if (i % 4 == 2) {
    const Vector3d slide = 3.0 * (x0[3] - x0[2]);  // in the triangle's plane, along the second edge
    for (int k = 0; k < 4; ++k) x1[k] = x0[k] + (k < 2 ? slide : Vector3d(-slide));
  } else if (i % 4 == 3 && i % 8 == 3) {
    x1 = x0;
  }
  return x1;
}

// The gap is above 0 at every earlier time, and at the time found it is small.
TEST(FirstApproach, NeverMissesInAnyPosition) {
  std::mt19937 random(7);
  constexpr int kSamples = 64;
  int met = 0, missed = 0, loose = 0;
  for (const Kind kind : kKinds) {
    for (const Position position : kPositions) {
      for (int i = 0; i < 800; ++i) {
        const FourPoints x0 = RandomPoints(position, &random);
        const FourPoints x1 = RandomEnd(position, i, x0, &random);
        const double size = position == Position::kTiny ? 1e-6 : 1.0;
        const Approach approach{i % 3 == 0 ? 0.05 * size : 0.0, i % 7 == 0 ? 1e-3 * size : 1.0,
                                i % 5 == 0 ? 1e-3 : 0.1};
        const double gap = Distance(kind, x0) - approach.separation;
        const std::optional<double> time = Find(kind, x0, x1, approach);
        SCOPED_TRACE(testing::Message()
                     << static_cast<int>(kind) << ", " << static_cast<int>(position) << ", " << i);
        time ? ++met : ++missed;
        if (gap <= 0.0) {
          EXPECT_EQ(time, 0.0);
          continue;
        }
        const double safe = time.value_or(1.0);
        ASSERT_GE(safe, 0.0);
        ASSERT_LE(safe, 1.0);
        // At() rounds differently from the query, by no more than this.
        const double rounding = (position == Position::kFarAway ? 1e-12 : 1e-14) * size;
        for (int k = 0; k <= kSamples; ++k) {
          const FourPoints x = At(x0, x1, safe * k / kSamples);
          EXPECT_GT(Distance(kind, x), approach.separation - rounding);
        }
        if (!time) continue;
        const double left = Distance(kind, At(x0, x1, safe)) - approach.separation;
        const double small = std::min(approach.tolerance, approach.slack * gap);
        // From a gap that is all rounding there may be too many steps to make.
        if (gap > 1e-8 * size && left > small + 100.0 * rounding) ++loose;
      }
    }
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(missed, 2000);
  EXPECT_EQ(loose, 0);
}

// Motions that are built around a contact, at a time that may be early and from a gap that may be
// 1e-10 of the size, with triangles and edges that are degenerate. There rounding is the enemy.
TEST(FirstApproach, FindsEveryContactThatWasBuilt) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit;
  for (const Kind kind : kKinds) {
    for (const Position position :
         {Position::kGeneral, Position::kCoplanar, Position::kOnGrid, Position::kCollinear,
          Position::kParallel, Position::kNearlyParallel, Position::kSliver}) {
      for (int i = 0; i < 1000; ++i) {
        FourPoints contact = RandomPoints(position, &random);
        const double s = unit(random), t = unit(random);
        const double u = std::min(s, t), v = std::max(s, t) - u;
        if (kind == Kind::kVertexTriangle) {
          contact[0] = contact[1] + u * (contact[2] - contact[1]) + v * (contact[3] - contact[1]);
        } else {
          const Vector3d on_first = contact[0] + s * (contact[1] - contact[0]);
          const Vector3d apart = on_first - (contact[2] + t * (contact[3] - contact[2]));
          contact[0] -= apart;
          contact[1] -= apart;
        }
        const double met = unit(random) * (i % 3 == 0 ? 1.0 : i % 3 == 1 ? 1e-6 : 1e-10);
        const FourPoints velocity = RandomPoints(Position::kGeneral, &random);
        FourPoints x0, x1;
        for (int k = 0; k < 4; ++k) {
          x0[k] = contact[k] - met * velocity[k];
          x1[k] = contact[k] + (1.0 - met) * velocity[k];
        }
        const double slack = i % 2 == 0 ? 0.1 : 1e-6;
        const std::optional<double> time = Find(kind, x0, x1, {0.0, 1.0, slack});
        ASSERT_TRUE(time.has_value()) << static_cast<int>(position) << ", " << i;
        EXPECT_LE(*time, met + 1e-13);  // the contact itself is rounded
      }
    }
  }
}

TEST(FirstApproach, AgreesWithTheCubicInGeneralPosition) {
  std::mt19937 random(8);
  int met = 0;
  for (const Kind kind : kKinds) {
    for (int i = 0; i < 5000; ++i) {
      const FourPoints x0 = RandomPoints(Position::kGeneral, &random);
      const FourPoints x1 = RandomPoints(Position::kGeneral, &random);
      const std::optional<double> expected = FirstByCubic(kind, x0, x1);
      const std::optional<double> time = Find(kind, x0, x1, {0.0, 1.0, 1e-6});
      SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << ", " << i);
      if (expected) {
        ASSERT_TRUE(time.has_value());
        EXPECT_LE(*time, *expected + 1e-7);  // the rounding of a root that is nearly double
        // The gap left is 1e-6 of the first; what is left of the time is that over the closing
        // speed, or its root where they only just meet.
        EXPECT_GE(*time, *expected - 1e-2);
        ++met;
      } else if (time) {  // only just missed
        EXPECT_LE(Distance(kind, At(x0, x1, *time)), 1.001e-6 * Distance(kind, x0));
      }
    }
  }
  EXPECT_GT(met, 300);
}

TEST(FirstApproach, FindsPlainTimes) {
  const Vector3d o = Vector3d::Zero(), x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const FourPoints above = {Vector3d(0.25, 0.25, 1.0), o, x, y};
  const FourPoints below = {Vector3d(0.25, 0.25, -1.0), o, x, y};
  EXPECT_NEAR(*FirstVertexTriangleApproach(above, below, {0.0, 1.0, 1e-6}), 0.5, 1e-6);
  EXPECT_NEAR(*FirstVertexTriangleApproach(above, below, {0.2, 1.0, 1e-6}), 0.4, 1e-6);
  EXPECT_NEAR(*FirstVertexTriangleApproach(above, below, {0.0, 1.0, 0.1}), 0.45, 1e-12);
  EXPECT_FALSE(FirstVertexTriangleApproach(above, below, {0.0, 1.0, 0.1}, 0.4));
  EXPECT_FALSE(FirstVertexTriangleApproach(above, above, {0.0, 1.0, 0.1}));
  EXPECT_EQ(FirstVertexTriangleApproach(above, above, {1.0, 1.0, 0.1}), 0.0);
}

// What moves along a surface at a small height takes no more steps than what moves away.
TEST(FirstApproach, SlidingPastIsNoApproach) {
  const double height = 1e-7;
  const Vector3d o = Vector3d::Zero(), x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const FourPoints x0 = {Vector3d(0.1, 0.1, height), o, x, y};
  const FourPoints x1 = {Vector3d(0.8, 0.1, height), o, x, y};
  EXPECT_FALSE(FirstVertexTriangleApproach(x0, x1, {0.0, 1.0, 0.1}));
}

}  // namespace
}  // namespace clothfit
