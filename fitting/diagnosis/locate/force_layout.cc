// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/force_layout.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/mesh/cloth_box.h"
#include "autodiff_sim/terms/residual_force.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// Cholesky factor of the correlations between points at these distances.
template <class Distance>
Eigen::MatrixXd MaternFactor(int count, double range, const Distance& distance) {
  Eigen::MatrixXd correlation(count, count);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const double a = std::sqrt(3.0) * distance(i, j) / range;
      correlation(i, j) = (1.0 + a) * std::exp(-a);
    }
  }
  return Cholesky(correlation, "the correlations of a force").matrixL();
}

}  // namespace

Eigen::Vector2d ForceLayout::NodePlace(int node) const {
  const Eigen::Vector2d share(static_cast<double>(node % nodes[0]) / (nodes[0] - 1),
                              static_cast<double>(node / nodes[0]) / (nodes[1] - 1));
  return low + share.cwiseProduct(high - low);
}

void ForceLayout::KnotBefore(double time, int* knot, double* weight) const {
  const double place = std::clamp(time / spacing(), 0.0, static_cast<double>(num_knots - 1));
  *knot = std::min(static_cast<int>(place), num_knots - 2);
  *weight = place - *knot;
}

ForceGrid ForceLayout::At(const Eigen::VectorXd& force, double time) const {
  int knot = 0;
  double weight = 0.0;
  KnotBefore(time, &knot, &weight);
  ForceGrid grid{low, high, nodes, {}};
  for (int node = 0; node < num_nodes(); ++node) {
    grid.force.push_back((1.0 - weight) * force.segment<3>(Index(knot, node, 0)) +
                         weight * force.segment<3>(Index(knot + 1, node, 0)));
  }
  return grid;
}

Eigen::Vector3d ForceLayout::At(const Eigen::VectorXd& force, double time,
                                const Eigen::Vector2d& uv) const {
  const ForceGrid grid = At(force, time);
  std::array<int, 2> first;
  std::array<double, 2> weight;
  for (int axis = 0; axis < 2; ++axis) {
    const double share = std::clamp((uv[axis] - low[axis]) / (high[axis] - low[axis]), 0.0, 1.0);
    const double place = share * (nodes[axis] - 1);
    first[axis] = std::min(static_cast<int>(place), nodes[axis] - 2);
    weight[axis] = place - first[axis];
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int corner = 0; corner < 4; ++corner) {
    const int i = corner % 2, j = corner / 2;
    const double w =
        (i == 1 ? weight[0] : 1.0 - weight[0]) * (j == 1 ? weight[1] : 1.0 - weight[1]);
    sum += w * grid.force[first[0] + i + (first[1] + j) * nodes[0]];
  }
  return sum;
}

Eigen::MatrixXd ForceLayout::CorrelationFactor(double length, double time) const {
  const Eigen::MatrixXd over_cloth = MaternFactor(
      num_nodes(), length, [&](int i, int j) { return (NodePlace(i) - NodePlace(j)).norm(); });
  const Eigen::MatrixXd over_time = MaternFactor(
      num_knots, time, [&](int i, int j) { return std::abs(KnotTime(i) - KnotTime(j)); });
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(size(), size());
  for (int k = 0; k < num_knots; ++k) {
    for (int l = 0; l <= k; ++l) {
      for (int i = 0; i < num_nodes(); ++i) {
        for (int j = 0; j <= i; ++j) {
          const double value = over_time(k, l) * over_cloth(i, j);
          for (int c = 0; c < 3; ++c) factor(Index(k, i, c), Index(l, j, c)) = value;
        }
      }
    }
  }
  return factor;
}

ForceLayout MakeForceLayout(const ClothMesh& mesh, const std::array<int, 2>& nodes,
                            double frame_rate, int last_frame, double spacing) {
  ForceLayout layout;
  const ClothBox cloth = BoxOf(mesh);
  layout.low = cloth.low;
  layout.high = cloth.high;
  layout.nodes = nodes;
  layout.frame_rate = frame_rate;
  layout.frames_per_knot = std::max(1, static_cast<int>(std::lround(spacing * frame_rate)));
  layout.num_knots =
      std::max(2, 1 + (last_frame + layout.frames_per_knot - 1) / layout.frames_per_knot);
  return layout;
}

Eigen::Matrix3d TriangleFrame(const ClothMesh& mesh, const std::array<int, 3>& t,
                              const Eigen::VectorXd& x) {
  const Eigen::Vector2d du = mesh.uv[t[1]] - mesh.uv[t[0]], dv = mesh.uv[t[2]] - mesh.uv[t[0]];
  const Eigen::Vector3d side1 = x.segment<3>(3 * t[1]) - x.segment<3>(3 * t[0]);
  const Eigen::Vector3d side2 = x.segment<3>(3 * t[2]) - x.segment<3>(3 * t[0]);
  Eigen::Matrix3d frame;
  frame.col(0) = side1.cross(side2).normalized();
  frame.col(1) = (dv.y() * side1 - du.y() * side2).normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

std::vector<NodeShare> NodeShares(const ClothMesh& mesh, const ForceLayout& layout) {
  StepInputs inputs;
  inputs.residual_force = layout.At(Eigen::VectorXd::Zero(layout.size()), 0.0);
  const ClothTopology topology;
  const World world;
  std::vector<NodeShare> shares;
  for (const ResidualForce::Element& e :
       ResidualForce::Elements({mesh, topology, world, &inputs})) {
    shares.push_back({e.nodes, e.first_input / 3, 3.0 * e.area});
  }
  return shares;
}

Eigen::Matrix3Xd TriangleForces(const ClothMesh& mesh, const ForceLayout& layout,
                                const Eigen::VectorXd& force, double time,
                                const Eigen::VectorXd& x) {
  Eigen::Matrix3Xd forces(3, static_cast<Eigen::Index>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<int, 3>& nodes = mesh.triangles[t];
    const Eigen::Vector2d middle =
        (mesh.uv[nodes[0]] + mesh.uv[nodes[1]] + mesh.uv[nodes[2]]) / 3.0;
    forces.col(static_cast<Eigen::Index>(t)) =
        SignedArea(mesh, nodes) * (TriangleFrame(mesh, nodes, x) * layout.At(force, time, middle));
  }
  return forces;
}

}  // namespace clothfit
