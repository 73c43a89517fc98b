// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where markers sit on the cloth, known to a sigma only (noise.layout of a recording): two unknowns
// a marker, the same in all frames, with a prior of that size. They are eliminated: what is left of
// residuals and derivatives is what the best places leave (variable projection, Golub and Pereyra
// 1973; derivatives as Kaufman 1975, without those of the tangents). It costs no simulation, since
// a marker's place moves along the surface's tangents.
#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "fitting/optimise/row_major_matrix.h"
#include "fitting/residuals/point_residual.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// How a point of the surface moves with its (u, v): 3 x 2, m per m.
Eigen::Matrix<double, 3, 2> TangentsAt(const SurfacePoint& point, const ClothMesh& mesh,
                                       const Eigen::VectorXd& x);

class MarkerPlaces {
 public:
  // columns: entries by which residuals are differentiated. The scene must outlive it.
  MarkerPlaces(const Scene& scene, int columns);

  // What the markers of a frame leave, three residuals a marker, and their derivatives where there
  // are any; the first of them is `row` of all.
  void Add(int frame, const Eigen::VectorXd& x, const std::vector<PointResidual>& residuals,
           const Sensitivity* sensitivity, Eigen::Index row = 0);

  // Takes them out of the sums of all residuals and derivatives, [J r]'[J r] (lower triangle, the
  // residuals last).
  void TakeOutOfSums(Eigen::MatrixXd* sums) const;
  // The same of the rows themselves, which keep their number: C^-1/2 [J r], where C = 1 + s^2 T T'
  // is the covariance of noise and of places that are s off along tangents T. Null: none.
  void TakeOutOfRows(Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) const;
  // By how much (m, along u and v) each marker is best moved, by id.
  std::map<int, Eigen::Vector2d> Shifts() const;

 private:
  struct Sums {
    Eigen::Matrix2d of_tangents = Eigen::Matrix2d::Zero();  // T'T
    Eigen::Matrix2Xd with_rows;                             // T'[J r]
  };
  struct Row {
    Eigen::Index row;
    int id;
    Eigen::RowVector2d tangents;
  };
  Eigen::Matrix2d Inverse(const Sums& sums) const;  // (T'T + 1 / s^2)^-1

  const Scene& scene_;
  int columns_;
  std::map<int, Sums> of_markers_;
  std::vector<Row> rows_;
};

}  // namespace clothfit
