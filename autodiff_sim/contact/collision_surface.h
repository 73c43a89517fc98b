// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh made ready for collision queries.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/dop_tree.h"
#include "autodiff_sim/contact/mesh_features.h"
#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

template <int Planes = 14>
class CollisionSurface {
 public:
  // A cloth, its tree built over its flat shape.
  explicit CollisionSurface(const ClothMesh& mesh);
  // Any mesh, its tree built over its shape at x (3N, m).
  CollisionSurface(const std::vector<std::array<int, 3>>& triangles, const Eigen::VectorXd& x);

  // Every query refits the volumes of the surface that it is given, see DopTree.
  void Refit(const Eigen::VectorXd& x, double margin);
  void RefitSwept(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double margin);

  const MeshFeatures& features() const { return features_; }
  const DopTree<Planes>& tree() const { return tree_; }
  // The volumes of one feature, inflated.
  const Dop<Planes>& vertex(int i) const { return tree_.vertex(i); }
  const Dop<Planes>& edge(int i) const { return edges_[i]; }
  const Dop<Planes>& triangle(int i) const { return tree_.triangle(i); }

 private:
  void RefitEdges();

  MeshFeatures features_;
  DopTree<Planes> tree_;
  std::vector<Dop<Planes>> edges_;
};

}  // namespace clothfit
