// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/strip.h"

#include <algorithm>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

SyntheticOptions Strip(const std::map<std::string, double>& effects) {
  SyntheticOptions options;
  options.scenario = SyntheticScenario::kTwoCornerTurn;
  options.size = {0.4, 0.12};
  options.resolution = {9, 3};
  options.markers = {6, 3};
  options.marker_sigma = 0.003;
  options.frame_rate = 30.0;
  options.frame_count = 30;
  options.steps_per_frame = 8;
  options.seed = 5;
  options.parameters = effects;
  return options;
}

Recording SeenAskew(const std::map<std::string, double>& effects, const Eigen::Vector3d& shift) {
  SyntheticOptions options = Strip(effects);
  options.markers = {0, 0};
  options.num_cameras = 3;
  options.track_sigma = 2.0;
  Recording recording = MakeSyntheticRecording(options).recording;
  Camera& camera = recording.cameras[1];
  camera.camera_from_world_translation -= camera.camera_from_world_rotation * shift;
  return recording;
}

FitConfig Told(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  if (recording.markers.empty()) config.loss = LossKind::kNone;
  for (auto& [name, setting] : config.parameters)
    setting.free = name == "stretch.stiffness" || name == "bending.stiffness";
  config.max_iterations = 8;
  return config;
}

DiagnosisOptions OnlyAmong(const std::vector<std::string>& terms) {
  DiagnosisOptions options;
  options.max_effects = 2;
  options.max_models = 2;
  options.num_nulls = 100;
  options.finest_side = 10;
  for (const TermInfo& term : AllTerms()) {
    if (std::find(terms.begin(), terms.end(), term.name) == terms.end())
      options.excluded.push_back(term.name);
  }
  return options;
}

}  // namespace clothfit
