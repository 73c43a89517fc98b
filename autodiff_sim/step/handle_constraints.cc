// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The substitution that holds points of the cloth.
#include "autodiff_sim/step/handle_constraints.h"

#include <algorithm>
#include <string>

#include "autodiff_sim/base/error.h"

namespace clothfit {

HandleConstraints::HandleConstraints(const std::vector<HandleTarget>& handles) {
  for (std::size_t h = 0; h < handles.size(); ++h) {
    const SurfacePoint& point = handles[h].on_cloth;
    const auto largest = std::max_element(point.weights.begin(), point.weights.end());
    const std::size_t k = static_cast<std::size_t>(largest - point.weights.begin());
    Held held{point.nodes[k], 1.0 / *largest, {}, handles[h].position, 3 * static_cast<int>(h)};
    for (std::size_t j = 0; j < 3; ++j) {
      if (j != k && point.weights[j] != 0.0)
        held.others.push_back({point.nodes[j], -point.weights[j] / *largest});
    }
    held_.push_back(std::move(held));
  }
  for (const Held& a : held_) {
    for (const Held& b : held_) {
      const bool twice = &a != &b && a.node == b.node;
      const bool circular = std::any_of(b.others.begin(), b.others.end(),
                                        [&](const Share& s) { return s.node == a.node; });
      if (twice || circular) {
        throw InputError("handles",
                         "two of them hold the same triangle of the cloth near particle " +
                             std::to_string(a.node) +
                             "; expected handles further apart, or a finer cloth.resolution");
      }
    }
  }
}

std::vector<std::vector<int>> HandleConstraints::ExtraCliques(const BlockPattern& pattern) const {
  std::vector<std::vector<int>> cliques;
  for (const Held& held : held_) {
    for (const Share& share : held.others) {
      for (int k = pattern.row_begin[held.node]; k < pattern.row_begin[held.node + 1]; ++k) {
        cliques.push_back({share.node, pattern.column[k]});
      }
    }
  }
  return cliques;
}

bool HandleConstraints::SamePoints(const HandleConstraints& other) const {
  return std::equal(held_.begin(), held_.end(), other.held_.begin(), other.held_.end(),
                    [](const Held& a, const Held& b) {
                      return a.node == b.node &&
                             std::equal(a.others.begin(), a.others.end(), b.others.begin(),
                                        b.others.end(), [](const Share& s, const Share& t) {
                                          return s.node == t.node && s.factor == t.factor;
                                        });
                    });
}

void HandleConstraints::SetDependentVelocities(const Eigen::VectorXd& x_hat, double gamma,
                                               Eigen::VectorXd* v) const {
  for (const Held& held : held_) {
    Eigen::Vector3d x = held.inverse_weight * held.position;
    for (const Share& share : held.others) {
      x +=
          share.factor * (x_hat.segment<3>(3 * share.node) + gamma * v->segment<3>(3 * share.node));
    }
    v->segment<3>(3 * held.node) = (x - x_hat.segment<3>(3 * held.node)) / gamma;
  }
}

std::vector<HandleConstraints::HeldBlock> HandleConstraints::HeldColumns(
    const BlockSparseMatrix& a) const {
  constexpr int kRow = BlockSparseMatrix::kRow;
  const BlockPattern& pattern = a.pattern();
  std::vector<HeldBlock> blocks;
  for (const Held& held : held_) {
    for (int k = pattern.row_begin[held.node]; k < pattern.row_begin[held.node + 1]; ++k) {
      const int row = pattern.column[k];
      const double* block = a.block(pattern.Find(row, held.node));
      blocks.push_back({row, held.node, {}});
      for (int p = 0; p < 3; ++p) {
        for (int q = 0; q < 3; ++q) blocks.back().value(p, q) = block[kRow * p + q];
      }
    }
  }
  return blocks;
}

void HandleConstraints::ReduceMatrix(BlockSparseMatrix* a) const {
  constexpr int kNext = BlockSparseMatrix::kRow + 1;  // on the diagonal
  constexpr int kNumbers = 3 * BlockSparseMatrix::kRow;
  const BlockPattern& pattern = a->pattern();
  const auto add_block = [a](int to, double factor, int from) {
    for (int e = 0; e < kNumbers; ++e) a->block(to)[e] += factor * a->block(from)[e];
  };
  for (const Held& held : held_) {
    const int begin = pattern.row_begin[held.node], end = pattern.row_begin[held.node + 1];
    for (const Share& share : held.others) {
      for (int k = begin; k < end; ++k) {  // columns: every row that couples to the held particle
        const int row = pattern.column[k];
        add_block(pattern.Find(row, share.node), share.factor, pattern.Find(row, held.node));
      }
    }
    for (const Share& share : held.others) {
      for (int k = begin; k < end; ++k)
        add_block(pattern.Find(share.node, pattern.column[k]), share.factor, k);
    }
    const double* diagonal = a->block(pattern.Find(held.node, held.node));
    const double scale =
        std::max(1e-12, (diagonal[0] + diagonal[kNext] + diagonal[2 * kNext]) / 3.0);
    for (int k = begin; k < end; ++k) {
      std::fill_n(a->block(k), kNumbers, 0.0);
      std::fill_n(a->block(pattern.Find(pattern.column[k], held.node)), kNumbers, 0.0);
    }
    double* identity = a->block(pattern.Find(held.node, held.node));
    identity[0] = identity[kNext] = identity[2 * kNext] = scale;
  }
}

void HandleConstraints::DependentVelocityDerivative(const StepInputs& inputs, int first_column,
                                                    const Lanes<kLanes>& dx_hat, double gamma,
                                                    Lanes<kLanes>* dv) const {
  dv->setZero(dx_hat.rows(), kLanes);
  const int given =
      std::min<int>(kLanes, static_cast<int>(inputs.directions.cols()) - first_column);
  for (const Held& held : held_) {
    for (int k = 0; k < 3; ++k) {
      Eigen::Matrix<double, 1, kLanes> dx = -dx_hat.row(3 * held.node + k);
      for (const Share& share : held.others) dx += share.factor * dx_hat.row(3 * share.node + k);
      if (given > 0) {
        dx.head(given) += held.inverse_weight *
                          inputs.directions.row(held.input_row + k).segment(first_column, given);
      }
      dv->row(3 * held.node + k) = dx / gamma;
    }
  }
}

}  // namespace clothfit
