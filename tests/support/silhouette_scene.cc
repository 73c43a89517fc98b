// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/silhouette_scene.h"

#include <cmath>
#include <memory>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"
#include "tests/support/flat_scene.h"
#include "tests/support/small_recording.h"
#include "tracking/silhouette/raster.h"

namespace clothfit {
double SilhouetteScene::SurfaceError(const Eigen::VectorXd& theta) const {
  const FreeParameters free(config, scene, MakeParameterTable());
  double sum = 0.0;
  const auto frames = static_cast<int>(true_x.size());
  SimulateFrames(scene, config, free, theta, frames - 1, [&](int frame, const State& state) {
    sum += (state.x - true_x[frame]).squaredNorm();
  });
  return std::sqrt(sum / (frames * scene.mesh.num_particles()));
}

SilhouetteScene MakeSilhouetteScene(bool hidden, int frames) {
  SmallRecordingOptions options;
  options.frames = frames;
  options.particles = 7;
  Recording recording = MakeSmallRecording(options);
  recording.splits = {};
  recording.markers.clear();
  recording.cameras = {LookAt({-0.5, -0.6, 1.3}, {0.2, 0.2, 0.9}),
                       LookAt({1.0, -0.4, 0.9}, {0.2, 0.2, 0.9}),
                       LookAt({0.2, 1.2, 1.1}, {0.2, 0.2, 0.9})};
  SilhouetteScene result;
  result.config = DefaultConfig(recording);
  result.config.buckling = false;  // searches take a third of the time
  result.config.use_silhouettes = true;
  result.config.loss = LossKind::kHuber;
  FitConfig true_config = result.config;
  for (const auto& [name, value] : options.parameters) {
    result.truth.emplace_back(name, value);
    true_config.parameters.at(name).value = value;
  }
  Scene true_scene = MakeScene(recording, true_config);
  auto silhouettes = std::make_shared<Silhouettes>();
  const FreeParameters free(true_config, true_scene, MakeParameterTable());
  SimulateFrames(
      true_scene, true_config, free, free.start(), frames - 1, [&](int frame, const State& state) {
        result.true_x.push_back(state.x);
        for (int c = 0; c < 3; ++c) {
          BitMask mask;
          SilhouetteRaster(recording.cameras[c], true_scene.mesh.triangles).Draw(state.x, &mask);
          silhouettes->observations.push_back(MakeSilhouette(frame, c, mask.ToMat()));
        }
      });
  for (HandleDescription& handle : recording.handles) {
    result.true_paths.emplace_back();
    for (const auto& place : *handle.path) result.true_paths.back().push_back(*place);
    if (hidden) handle.path.reset();
  }
  true_scene.silhouettes = silhouettes;
  result.scene = MakeScene(recording, result.config, &true_scene);
  return result;
}

}  // namespace clothfit
