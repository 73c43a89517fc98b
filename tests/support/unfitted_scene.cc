// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/unfitted_scene.h"

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

FittedScene UnfittedScene(const Recording& recording, const std::map<std::string, double>& values) {
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = false;
  for (const auto& [name, value] : values) config.parameters.at(name).value = value;
  FittedScene model;
  model.scene = MakeScene(recording, config);
  model.config = model.values = config;
  model.fit.theta = FreeParameters(config, model.scene, MakeParameterTable()).start();
  return model;
}

}  // namespace clothfit
