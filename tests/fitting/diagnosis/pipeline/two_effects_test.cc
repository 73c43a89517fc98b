// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole diagnoses of a strip of cloth in which more than one thing is wrong.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "fitting/diagnosis/pipeline/diagnose.h"
#include "tests/support/known_failure.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Names = std::vector<std::string>;

// As long as a mesh needs to be that no coarser one is worth a try, and as narrow as can be.
SyntheticOptions Strip() {
  SyntheticOptions options;
  options.size = {0.4, 0.12};
  options.resolution = {9, 3};
  options.refinement = 2;
  options.markers = {6, 3};
  options.frame_rate = 30.0;
  options.frame_count = 30;
  options.steps_per_frame = 8;
  options.seed = 5;
  return options;
}

SyntheticOptions FilmedStrip() {
  SyntheticOptions options = Strip();
  options.num_cameras = 3;
  return options;
}

// The recording of cameras alone, of which the second stands elsewhere than is said.
Recording SeenAskew(const SyntheticOptions& options, const Eigen::Vector3d& shift) {
  Recording recording = MakeSyntheticRecording(options).recording;
  recording.markers.clear();
  Camera& camera = recording.cameras[1];
  camera.camera_from_world_translation -= camera.camera_from_world_rotation * shift;
  return recording;
}

FitConfig Told(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = false;
  for (const char* name : {"stretch.stiffness", "bending.stiffness"})
    config.parameters.at(name).free = true;
  config.max_iterations = 8;
  config.loss = LossKind::kNone;
  return config;
}

DiagnosisOptions Quick() {
  DiagnosisOptions options;
  options.max_effects = 2;
  options.max_models = 2;
  options.num_nulls = 100;
  options.finest_side = 10;
  return options;
}

}  // namespace
}  // namespace clothfit
