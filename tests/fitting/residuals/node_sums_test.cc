// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/node_sums.h"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

constexpr int kDirections = 61;  // more than one block of columns, the last lanes not full

// Of all kinds: within triangles, on edges, at particles, and some that say nothing.
std::vector<PointResidual> MakeResiduals(const ClothMesh& mesh, std::mt19937* random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<PointResidual> residuals;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<int, 3>& nodes = mesh.triangles[t];
    PointResidual inside{number(*random), {nodes, {0.2, 0.5, 0.3}}, {}};
    PointResidual edge{number(*random), {{nodes[2], nodes[0], nodes[0]}, {0.6, 0.4, 0.0}}, {}};
    PointResidual particle{number(*random), {{nodes[1], nodes[1], nodes[1]}, {1.0, 0.0, 0.0}}, {}};
    for (PointResidual* r : {&inside, &edge, &particle}) {
      for (int k = 0; k < 3; ++k) r->slope[k] = number(*random);
      residuals.push_back(*r);
    }
    residuals.emplace_back();
  }
  return residuals;
}

// Lanes 1 have moved nothing.
Sensitivity MakeSensitivity(const ClothMesh& mesh, std::mt19937* random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  State state;
  state.x = Eigen::VectorXd::Zero(3 * mesh.num_particles());
  Sensitivity sensitivity(state, Eigen::MatrixXd::Zero(1, kDirections));
  for (int d = 0; d < kDirections; ++d) {
    if (d / kLanes == 1) continue;
    StateLanes& lanes = sensitivity.lanes()[d / kLanes];
    lanes.is_zero = false;
    for (Eigen::Index i = 0; i < lanes.x.rows(); ++i) lanes.x(i, d % kLanes) = number(*random);
  }
  return sensitivity;
}

TEST(NodeSums, AreThoseOfAllRows) {
  std::mt19937 random(4);
  const ClothMesh mesh = MakeGrid({0.4, 0.3}, {5, 4});
  const std::vector<PointResidual> residuals = MakeResiduals(mesh, &random);
  const Sensitivity sensitivity = MakeSensitivity(mesh, &random);

  Eigen::MatrixXd rows(residuals.size(), kDirections + 1);  // [J r], row by row
  const Eigen::MatrixXd moved = sensitivity.x();
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const PointResidual& r = residuals[i];
    rows.row(i).setZero();
    for (int k = 0; k < 3; ++k) {
      rows.row(i).head(kDirections) +=
          r.point.weights[k] * r.slope * moved.middleRows<3>(3 * r.point.nodes[k]);
    }
    rows(i, kDirections) = r.value;
  }
  const Eigen::MatrixXd expected =
      (rows.transpose() * rows).triangularView<Eigen::Lower>().toDenseMatrix();

  NodeSums sums(mesh);
  Eigen::MatrixXd once = Eigen::MatrixXd::Zero(kDirections + 1, kDirections + 1);
  sums.Set(residuals);
  sums.AddTo(sensitivity, &once);
  EXPECT_LT((once - expected).norm(), 1e-12 * expected.norm());
  sums.Set(residuals);  // of these alone, whatever was there
  sums.AddTo(sensitivity, &once);
  EXPECT_LT((once - 2.0 * expected).norm(), 1e-12 * expected.norm());
}

TEST(NodeSums, RefuseAPointOnNoTriangle) {
  const ClothMesh mesh = MakeGrid({0.4, 0.3}, {5, 4});
  NodeSums sums(mesh);
  const PointResidual across{1.0, {{0, 19, 19}, {0.5, 0.5, 0.0}}, {1.0, 0.0, 0.0}};
  EXPECT_THROW(sums.Set({across}), std::logic_error);
}

}  // namespace
}  // namespace clothfit
