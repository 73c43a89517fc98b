// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers that are known at some points of the cloth, spread over its particles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/surface_point.h"

namespace clothfit {

class SpreadValues {
 public:
  // `least_rounds`: of spreading, each about half an edge further.
  SpreadValues(const ClothMesh& mesh, std::size_t num_frames, int least_rounds = 1);

  // Calls for different frames may run at the same time.
  void Add(std::size_t frame, const SurfacePoint& point, double value);

  // One number a particle: the mean of the values around it, by weights that diffuse along the
  // mesh about as far as the points of the frame are apart; NaN beyond.
  std::vector<Eigen::VectorXd> Values() const;

 private:
  void Diffuse(Eigen::VectorXd* weights) const;

  std::vector<std::array<int, 2>> edges_;
  Eigen::VectorXd degree_;  // edges at each particle
  std::vector<Eigen::VectorXd> sums_, weights_;
  std::vector<int> counts_;
  int least_rounds_;
};

}  // namespace clothfit
