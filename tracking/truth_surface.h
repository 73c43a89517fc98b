// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The true surface of a recording as a mesh in every frame. For evaluation only, as
// tracking/truth.h says.
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/cloth_mesh.h"
#include "autodiff_sim/surface_point.h"

namespace clothfit {

class TruthSurface {
 public:
  // From truth/points.csv, whose points have to form a grid in (u, v), the same in every frame.
  // Throws InputError where they do not or there are none.
  explicit TruthSurface(const std::filesystem::path& recording_folder);

  const ClothMesh& mesh() const { return mesh_; }
  int num_frames() const { return static_cast<int>(frames_.size()); }
  const Eigen::VectorXd& x(int frame) const { return frames_[frame]; }  // 3N, m

  // Places (m) of points of the cloth (m) in a frame, linear within the grid's triangles.
  std::vector<Eigen::Vector3d> At(int frame, const std::vector<Eigen::Vector2d>& uv) const;

 private:
  ClothMesh mesh_;
  std::vector<Eigen::VectorXd> frames_;
};

}  // namespace clothfit
