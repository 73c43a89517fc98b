// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A binary tree of discrete oriented polytopes over the triangles of a mesh. Its shape is built
// once; each step only its volumes are refitted, bottom-up.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/dop.h"

namespace clothfit {

template <int Planes>
class DopTree {
 public:
  using Volume = Dop<Planes>;

  // Top-down: the triangles are halved at the median along the longest side of their centres' box.
  // At least one triangle; positions x (3N, m) decide only which triangles are kept together. For a
  // cloth its flat shape is the best: parts that are joined stay together.
  DopTree(const std::vector<std::array<int, 3>>& triangles, const Eigen::VectorXd& x);

  // Bounds the mesh at x (3N, m), each vertex inflated by margin (m).
  void Refit(const Eigen::VectorXd& x, double margin);
  // Bounds it on straight lines from x0 to x1 (3N, m), inflated.
  void RefitSwept(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double margin);

  // The volumes of one vertex and of one triangle, inflated.
  const Volume& vertex(int i) const { return vertices_[i]; }
  const Volume& triangle(int i) const { return nodes_[leaf_of_triangle_[i]].volume; }

  // Calls visit(a, b) once for each two different triangles whose volumes overlap, neighbours
  // among them, in no particular order.
  template <class Visit>
  void VisitSelf(const Visit& visit) const;
  // The triangle with the least squared_distance(triangle), m^2 from the point; the first that is
  // found where several have it.
  template <class SquaredDistance>
  int Nearest(const Eigen::Vector3d& point, const SquaredDistance& squared_distance) const;
  // Calls visit(a, b) for triangles a of this tree and b of the other whose volumes overlap.
  template <class Visit>
  void VisitPairs(const DopTree& other, const Visit& visit) const;

 private:
  // In depth-first order: the first child stands behind its parent, and all children after it.
  struct Node {
    Volume volume;
    int second_child = 0;
    int count = 1;      // triangles below
    int triangle = -1;  // of a leaf

    bool is_leaf() const { return triangle >= 0; }
  };

  using Triangles = std::vector<std::pair<int, Eigen::Vector3d>>;  // with their centres, m
  int Build(typename Triangles::iterator begin, typename Triangles::iterator end);
  void RefitNodes();
  template <class Visit>
  void VisitBetween(int node, const DopTree& other, int other_node, const Visit& visit) const;

  std::vector<std::array<int, 3>> triangles_;
  std::vector<Node> nodes_;
  std::vector<int> leaf_of_triangle_;
  std::vector<Volume> vertices_;
};

extern template class DopTree<6>;
extern template class DopTree<14>;
extern template class DopTree<18>;
extern template class DopTree<26>;

template <int Planes>
template <class Visit>
void DopTree<Planes>::VisitSelf(const Visit& visit) const {
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
    if (!nodes_[i].is_leaf()) VisitBetween(i + 1, *this, nodes_[i].second_child, visit);
  }
}

template <int Planes>
template <class Visit>
void DopTree<Planes>::VisitPairs(const DopTree& other, const Visit& visit) const {
  VisitBetween(0, other, 0, visit);
}

template <int Planes>
template <class SquaredDistance>
int DopTree<Planes>::Nearest(const Eigen::Vector3d& point,
                             const SquaredDistance& squared_distance) const {
  struct Visit {
    double at_least;  // m^2
    int node;
  };
  std::vector<Visit> open = {{0.0, 0}};
  double least = std::numeric_limits<double>::infinity();
  int nearest = -1;
  while (!open.empty()) {
    const auto [at_least, index] = open.back();
    open.pop_back();
    if (at_least >= least) continue;
    const Node& node = nodes_[index];
    if (node.is_leaf()) {
      const double squared = squared_distance(node.triangle);
      if (squared < least) nearest = node.triangle;
      least = std::min(least, squared);
      continue;
    }
    Visit far{nodes_[index + 1].volume.SquaredDistanceToBox(point), index + 1};
    Visit near{nodes_[node.second_child].volume.SquaredDistanceToBox(point), node.second_child};
    if (far.at_least < near.at_least) std::swap(far, near);
    open.push_back(far);
    open.push_back(near);
  }
  return nearest;
}

template <int Planes>
template <class Visit>
void DopTree<Planes>::VisitBetween(int node, const DopTree& other, int other_node,
                                   const Visit& visit) const {
  const Node &a = nodes_[node], &b = other.nodes_[other_node];
  if (!a.volume.Overlaps(b.volume)) return;
  if (a.is_leaf() && b.is_leaf()) {
    visit(a.triangle, b.triangle);
  } else if (a.count >= b.count) {  // the larger is opened
    VisitBetween(node + 1, other, other_node, visit);
    VisitBetween(a.second_child, other, other_node, visit);
  } else {
    VisitBetween(node, other, other_node + 1, visit);
    VisitBetween(node, other, b.second_child, visit);
  }
}

}  // namespace clothfit
