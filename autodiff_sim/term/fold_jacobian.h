// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The derivatives of a fold's flattening mode u = -grad theta, which are those of the angle once
// more: symmetric, and in each triangle of one matrix
//   H = -|E| / |N|^4 (N (N x E)^T + (N x E) N^T).
// With g = |E| N / |N|^2, t = -(side . E) / |E|^2, and a, d and e for nodes 0, 1 and 3 relative to
// node 2,
//   du_a/da = H1,  du_a/dd = 0,  du_a/de = t1 H1 - E g1^T / |E|^2,
//   du_d/dd = H2,                du_d/de = t2 H2 - E g2^T / |E|^2,
//   du_e/de = sum over both triangles of
//             (t^2 + |N|^2 / (2 |E|^4)) H - t (g E^T + E g^T) / |E|^2,
// H2 with the other sign, since side 2 turns the other way round the edge. The angle does not
// change with the place, so what belongs to node 2 makes all sums zero. Compare Tamstorf and
// Grinspun 2013, who write the same by the triangles' other angles.
#pragma once

#include "autodiff_sim/term/element_jacobian.h"
#include "autodiff_sim/term/fold_angle.h"

namespace clothfit {

class FoldJacobian {
 public:
  using Vectors = std::array<Eigen::Vector3d, 4>;

  // mode: the fold's FlatteningMode.
  FoldJacobian(const Fold<double>& fold, const Vectors& mode)
      : mode_(mode),
        edge_(fold.edge),
        normal_{fold.normal1, fold.normal2},
        across_{fold.normal1.cross(fold.edge), fold.normal2.cross(fold.edge)} {
    const double inverse = 1.0 / fold.edge.squaredNorm();
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d& side = i == 0 ? fold.side1 : fold.side2;
      const double size2 = normal_[i].squaredNorm();
      bend_[i] = (i == 0 ? -fold.length : fold.length) / (size2 * size2);
      share_[i] = -side.dot(fold.edge) * inverse;
      along_edge_[i] = share_[i] * share_[i] + 0.5 * size2 * inverse * inverse;
    }
    inverse_ = inverse;
  }

  // 1/m^2 times the unit of v: the derivatives of sum u_i . v_i by the particles' places.
  Vectors DerivativeOfRate(const Vectors& v) const {
    const Eigen::Vector3d by_edge = v[3] - v[2];
    Vectors out;
    out[3].setZero();
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d by_side = v[i] - v[2], &g = mode_[i];
      const Eigen::Vector3d h_side = Bend(i, by_side), h_edge = Bend(i, by_edge);
      const double t = share_[i], turn = inverse_ * g.dot(by_edge);
      out[i] = h_side + t * h_edge - turn * edge_;
      out[3] += t * h_side + along_edge_[i] * h_edge - t * turn * edge_ -
                (inverse_ * edge_.dot(by_side + t * by_edge)) * g;
    }
    out[2] = -(out[0] + out[1] + out[3]);
    return out;
  }

  // Adds moment * du_i/dx_j - u_i y_j^T for all i and j; y as many vectors as there are particles.
  template <class Sink>
  void Add(double moment, const Vectors& y, const Sink& sink) const {
    const std::array<JacobianRow, 2> normal = {JacobianRow(normal_[0]), JacobianRow(normal_[1])};
    const std::array<JacobianRow, 2> across = {JacobianRow(across_[0]), JacobianRow(across_[1])};
    const std::array<JacobianRow, 2> mode = {JacobianRow(mode_[0]), JacobianRow(mode_[1])};
    const JacobianRow edge = JacobianRow(edge_);
    const std::array<JacobianRow, 4> right = {JacobianRow(y[0]), JacobianRow(y[1]),
                                              JacobianRow(y[2]), JacobianRow(y[3])};
    const double turn = moment * inverse_;
    for (int p = 0; p < 3; ++p) {
      const auto add = [&](int a, int b, const JacobianRow& row) {
        sink(a, b, p, row - mode_[a][p] * right[b]);
      };
      JacobianRow sides_by_edge = JacobianRow(), edge_by_sides = sides_by_edge;
      JacobianRow edge_by_edge = sides_by_edge, both = sides_by_edge;
      for (int i = 0; i < 2; ++i) {
        const double bend = moment * bend_[i], t = share_[i], g = mode_[i][p];
        const JacobianRow h =
            (bend * normal_[i][p]) * across[i] + (bend * across_[i][p]) * normal[i];
        const JacobianRow by_edge = t * h - (turn * edge_[p]) * mode[i];
        const JacobianRow by_side = t * h - (turn * g) * edge;
        add(i, i, h);
        add(i, 1 - i, JacobianRow());
        add(i, 3, by_edge);
        add(i, 2, -(h + by_edge));
        add(3, i, by_side);
        add(2, i, -(h + by_side));
        both += h;
        sides_by_edge += by_edge;
        edge_by_sides += by_side;
        edge_by_edge += along_edge_[i] * h - (turn * t) * (g * edge + edge_[p] * mode[i]);
      }
      add(3, 3, edge_by_edge);
      add(3, 2, -(edge_by_sides + edge_by_edge));
      add(2, 3, -(sides_by_edge + edge_by_edge));
      add(2, 2, both + sides_by_edge + edge_by_sides + edge_by_edge);
    }
  }

 private:
  Eigen::Vector3d Bend(int i, const Eigen::Vector3d& z) const {
    return bend_[i] * (normal_[i] * across_[i].dot(z) + across_[i] * normal_[i].dot(z));
  }

  Vectors mode_;
  Eigen::Vector3d edge_;
  std::array<Eigen::Vector3d, 2> normal_, across_;
  std::array<double, 2> bend_, share_, along_edge_;
  double inverse_;
};

}  // namespace clothfit
