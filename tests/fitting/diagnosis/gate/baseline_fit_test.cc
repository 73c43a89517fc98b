// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A baseline is not left in the first local minimum that its fit comes to.
#include "fitting/diagnosis/gate/baseline_fit.h"

#include <gtest/gtest.h>

#include "fitting/diagnosis/fitted/fit_quality.h"
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
                        {"bending.damping", 8e-6},
                        {"stretch.stiffness", 300.0},
                        {"stretch.damping", 0.5},
                        {"shear.damping", 0.2}};
  return MakeSyntheticRecording(options).recording;
}

TEST(BaselineFit, ComesFromAfar) {
  const Recording recording = StiffCloth();
  const FitConfig config = DefaultConfig(recording);
  const FittedScene fitted = FitBaseline(recording, config, {});
  EXPECT_FALSE(MayBeLocalMinimum(fitted.scene, fitted.config, fitted.fit)) << fitted.fit.cost_after;
  EXPECT_EQ(fitted.config.initial_order, 1);
  EXPECT_EQ(fitted.config.max_iterations, config.max_iterations);
  EXPECT_EQ(fitted.config.window, config.window);
}

}  // namespace
}  // namespace clothfit
