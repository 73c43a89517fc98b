// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Points of the surface, and handles at them.
#include "autodiff_sim/mesh/surface_point.h"

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/step/handle_constraints.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

// A mesh's own (u, v) as positions: a point located at (u, v) is At() (u, v).
Eigen::VectorXd Flat(const ClothMesh& mesh) {
  return LayFlat(mesh, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
}

TEST(SurfacePoint, LiesWhereItWasLocated) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {7, 5});
  const Eigen::VectorXd x = Flat(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0.0, 0.6), v(0.0, 0.3);
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector2d uv;
    uv.y() = v(random);
    uv.x() = u(random);
    const SurfacePoint point = LocateOnCloth(mesh, {uv})[0];
    EXPECT_LE((point.At(x).head<2>() - uv).norm(), 1e-14);
    for (const double w : point.weights) {
      EXPECT_GE(w, 0.0);
      EXPECT_LE(w, 1.0);
    }
  }
}

TEST(SurfacePoint, OnAParticleIsThatParticle) {
  const ClothMesh mesh = MakeGrid({0.7, 0.3}, {8, 5});
  const std::vector<SurfacePoint> points = LocateOnCloth(mesh, mesh.uv);
  ASSERT_EQ(points.size(), 40u);
  for (int i = 0; i < 40; ++i) {
    double weight = 0.0;
    for (int k = 0; k < 3; ++k) {
      if (points[i].nodes[k] == i) weight = points[i].weights[k];
      EXPECT_TRUE(points[i].weights[k] == 0.0 || points[i].weights[k] == 1.0);
    }
    EXPECT_EQ(weight, 1.0);
  }
}

TEST(SurfacePoint, OutsideIsExtrapolatedFromTheNearestTriangle) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {7, 4});
  const Eigen::VectorXd x = Flat(mesh);
  const Eigen::Vector2d uv(0.601, 0.17);
  const SurfacePoint point = LocateOnCloth(mesh, {uv})[0];
  EXPECT_LE((point.At(x).head<2>() - uv).norm(), 1e-14);
  EXPECT_LT(std::min({point.weights[0], point.weights[1], point.weights[2]}), 0.0);
  for (const int node : point.nodes) EXPECT_LE((mesh.uv[node] - uv).norm(), 0.15);
}

// The residual of a force on a held point goes to the particles that it depends on.
TEST(HandleConstraints, HoldAPointInsideATriangle) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {7, 4});
  const Eigen::VectorXd x = Flat(mesh);
  const SurfacePoint point = LocateOnCloth(mesh, {{0.23, 0.14}})[0];
  const Eigen::Vector3d place(0.5, 0.6, 0.7);
  const HandleConstraints constraints({{point, place}});
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(x.size(), -1.0, 1.0);
  const Eigen::VectorXd before = v;
  constraints.SetDependentVelocities(x, 0.01, &v);
  EXPECT_LE((point.At(x + 0.01 * v) - place).norm(), 1e-14);
  EXPECT_EQ((v - before).cwiseAbs().cwiseSign().sum(), 3.0);  // one particle moved
}

// Virtual work: a reduced residual along free velocities is the full one along all that they move.
TEST(HandleConstraints, ReductionIsTheTransposeOfExpansion) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {7, 4});
  const std::vector<SurfacePoint> points = LocateOnCloth(mesh, {{0.23, 0.14}, {0.6, 0.3}});
  const HandleConstraints constraints(
      {{points[0], Eigen::Vector3d::Zero()}, {points[1], Eigen::Vector3d::Zero()}});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  Lanes<1> r(84), free(84);
  for (double& value : r) value = one(random);
  for (double& value : free) value = one(random);
  Lanes<1> reduced = r, moved = free;
  constraints.ReduceResidual<1>(&reduced);
  constraints.ExpandDirection<1>(&moved);
  constraints.ClearHeld<1>(&free);
  EXPECT_NEAR(reduced.dot(free), r.dot(moved), 1e-13);
  EXPECT_EQ((reduced.array() == 0.0).count(), 6);
}

std::string Refusal(const ClothMesh& mesh, const std::vector<Eigen::Vector2d>& uv) {
  std::vector<HandleTarget> targets;
  for (const SurfacePoint& point : LocateOnCloth(mesh, uv))
    targets.push_back({point, Eigen::Vector3d::Zero()});
  try {
    const HandleConstraints constraints(targets);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(HandleConstraints, RefuseTwoThatCannotBothBeHeld) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {7, 4});
  EXPECT_EQ(Refusal(mesh, {{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}}), "");  // three particles
  EXPECT_EQ(Refusal(mesh, {{0.02, 0.01}, {0.52, 0.21}}), "");
  for (const std::vector<Eigen::Vector2d>& uv :
       {std::vector<Eigen::Vector2d>{{0.2, 0.1}, {0.2, 0.1}},      // the same
        std::vector<Eigen::Vector2d>{{0.21, 0.12}, {0.22, 0.12}},  // in one triangle
        std::vector<Eigen::Vector2d>{{0.2, 0.1}, {0.21, 0.12}}}) {
    const std::string text = Refusal(mesh, uv);
    EXPECT_THAT(text, ::testing::StartsWith("handles: two of them hold the same triangle"));
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace clothfit
