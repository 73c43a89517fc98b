// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a recording's truth/ folder knows of the true surface. For evaluation only: no fit includes
// this.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "fitting/scene/scene.h"
#include "tracking/recording/surface/truth.h"

namespace clothfit {

class SurfaceTruth {
 public:
  // `folder` is a recording's. Throws InputError where it has neither truth/points.csv nor a cloud
  // (truth/cloud_000000.csv ...), or one is malformed.
  SurfaceTruth(const std::filesystem::path& folder, const Scene& scene);

  // Distances (m) of one frame's true points from the same points (u, v) of the scene's cloth with
  // particles at x (3N, m, world); none where the frame has no points.
  std::vector<double> PointDistances(int frame, const Eigen::VectorXd& x) const;
  // One frame's cloud, m, world; empty where there is none.
  std::vector<Eigen::Vector3d> Cloud(int frame) const;

 private:
  std::filesystem::path folder_;
  std::map<int, std::vector<TruthPoint>> points_;
  std::map<int, std::vector<SurfacePoint>> on_cloth_;
};

}  // namespace clothfit
