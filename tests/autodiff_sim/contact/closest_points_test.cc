// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Closest points have a certificate: the plane across their offset that separates the two sets. A
// distance that the plane attains is the smallest.
#include "autodiff_sim/contact/closest_points.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/autodiff_sim/contact/random_points.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

double Size(const FourPoints& x) {
  double size = 0.0;
  for (const Vector3d& p : x) size = std::max(size, (p - x[0]).norm());
  return size;
}

// The distance (m) of two parallel planes across n that keep the first `first` points from the
// rest: never above the distance of the sets. 0 where there is no direction.
double SeparatedBy(const FourPoints& x, int first, const Vector3d& n) {
  if (!(n.norm() > 0.0)) return 0.0;
  double separation = std::numeric_limits<double>::infinity();
  for (int i = 0; i < first; ++i) {
    for (int j = first; j < 4; ++j) {
      separation = std::min(separation, (x[i] - x[j]).dot(n.normalized()));
    }
  }
  return separation;
}

// Two ways to fail: a pair of points that is not the closest, and one that is not of the sets. The
// direction of a very short offset is rounding, so such a distance has to be small itself.
void ExpectClosest(const FourPoints& x, int first, const Vector3d& offset, double distance) {
  const double size = Size(x);
  EXPECT_DOUBLE_EQ(offset.norm(), distance);
  // Inaccurate by eps over the smallest trusted angle, 1e-4.
  if (distance > 1e-7 * size) {
    EXPECT_LE(distance - SeparatedBy(x, first, offset), 1e-9 * size);
  }
}

TEST(ClosestPoints, OfVertexAndTriangleAreCertified) {
  std::mt19937 random(1);
  for (const Position position : kPositions) {
    for (int i = 0; i < 2000; ++i) {
      const FourPoints x = RandomPoints(position, &random);
      const VertexTriangleClosest closest = ClosestVertexTriangle(x);
      SCOPED_TRACE(testing::Message() << "position " << static_cast<int>(position) << ", " << i);
      Vector3d point = Vector3d::Zero();
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(closest.weights[k], 0.0);
        point += closest.weights[k] * (x[k + 1] - x[0]);
      }
      EXPECT_NEAR(std::accumulate(closest.weights.begin(), closest.weights.end(), 0.0), 1.0, 1e-15);
      EXPECT_LE((closest.offset + point).norm(), 1e-14 * Size(x));
      ExpectClosest(x, 1, closest.offset, closest.distance);
    }
  }
}

TEST(ClosestPoints, OfEdgesAreCertified) {
  std::mt19937 random(2);
  for (const Position position : kPositions) {
    for (int i = 0; i < 2000; ++i) {
      const FourPoints x = RandomPoints(position, &random);
      const EdgeEdgeClosest closest = ClosestEdgeEdge(x);
      SCOPED_TRACE(testing::Message() << "position " << static_cast<int>(position) << ", " << i);
      const auto [s, t] = closest.along;
      EXPECT_GE(std::min(s, t), 0.0);
      EXPECT_LE(std::max(s, t), 1.0);
      const Vector3d between = (x[0] - x[2]) + s * (x[1] - x[0]) - t * (x[3] - x[2]);
      EXPECT_LE((closest.offset - between).norm(), 1e-14 * Size(x));
      ExpectClosest(x, 2, closest.offset, closest.distance);
    }
  }
}

// The certificate says nothing of sets that touch; points of both at chance do.
TEST(ClosestPoints, AreNoFartherThanAnySample) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit;
  for (const Position position : kPositions) {
    for (int i = 0; i < 200; ++i) {
      const FourPoints x = RandomPoints(position, &random);
      const double rounding = 1e-9 * Size(x);
      for (int k = 0; k < 50; ++k) {
        const double s = unit(random), t = unit(random), u = std::min(s, t), v = std::max(s, t) - u;
        const Vector3d in_triangle = x[1] + u * (x[2] - x[1]) + v * (x[3] - x[1]);
        EXPECT_LE(ClosestVertexTriangle(x).distance, (x[0] - in_triangle).norm() + rounding);
        const Vector3d on_first = x[0] + s * (x[1] - x[0]), on_second = x[2] + t * (x[3] - x[2]);
        EXPECT_LE(ClosestEdgeEdge(x).distance, (on_first - on_second).norm() + rounding);
      }
    }
  }
}

TEST(ClosestPoints, OfPlainCases) {
  const Vector3d o = Vector3d::Zero(), x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const Vector3d above(0.25, 0.5, 2.0);
  const VertexTriangleClosest inside = ClosestVertexTriangle({above, o, x, y});
  EXPECT_EQ(inside.weights, (std::array<double, 3>{0.25, 0.25, 0.5}));
  EXPECT_EQ(inside.offset, Vector3d(0.0, 0.0, 2.0));
  EXPECT_EQ(ClosestVertexTriangle({above, o, o, o}).distance, above.norm());
  EXPECT_EQ(ClosestVertexTriangle({x, o, x, y}).distance, 0.0);

  const EdgeEdgeClosest crossing =
      ClosestEdgeEdge({o, x, Vector3d(0.5, -1.0, 3.0), Vector3d(0.5, 1.0, 3.0)});
  EXPECT_EQ(crossing.along, (std::array<double, 2>{0.5, 0.5}));
  EXPECT_EQ(crossing.offset, Vector3d(0.0, 0.0, -3.0));
  EXPECT_EQ(crossing.cross_squared, 4.0);
  const EdgeEdgeClosest parallel = ClosestEdgeEdge({o, x, y, x + y});
  EXPECT_EQ(parallel.distance, 1.0);
  EXPECT_EQ(parallel.cross_squared, 0.0);
  EXPECT_EQ(ClosestEdgeEdge({o, o, y, y}).distance, 1.0);
}

}  // namespace
}  // namespace clothfit
