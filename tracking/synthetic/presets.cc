// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/presets.h"

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {

SyntheticOptions ImageOptions() {
  SyntheticOptions options;
  options.scenario = SyntheticScenario::kCornerLift;
  options.size = {1.4, 1.4};
  options.resolution = {31, 31};
  options.refinement = 2;
  options.frame_rate = 30.0;
  options.frame_count = 150;
  options.steps_per_frame = 8;
  options.held_out_share = 0.0;
  options.markers = {0, 0};
  options.num_cameras = 7;
  options.tracks = false;
  options.images = true;
  options.truth_points = {31, 31};
  // A heavy cotton: it hangs in few large folds and calms down quickly. Nothing here is an initial
  // value of a fit.
  options.parameters = {{"cloth.areal_density", 0.18}, {"stretch.stiffness", 1500.0},
                        {"stretch.damping", 5.0},      {"shear.stiffness", 60.0},
                        {"shear.damping", 4.0},        {"bending.stiffness", 1e-4},
                        {"bending.damping", 1e-4},     {"air_drag.normal", 1.0},
                        {"air_drag.tangential", 0.03}, {"ground.friction", 0.5}};
  return options;
}

std::vector<std::string> PresetNames() { return {"experiment-1", "experiment-2", "experiment-3"}; }

SyntheticOptions PresetOptions(const std::string& place, const std::string& name) {
  SyntheticOptions options = ImageOptions();
  if (name == "experiment-1") return options;
  if (name == "experiment-2") {
    options.pictures.pattern = ClothPattern::kRepetitive;
    options.pictures.specular = 0.5;
    return options;
  }
  if (name == "experiment-3") {
    options.scenario = SyntheticScenario::kTwoCornerLift;
    options.seed = 3;
    return options;
  }
  throw InputError(place, "'" + name + "': " + Suggestion(name, PresetNames()));
}

}  // namespace clothfit
