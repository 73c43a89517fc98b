// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/dop.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/contact/closest_points.h"
#include "autodiff_sim/contact/dop_tree.h"
#include "tests/autodiff_sim/contact/all_planes.h"
#include "tests/autodiff_sim/contact/random_points.h"
#include "tests/support/crumpled_cloth.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

template <class T>
class DopTest : public testing::Test {
 public:
  static constexpr int kPlanes = T::value;
};
TYPED_TEST_SUITE(DopTest, AllPlanes);

// What Project() takes sums along, read off its linearity.
template <int Planes>
std::vector<Vector3d> Directions() {
  std::vector<Vector3d> directions(Planes / 2);
  for (int axis = 0; axis < 3; ++axis) {
    const auto values = Dop<Planes>::Project(Vector3d::Unit(axis));
    for (int i = 0; i < Planes / 2; ++i) directions[i][axis] = values[i];
  }
  return directions;
}

TYPED_TEST(DopTest, DirectionsAreThoseOfACube) {
  constexpr int planes = TestFixture::kPlanes;
  std::multiset<double> squared_lengths;
  const std::vector<Vector3d> directions = Directions<planes>();
  for (size_t i = 0; i < directions.size(); ++i) {
    squared_lengths.insert(directions[i].squaredNorm());
    EXPECT_DOUBLE_EQ(directions[i].norm(), Dop<planes>::Lengths()[i]);
    for (size_t j = 0; j < i; ++j) EXPECT_GT(directions[i].cross(directions[j]).norm(), 0.5);
  }
  EXPECT_EQ(squared_lengths.count(1.0), 3u);
  EXPECT_EQ(squared_lengths.count(2.0), planes == 18 || planes == 26 ? 6u : 0u);
  EXPECT_EQ(squared_lengths.count(3.0), planes == 14 || planes == 26 ? 4u : 0u);
}

TYPED_TEST(DopTest, AnEmptyOneOverlapsNothing) {
  Dop<TestFixture::kPlanes> empty, point;
  point.Extend({1.0, 2.0, 3.0});
  EXPECT_FALSE(empty.Overlaps(point));
  EXPECT_FALSE(empty.Overlaps(empty));
  EXPECT_TRUE(point.Overlaps(point));
  Dop<TestFixture::kPlanes> merged;
  merged.Merge(point);
  EXPECT_EQ(merged.low(), point.low());
  EXPECT_EQ(merged.high(), point.high());
}

TEST(Dop, MorePlanesFitCloser) {
  Dop<6> box;
  Dop<14> corners;
  Dop<26> both;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d p = sign * Vector3d::Unit(axis);
      box.Extend(p);
      corners.Extend(p);
      both.Extend(p);
    }
  }
  Dop<6> box_outside;
  Dop<14> corners_outside;
  Dop<26> both_outside;
  const Vector3d outside(0.9, 0.9, 0.9);
  box_outside.Extend(outside);
  corners_outside.Extend(outside);
  both_outside.Extend(outside);
  EXPECT_TRUE(box.Overlaps(box_outside));
  EXPECT_FALSE(corners.Overlaps(corners_outside));
  EXPECT_FALSE(both.Overlaps(both_outside));
}

// Sets within a distance overlap once each is inflated by half of it, whatever their position, and
// for a margin of 0 those that touch.
TYPED_TEST(DopTest, InflatedVolumesOfCloseSetsOverlap) {
  std::mt19937 random(4);
  for (const Position position : kPositions) {
    for (int i = 0; i < 2000; ++i) {
      FourPoints x = RandomPoints(position, &random);
      if (i % 2 == 1) x[0] = (x[1] + x[2] + x[3]) / 3.0;  // touches, up to rounding
      const double distance = ClosestVertexTriangle(x).distance;
      Dop<TestFixture::kPlanes> vertex, triangle;
      vertex.Extend(x[0]);
      for (int k = 1; k < 4; ++k) triangle.Extend(x[k]);
      vertex.Inflate(0.5 * distance);
      triangle.Inflate(0.5 * distance);
      EXPECT_TRUE(vertex.Overlaps(triangle)) << static_cast<int>(position) << ", " << i;
    }
  }
}

TYPED_TEST(DopTest, TreesVisitTheOverlappingTrianglesOnce) {
  const CrumpledCloth cloth = Crumple(5, 0.6), other = Crumple(6, 0.6, 10);
  DopTree<TestFixture::kPlanes> tree(cloth.mesh.triangles, cloth.x);
  DopTree<TestFixture::kPlanes> other_tree(other.mesh.triangles, other.x);
  tree.Refit(cloth.x, 0.005);
  other_tree.RefitSwept(other.x, other.x + Eigen::VectorXd::Constant(other.x.size(), 0.02), 0.0);
  std::vector<std::pair<int, int>> self, pairs, expected_self, expected_pairs;
  tree.VisitSelf([&](int a, int b) { self.emplace_back(std::min(a, b), std::max(a, b)); });
  tree.VisitPairs(other_tree, [&](int a, int b) { pairs.emplace_back(a, b); });
  for (int a = 0; a < static_cast<int>(cloth.mesh.triangles.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(cloth.mesh.triangles.size()); ++b) {
      if (tree.triangle(a).Overlaps(tree.triangle(b))) expected_self.emplace_back(a, b);
    }
    for (int b = 0; b < static_cast<int>(other.mesh.triangles.size()); ++b) {
      if (tree.triangle(a).Overlaps(other_tree.triangle(b))) expected_pairs.emplace_back(a, b);
    }
  }
  std::sort(self.begin(), self.end());
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(self, expected_self);
  EXPECT_EQ(pairs, expected_pairs);
  EXPECT_GT(self.size(), 1000u);
  EXPECT_GT(pairs.size(), 100u);
}

TYPED_TEST(DopTest, ATreeOfOneTriangleStands) {
  Eigen::VectorXd x(9);
  x << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  const DopTree<TestFixture::kPlanes> tree({{0, 1, 2}}, x);
  int visits = 0;
  tree.VisitSelf([&](int, int) { ++visits; });
  EXPECT_EQ(visits, 0);
  tree.VisitPairs(tree, [&](int, int) { ++visits; });
  EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace clothfit
