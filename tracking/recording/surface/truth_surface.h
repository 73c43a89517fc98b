// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The truth of a recording as a surface: which point of the cloth each pixel shows, and where any
// point of it is. For evaluation only, as tracking/recording/surface/truth.h.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "tracking/recording/surface/cloth_surface.h"
#include "tracking/recording/surface/truth.h"

namespace clothfit {

// Between the points of truth/points.csv, which have to form a grid in (u, v) that is the same in
// every frame, the surface consists of triangles. With as many points as the generator's mesh has
// it is the surface that was rendered.
class TruthSurface {
 public:
  // Throws InputError, naming `place`, where the points form no grid.
  TruthSurface(const std::vector<TruthPoint>& points, const std::string& place);
  static TruthSurface Read(const std::filesystem::path& recording_folder);

  int frame_count() const { return static_cast<int>(frames_.size()); }
  const ClothMesh& mesh() const { return *mesh_; }
  // 3N, m, world.
  const Eigen::VectorXd& positions(int frame) const { return frames_.at(frame); }

  // What can be seen at the frame, until the next call.
  const ClothSurface& MoveTo(int frame);
  // m, world, of points of the cloth (m) at a frame.
  std::vector<Eigen::Vector3d> At(int frame, const std::vector<Eigen::Vector2d>& uv) const;

 private:
  std::unique_ptr<ClothMesh> mesh_;  // stays where it is: the surface refers to it
  std::vector<Eigen::VectorXd> frames_;
  ClothSurface surface_;
};

}  // namespace clothfit
