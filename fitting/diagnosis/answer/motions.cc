// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/motions.h"

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/diagnosis/locate/residual_force.h"

namespace clothfit {

std::vector<Eigen::VectorXd> SimulateFitted(const FittedScene& fitted) {
  const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
  std::vector<Eigen::VectorXd> positions;
  SimulateFrames(fitted.scene, fitted.config, free, fitted.fit.theta,
                 fitted.scene.recording.frame_count - 1,
                 [&](int, const State& state) { positions.push_back(state.x); });
  return positions;
}

std::vector<Eigen::VectorXd> ForceOnParticles(const ClothMesh& mesh, const MissingForce& missing) {
  std::vector<Eigen::VectorXd> frames;
  for (int frame = 0; frame <= missing.last_frame; ++frame) {
    const double time = frame / missing.layout.frame_rate;
    Eigen::VectorXd forces(3 * mesh.num_particles());
    for (int i = 0; i < mesh.num_particles(); ++i)
      forces.segment<3>(3 * i) = missing.layout.At(missing.force, time, mesh.uv[i]);
    frames.push_back(std::move(forces));
  }
  return frames;
}

}  // namespace clothfit
