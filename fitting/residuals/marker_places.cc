// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/marker_places.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace clothfit {

Eigen::Matrix<double, 3, 2> TangentsAt(const SurfacePoint& point, const ClothMesh& mesh,
                                       const Eigen::VectorXd& x) {
  const auto [a, b, c] = point.nodes;
  Eigen::Matrix2d sides;
  sides << mesh.uv[b] - mesh.uv[a], mesh.uv[c] - mesh.uv[a];
  Eigen::Matrix<double, 3, 2> moved;
  moved << x.segment<3>(3 * b) - x.segment<3>(3 * a), x.segment<3>(3 * c) - x.segment<3>(3 * a);
  return moved * sides.inverse();
}

MarkerPlaces::MarkerPlaces(const Scene& scene, int columns) : scene_(scene), columns_(columns) {}

void MarkerPlaces::Add(int frame, const Eigen::VectorXd& x,
                       const std::vector<PointResidual>& residuals, const Sensitivity* sensitivity,
                       Eigen::Index row) {
  if (!scene_.is_fitted[static_cast<std::size_t>(frame)]) return;
  const auto of_frame = std::lower_bound(
      scene_.markers.begin(), scene_.markers.end(), frame,
      [](const MarkerObservation& marker, int wanted) { return marker.frame < wanted; });
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(columns_ + 1);
  std::size_t next = 0;
  for (auto m = of_frame; m != scene_.markers.end() && m->frame == frame; ++m) {
    const Eigen::Matrix<double, 3, 2> by_place = TangentsAt(m->on_cloth, scene_.mesh, x);
    Sums& sums = of_markers_[m->id];
    if (sums.with_rows.size() == 0) sums.with_rows.setZero(2, columns_ + 1);
    for (int k = 0; k < 3; ++k, ++next) {
      const PointResidual& residual = residuals[next];
      const Eigen::RowVector2d tangents = residual.slope * by_place;
      if (sensitivity != nullptr) SetDirections(residual, *sensitivity, values.head(columns_));
      values[columns_] = residual.value;
      sums.of_tangents += tangents.transpose() * tangents;
      sums.with_rows += tangents.transpose() * values;
      rows_.push_back({row + static_cast<Eigen::Index>(next), m->id, tangents});
    }
  }
}

Eigen::Matrix2d MarkerPlaces::Inverse(const Sums& sums) const {
  const double of_prior = 1.0 / (scene_.layout_sigma * scene_.layout_sigma);
  return (sums.of_tangents + of_prior * Eigen::Matrix2d::Identity()).inverse();
}

void MarkerPlaces::TakeOutOfSums(Eigen::MatrixXd* sums) const {
  for (const auto& [id, of_marker] : of_markers_) {
    const Eigen::Matrix2Xd solved = Inverse(of_marker) * of_marker.with_rows;
    sums->triangularView<Eigen::Lower>() -= of_marker.with_rows.transpose() * solved;
  }
}

void MarkerPlaces::TakeOutOfRows(Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) const {
  // C^-1/2 = 1 + T K T' with K = V diag(((1 + s^2 l)^-1/2 - 1) / l) V', where T'T = V diag(l) V'.
  const double variance = scene_.layout_sigma * scene_.layout_sigma;
  std::map<int, Eigen::Matrix2Xd> moved;
  for (const auto& [id, of_marker] : of_markers_) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(of_marker.of_tangents);
    const Eigen::Array2d l = eigen.eigenvalues().array().max(1e-12 / variance);
    const Eigen::Vector2d k = ((1.0 + variance * l).rsqrt() - 1.0) / l;
    const Eigen::Matrix2d v = eigen.eigenvectors();
    moved[id] = v * k.asDiagonal() * v.transpose() * of_marker.with_rows;
  }
  for (const Row& row : rows_) {
    const Eigen::Matrix2Xd& of_marker = moved.at(row.id);
    (*residuals)[row.row] += row.tangents * of_marker.col(columns_);
    if (jacobian != nullptr) jacobian->row(row.row) += row.tangents * of_marker.leftCols(columns_);
  }
}

std::map<int, Eigen::Vector2d> MarkerPlaces::Shifts() const {
  std::map<int, Eigen::Vector2d> shifts;
  for (const auto& [id, of_marker] : of_markers_)
    shifts[id] = -Inverse(of_marker) * of_marker.with_rows.col(columns_);
  return shifts;
}

}  // namespace clothfit
