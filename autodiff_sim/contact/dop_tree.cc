// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/dop_tree.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace clothfit {

template <int Planes>
DopTree<Planes>::DopTree(const std::vector<std::array<int, 3>>& triangles, const Eigen::VectorXd& x)
    : triangles_(triangles), leaf_of_triangle_(triangles.size()), vertices_(x.size() / 3) {
  assert(!triangles.empty());
  Triangles centres;
  centres.reserve(triangles.size());
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const int vertex : triangles[i]) centre += x.segment<3>(3 * vertex) / 3.0;
    centres.emplace_back(i, centre);
  }
  nodes_.reserve(2 * triangles.size() - 1);
  Build(centres.begin(), centres.end());
  Refit(x, 0.0);
}

template <int Planes>
int DopTree<Planes>::Build(typename Triangles::iterator begin, typename Triangles::iterator end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  nodes_[index].count = static_cast<int>(end - begin);
  if (end - begin == 1) {
    nodes_[index].triangle = begin->first;
    leaf_of_triangle_[begin->first] = index;
    return index;
  }
  Eigen::Vector3d low = begin->second, high = begin->second;
  for (auto it = begin; it != end; ++it) {
    low = low.cwiseMin(it->second);
    high = high.cwiseMax(it->second);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const auto middle = begin + (end - begin) / 2;
  // Centres that are level are told apart by their number: the tree is the same on every machine.
  std::nth_element(begin, middle, end, [axis](const auto& a, const auto& b) {
    return std::tie(a.second[axis], a.first) < std::tie(b.second[axis], b.first);
  });
  Build(begin, middle);
  const int second = Build(middle, end);
  nodes_[index].second_child = second;
  return index;
}

template <int Planes>
void DopTree<Planes>::Refit(const Eigen::VectorXd& x, double margin) {
  assert(x.size() == 3 * static_cast<Eigen::Index>(vertices_.size()));
  for (int i = 0; i < static_cast<int>(vertices_.size()); ++i) {
    vertices_[i] = Volume();
    vertices_[i].Extend(x.segment<3>(3 * i));
    vertices_[i].Inflate(margin);
  }
  RefitNodes();
}

template <int Planes>
void DopTree<Planes>::RefitSwept(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                                 double margin) {
  assert(x0.size() == 3 * static_cast<Eigen::Index>(vertices_.size()) && x1.size() == x0.size());
  for (int i = 0; i < static_cast<int>(vertices_.size()); ++i) {
    vertices_[i] = Volume();
    vertices_[i].Extend(x0.segment<3>(3 * i));
    vertices_[i].Extend(x1.segment<3>(3 * i));
    vertices_[i].Inflate(margin);
  }
  RefitNodes();
}

template <int Planes>
void DopTree<Planes>::RefitNodes() {
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    Node& node = nodes_[i];
    if (node.is_leaf()) {
      const std::array<int, 3>& corners = triangles_[node.triangle];
      node.volume = vertices_[corners[0]];
      node.volume.Merge(vertices_[corners[1]]);
      node.volume.Merge(vertices_[corners[2]]);
    } else {
      node.volume = nodes_[i + 1].volume;
      node.volume.Merge(nodes_[node.second_child].volume);
    }
  }
}

template class DopTree<6>;
template class DopTree<14>;
template class DopTree<18>;
template class DopTree<26>;

}  // namespace clothfit
