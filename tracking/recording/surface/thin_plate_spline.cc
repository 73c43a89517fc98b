// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/thin_plate_spline.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

namespace clothfit {
namespace {

// U(r) of the squared distance; continuous at 0.
double Kernel(double squared_distance) {
  return squared_distance > 0.0 ? squared_distance * std::log(squared_distance) : 0.0;
}

Eigen::Vector3d AffineTerms(const Eigen::Vector2d& point) { return {1.0, point.x(), point.y()}; }

}  // namespace

Eigen::Vector2d ThinPlateSpline::Normalise(const Eigen::Vector2d& point) const {
  return (point - centre_) * scale_;
}

ThinPlateSpline::ThinPlateSpline(const Eigen::Matrix2Xd& sites, const Eigen::Matrix3Xd& values,
                                 double smoothing) {
  const Eigen::Index count = sites.cols();
  if (count < 3 || values.cols() != count) {
    throw std::invalid_argument("a thin-plate spline needs three sites and a value for each");
  }
  centre_ = sites.rowwise().mean();
  scale_ = 1.0 / (sites.colwise() - centre_).colwise().norm().maxCoeff();
  sites_.resize(2, count);
  for (Eigen::Index i = 0; i < count; ++i) sites_.col(i) = Normalise(sites.col(i));

  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 3, count + 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      system(i, j) = Kernel((sites_.col(i) - sites_.col(j)).squaredNorm());
    }
    system(i, i) = smoothing;
    system.block<1, 3>(i, count) = AffineTerms(sites_.col(i)).transpose();
    system.block<3, 1>(count, i) = AffineTerms(sites_.col(i));
  }
  Eigen::MatrixX3d right_side = Eigen::MatrixX3d::Zero(count + 3, 3);
  right_side.topRows(count) = values.transpose();

  const Eigen::PartialPivLU<Eigen::MatrixXd> factor(system);
  weights_ = factor.solve(right_side);
  weights_ += factor.solve(right_side - system * weights_);  // one refinement
  const double residual = (system * weights_ - right_side).cwiseAbs().maxCoeff();
  if (!(residual <= 1e-8 * (1.0 + right_side.cwiseAbs().maxCoeff()))) {
    throw std::invalid_argument("the sites of the thin-plate spline coincide or lie on one line");
  }
}

Eigen::Vector3d ThinPlateSpline::operator()(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d normalised = Normalise(point);
  const Eigen::Index count = sites_.cols();
  Eigen::RowVector3d value = AffineTerms(normalised).transpose() * weights_.bottomRows<3>();
  for (Eigen::Index i = 0; i < count; ++i) {
    value += Kernel((sites_.col(i) - normalised).squaredNorm()) * weights_.row(i);
  }
  return value.transpose();
}

}  // namespace clothfit
