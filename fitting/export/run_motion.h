// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The moving mesh of a run, for other programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/runs/run_folder.h"

namespace clothfit {

struct RunMotion {
  std::string name;  // of the recording
  ClothMesh mesh;
  double frame_rate = 30.0;             // Hz
  std::vector<Eigen::VectorXd> frames;  // 3N, m, world
};

// trajectory.npy of a run of `fit` or `simulate`, and the mesh that its config makes of its
// recording. Throws InputError where they are missing, damaged or do not belong together.
RunMotion ReadRunMotion(const RunFolder& run);

// Unit normals of the particles (3N), of the triangles around them weighted by area.
Eigen::VectorXd ParticleNormals(const ClothMesh& mesh, const Eigen::VectorXd& x);

}  // namespace clothfit
