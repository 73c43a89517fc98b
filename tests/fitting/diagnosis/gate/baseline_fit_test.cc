// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A baseline is not left in the first local minimum that its fit comes to.
#include "fitting/diagnosis/gate/baseline_fit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

Recording StiffCloth() {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_rate = 30.0;
  options.frame_count = 30;
  options.steps_per_frame = 4;
  options.parameters = {{"bending.stiffness", 2e-3},
                        {"bending.damping", 2e-5},
                        {"stretch.stiffness", 300.0},
                        {"stretch.damping", 0.5},
                        {"shear.damping", 0.2}};
  return MakeSyntheticRecording(options).recording;
}

TEST(BaselineFit, EndsNoHigherThanFromTheConfigsOwnStart) {
  const Recording recording = StiffCloth();
  FitConfig config = DefaultConfig(recording);
  config.initial_order = 1;
  config.max_iterations =
      3;  // so few that the config's start, which is far off, does not get there
  const Scene scene = MakeScene(recording, config);
  const FitResult own = RunFit(scene, config);
  std::vector<std::string> log;
  DiagnosisOptions options;
  options.log = [&](const std::string& line) { log.push_back(line); };
  const FittedScene fitted = FitBaseline(recording, config, options);
  EXPECT_LE(fitted.fit.cost_after, own.cost_after);
  const auto others = std::count_if(log.begin(), log.end(), [](const std::string& line) {
    return line.find("from other material parameters") != std::string::npos;
  });
  EXPECT_EQ(others, 3);  // it was worth trying
  EXPECT_EQ(fitted.config.max_iterations, 3);
}

}  // namespace
}  // namespace clothfit
