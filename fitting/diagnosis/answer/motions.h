// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis shows in moving pictures: the cloth without and with what was found, and the
// force that the one lacks.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "tracking/recording/recording.h"

namespace clothfit {

struct FittedScene;
struct MissingForce;

// Frame by frame from frame 0, open loop, as many as the simulation reaches, on the mesh of the
// fitted models; 3 numbers a particle.
struct DiagnosisMotions {
  std::vector<Eigen::VectorXd> baseline;  // m, world
  std::vector<Eigen::VectorXd> answer;    // the same, with what was found; empty without a find
  std::vector<Eigen::VectorXd> missing_force;  // N/m^2: normal, warp, weft; empty where none is
  std::array<int, 2> resolution = {0, 0};      // particles along u and v; 0 where there is no grid
  std::optional<Splits::FrameRange> held_out;  // frames that no model was fitted to
};

// One simulation of the whole recording at what was fitted.
std::vector<Eigen::VectorXd> SimulateFitted(const FittedScene& fitted);

// The force at each particle of a mesh, up to the last frame that it was looked for in.
std::vector<Eigen::VectorXd> ForceOnParticles(const ClothMesh& mesh, const MissingForce& missing);

}  // namespace clothfit
