// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/node_sums.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "autodiff_sim/base/parallel.h"

namespace clothfit {
namespace {

// The directions that have moved anything, and how they move the particles, 3N x as many.
Eigen::MatrixXd ActiveDirections(const Sensitivity& sensitivity, std::vector<int>* directions) {
  for (int d = 0; d < sensitivity.num_directions(); ++d) {
    if (!sensitivity.lanes()[d / kLanes].is_zero) directions->push_back(d);
  }
  if (directions->empty()) return {};
  Eigen::MatrixXd moved(sensitivity.lanes().front().x.rows(), directions->size());
  for (std::size_t k = 0; k < directions->size(); ++k) {
    const int d = (*directions)[k];
    moved.col(static_cast<Eigen::Index>(k)) = sensitivity.lanes()[d / kLanes].x.col(d % kLanes);
  }
  return moved;
}

}  // namespace

NodeSums::NodeSums(const ClothMesh& mesh) {
  std::vector<std::set<int>> below(mesh.num_particles());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int row : triangle) {
      for (const int column : triangle) {
        if (column <= row) below[row].insert(column);
      }
    }
  }
  for (const std::set<int>& columns : below) {
    first_.push_back(static_cast<int>(column_.size()));
    column_.insert(column_.end(), columns.begin(), columns.end());
  }
  first_.push_back(static_cast<int>(column_.size()));
  blocks_.resize(column_.size());
  by_position_.resize(3 * mesh.num_particles());
}

int NodeSums::Find(int row, int column) const {
  for (int k = first_[row]; k < first_[row + 1]; ++k) {
    if (column_[k] == column) return k;
  }
  throw std::logic_error("a residual's point lies on no triangle");
}

void NodeSums::Set(const std::vector<PointResidual>& residuals) {
  for (Eigen::Matrix3d& block : blocks_) block.setZero();
  by_position_.setZero();
  squared_norm_ = 0.0;
  for (const PointResidual& r : residuals) {
    if (r.IsZero()) continue;
    squared_norm_ += r.value * r.value;
    const Eigen::Matrix3d square = r.slope.transpose() * r.slope;
    for (int a = 0; a < 3; ++a) {
      const double weight = r.point.weights[a];
      if (weight == 0.0) continue;
      const int row = r.point.nodes[a];
      by_position_.segment<3>(3 * row) += weight * r.value * r.slope.transpose();
      for (int b = 0; b < 3; ++b) {
        const int column = r.point.nodes[b];
        if (column > row || r.point.weights[b] == 0.0) continue;
        blocks_[Find(row, column)] += weight * r.point.weights[b] * square;
      }
    }
  }
}

Eigen::MatrixXd NodeSums::Multiply(const Eigen::Ref<const Eigen::MatrixXd>& values) const {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    for (int row = 0; row + 1 < static_cast<int>(first_.size()); ++row) {
      for (int k = first_[row]; k < first_[row + 1]; ++k) {
        const int column = column_[k];  // blocks are symmetric
        product.col(c).segment<3>(3 * row) += blocks_[k] * values.col(c).segment<3>(3 * column);
        if (column < row)
          product.col(c).segment<3>(3 * column) += blocks_[k] * values.col(c).segment<3>(3 * row);
      }
    }
  }
  return product;
}

void NodeSums::AddTo(const Sensitivity& sensitivity, Eigen::MatrixXd* sums) const {
  const Eigen::Index last = sums->rows() - 1;
  (*sums)(last, last) += squared_norm_;
  std::vector<int> directions;
  const Eigen::MatrixXd moved = ActiveDirections(sensitivity, &directions);
  const int count = static_cast<int>(directions.size());
  constexpr int kBlock = 48;  // columns at a time
  ParallelFor((count + kBlock - 1) / kBlock, NumThreads(0), [&](int block, int) {
    const int first = block * kBlock, width = std::min(kBlock, count - first);
    const Eigen::MatrixXd product = Multiply(moved.middleCols(first, width));
    const Eigen::MatrixXd part = moved.rightCols(count - first).transpose() * product;
    const Eigen::RowVectorXd of_residuals =
        by_position_.transpose() * moved.middleCols(first, width);
    for (int c = 0; c < width; ++c) {
      const int column = directions[first + c];
      for (int r = c; r < count - first; ++r) (*sums)(directions[first + r], column) += part(r, c);
      (*sums)(last, column) += of_residuals[c];
    }
  });
}

}  // namespace clothfit
