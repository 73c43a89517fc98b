// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the trees find is what all pairs give, number for number and in the same order, for every
// number of planes.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/edge_triangle_intersection.h"
#include "autodiff_sim/contact/intersections.h"
#include "autodiff_sim/contact/proximity.h"
#include "tests/autodiff_sim/contact/all_planes.h"
#include "tests/support/all_pairs.h"
#include "tests/support/crumpled_cloth.h"

namespace clothfit {

bool operator==(const Contact& a, const Contact& b) {
  return a.pair == b.pair && a.weights == b.weights && a.distance == b.distance &&
         a.cross_squared == b.cross_squared;
}
bool operator==(const Impact& a, const Impact& b) { return a.pair == b.pair && a.time == b.time; }

namespace {

using Eigen::VectorXd;

// A cloth that moves, and another mesh for an obstacle.
struct Case {
  ClothMesh mesh, obstacle;
  VectorXd x0, x1;  // m
  VectorXd y0, y1;
};

// Flat and on the lattice of its mesh, crumpled, or crumpled so much that it passes through itself;
// the motion is about half a triangle, coordinated or at chance.
std::vector<Case> Cases() {
  std::vector<Case> cases;
  std::mt19937 random(10);
  std::normal_distribution<double> normal;
  for (const double height : {0.0, 0.3, 1.5}) {
    const CrumpledCloth start = Crumple(11, height), end = Crumple(12, height);
    const CrumpledCloth other = Crumple(13, height, 9), other_end = Crumple(14, height, 9);
    Case c{start.mesh, other.mesh, start.x, start.x, other.x, other.x};
    c.x1 += 0.2 * (end.x - start.x);
    c.y1 += 0.2 * (other_end.x - other.x);
    for (double& value : c.x1) value += 0.01 * normal(random);
    cases.push_back(c);
    c.x1 = c.x0;
    for (int i = 2; i < c.x1.size(); i += 3) c.x1[i] += 0.04;  // as a whole
    cases.push_back(c);
  }
  return cases;
}

template <class T>
class DetectionTest : public testing::Test {
 public:
  static constexpr int kPlanes = T::value;
};
TYPED_TEST_SUITE(DetectionTest, AllPlanes);

int NumVertices(const PlacedMesh& mesh) { return static_cast<int>(mesh.x.size()) / 3; }

std::vector<Contact> AllContacts(const PlacedMesh& mesh, double distance) {
  std::vector<Contact> contacts;
  VisitAllPairs(mesh.features, NumVertices(mesh), [&](const FeaturePair& pair) {
    const Contact contact = MeasureContact(pair, PairPoints(pair, mesh, mesh));
    if (contact.distance < distance) contacts.push_back(contact);
  });
  return contacts;
}

std::vector<Contact> AllContacts(const PlacedMesh& a, const PlacedMesh& b, double distance) {
  std::vector<Contact> contacts;
  const auto visit = [&](const FeaturePair& pair) {
    const Contact contact = MeasureContact(pair, PairPoints(pair, a, b));
    if (contact.distance < distance) contacts.push_back(contact);
  };
  VisitAllPairs(a.features, NumVertices(a), b.features, NumVertices(b), visit);
  return contacts;
}

std::vector<Impact> AllImpacts(const PlacedMesh& start, const PlacedMesh& end,
                               const Approach& approach) {
  std::vector<Impact> impacts;
  VisitAllPairs(start.features, NumVertices(start), [&](const FeaturePair& pair) {
    const auto time =
        FirstApproach(pair, PairPoints(pair, start, start), PairPoints(pair, end, end), approach);
    if (time) impacts.push_back({pair, *time});
  });
  return impacts;
}

std::vector<Impact> AllImpacts(const PlacedMesh& a0, const PlacedMesh& a1, const PlacedMesh& b0,
                               const PlacedMesh& b1, const Approach& approach) {
  std::vector<Impact> impacts;
  const auto visit = [&](const FeaturePair& pair) {
    const auto time =
        FirstApproach(pair, PairPoints(pair, a0, b0), PairPoints(pair, a1, b1), approach);
    if (time) impacts.push_back({pair, *time});
  };
  VisitAllPairs(a0.features, NumVertices(a0), b0.features, NumVertices(b0), visit);
  return impacts;
}

double Earliest(const std::vector<Impact>& impacts) {
  double earliest = 1.0;
  for (const Impact& impact : impacts) earliest = std::min(earliest, impact.time);
  return earliest;
}

// Of edges of a and triangles of b; within one mesh those with a vertex in common excepted.
std::vector<EdgeTriangle> AllIntersections(const PlacedMesh& a, const PlacedMesh& b, bool same) {
  std::vector<EdgeTriangle> found;
  for (int e = 0; e < static_cast<int>(a.features.edges.size()); ++e) {
    for (int t = 0; t < static_cast<int>(b.features.triangles.size()); ++t) {
      if (same && a.features.EdgeTouchesTriangle(e, t)) continue;
      const std::array<int, 2>& edge = a.features.edges[e];
      const std::array<int, 3>& triangle = b.features.triangles[t];
      if (EdgeMeetsTriangle({a.x.segment<3>(3 * edge[0]), a.x.segment<3>(3 * edge[1])},
                            {b.x.segment<3>(3 * triangle[0]), b.x.segment<3>(3 * triangle[1]),
                             b.x.segment<3>(3 * triangle[2])})) {
        found.push_back({e, t});
      }
    }
  }
  return found;
}

TYPED_TEST(DetectionTest, ProximityIsThatOfAllPairs) {
  size_t found = 0, between = 0;
  for (const Case& c : Cases()) {
    CollisionSurface<TestFixture::kPlanes> cloth(c.mesh), obstacle(c.obstacle);
    const PlacedMesh a{cloth.features(), c.x0}, b{obstacle.features(), c.y0};
    for (const double distance : {1e-9, 0.01, 0.07}) {
      const std::vector<Contact> contacts = FindProximity(c.x0, distance, &cloth);
      EXPECT_TRUE(contacts == AllContacts(a, distance));
      const std::vector<Contact> others = FindProximity(c.x0, c.y0, distance, &cloth, &obstacle);
      EXPECT_TRUE(others == AllContacts(a, b, distance));
      found += contacts.size();
      between += others.size();
    }
  }
  EXPECT_GT(found, 1000u);
  EXPECT_GT(between, 1000u);
}

TYPED_TEST(DetectionTest, ContinuousIsThatOfAllPairs) {
  size_t found = 0, between = 0;
  for (const Case& c : Cases()) {
    CollisionSurface<TestFixture::kPlanes> cloth(c.mesh), obstacle(c.obstacle);
    const PlacedMesh a0{cloth.features(), c.x0}, a1{cloth.features(), c.x1};
    const PlacedMesh b0{obstacle.features(), c.y0}, b1{obstacle.features(), c.y1};
    const Motion move{c.x0, c.x1}, obstacle_move{c.y0, c.y1};
    for (const Approach& approach : {Approach{}, Approach{1e-3, 1e-3, 0.2}}) {
      const std::vector<Impact> impacts = FindContinuous(move, approach, &cloth);
      EXPECT_TRUE(impacts == AllImpacts(a0, a1, approach));
      EXPECT_EQ(EarliestImpact(move, approach, &cloth), Earliest(impacts));
      const std::vector<Impact> others =
          FindContinuous(move, obstacle_move, approach, &cloth, &obstacle);
      EXPECT_TRUE(others == AllImpacts(a0, a1, b0, b1, approach));
      EXPECT_EQ(EarliestImpact(move, obstacle_move, approach, &cloth, &obstacle), Earliest(others));
      found += impacts.size();
      between += others.size();
    }
  }
  EXPECT_GT(found, 100u);
  EXPECT_GT(between, 100u);
}

TYPED_TEST(DetectionTest, IntersectionsAreThoseOfAllPairs) {
  size_t found = 0, between = 0;
  for (const Case& c : Cases()) {
    CollisionSurface<TestFixture::kPlanes> cloth(c.mesh), obstacle(c.obstacle);
    const PlacedMesh a{cloth.features(), c.x0}, b{obstacle.features(), c.y0};
    const std::vector<EdgeTriangle> self = FindIntersections(c.x0, &cloth);
    EXPECT_TRUE(self == AllIntersections(a, a, true));
    const ObstacleIntersections others = FindIntersections(c.x0, c.y0, &cloth, &obstacle);
    EXPECT_TRUE(others.cloth_edges == AllIntersections(a, b, false));
    EXPECT_TRUE(others.obstacle_edges == AllIntersections(b, a, false));
    found += self.size();
    between += others.cloth_edges.size() + others.obstacle_edges.size();
  }
  EXPECT_GT(found, 20u);
  EXPECT_GT(between, 100u);
}

// The weights give the offset, whose length is the distance.
TEST(Contact, WeightsGiveTheOffset) {
  const Case c = Cases()[2];
  CollisionSurface<> cloth(c.mesh), obstacle(c.obstacle);
  const PlacedMesh a{cloth.features(), c.x0}, b{obstacle.features(), c.y0};
  std::array<int, 3> seen = {0, 0, 0};
  for (const Contact& contact : FindProximity(c.x0, c.y0, 0.1, &cloth, &obstacle)) {
    const FourPoints points = PairPoints(contact.pair, a, b);
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k) offset += contact.weights[k] * points[k];
    EXPECT_NEAR(offset.norm(), contact.distance, 1e-15);
    ++seen[static_cast<int>(contact.pair.kind)];
  }
  for (const int count : seen) EXPECT_GT(count, 10);
}

// What EarliestImpact() is for: a cloth that does not pass through itself does not do so after the
// step that it allows either, nor at any time before.
TEST(EarliestImpact, KeepsAClothFromPassingThroughItself) {
  int stopped = 0;
  for (unsigned seed = 20; seed < 28; ++seed) {
    const CrumpledCloth start = Crumple(seed, 0.1), end = Crumple(seed + 20, 1.5);
    CollisionSurface<> cloth(start.mesh);
    ASSERT_TRUE(FindIntersections(start.x, &cloth).empty());
    const VectorXd move = end.x - start.x;
    const double safe = EarliestImpact(Motion{start.x, end.x}, Approach{}, &cloth);
    EXPECT_GT(safe, 0.0);
    if (safe < 1.0) ++stopped;
    for (int k = 0; k <= 50; ++k) {
      EXPECT_TRUE(FindIntersections(VectorXd(start.x + safe * k / 50.0 * move), &cloth).empty());
    }
  }
  EXPECT_GE(stopped, 4);
}

}  // namespace
}  // namespace clothfit
