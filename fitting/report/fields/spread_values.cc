// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/fields/spread_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracking/silhouette/outline.h"

namespace clothfit {
namespace {

constexpr int kMostRounds = 24;

// So that a weight reaches particles about as far as the points are apart.
int NumRounds(int points, Eigen::Index particles, int least) {
  const double cells = static_cast<double>(particles) / std::max(1, points);
  return std::clamp(static_cast<int>(std::ceil(cells)), least, kMostRounds);
}

}  // namespace

SpreadValues::SpreadValues(const ClothMesh& mesh, std::size_t num_frames, int least_rounds)
    : degree_(Eigen::VectorXd::Zero(mesh.num_particles())),
      sums_(num_frames, Eigen::VectorXd::Zero(mesh.num_particles())),
      weights_(sums_),
      counts_(num_frames, 0),
      least_rounds_(least_rounds) {
  for (const MeshEdge& edge : FindEdges(mesh.triangles)) {
    edges_.push_back(edge.nodes);
    for (const int node : edge.nodes) degree_[node] += 1.0;
  }
}

void SpreadValues::Add(std::size_t frame, const SurfacePoint& point, double value) {
  if (!std::isfinite(value)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = std::max(0.0, point.weights[k]);
    sums_[frame][point.nodes[k]] += weight * value;
    weights_[frame][point.nodes[k]] += weight;
  }
  ++counts_[frame];
}

void SpreadValues::Diffuse(Eigen::VectorXd* weights) const {
  Eigen::VectorXd next = *weights;
  for (const auto& [a, b] : edges_) {
    const double flow = 0.5 * ((*weights)[a] - (*weights)[b]) / std::max(degree_[a], degree_[b]);
    next[a] -= flow;
    next[b] += flow;
  }
  *weights = next;
}

std::vector<Eigen::VectorXd> SpreadValues::Values() const {
  constexpr double kLeast = 1e-3;  // of a point's weight; less is too far from any
  std::vector<Eigen::VectorXd> values;
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    Eigen::VectorXd sum = sums_[f], weight = weights_[f];
    const int rounds = counts_[f] > 0 ? NumRounds(counts_[f], sum.size(), least_rounds_) : 0;
    for (int round = 0; round < rounds; ++round) {
      Diffuse(&sum);
      Diffuse(&weight);
    }
    values.emplace_back(
        (weight.array() > kLeast)
            .select(sum.array() / weight.array(), std::numeric_limits<double>::quiet_NaN())
            .matrix());
  }
  return values;
}

}  // namespace clothfit
