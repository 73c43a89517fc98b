// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a second of real motion capture, where it is there.
#include <filesystem>

#include <gtest/gtest.h>

#include "fitting/fit/fit.h"

namespace clothfit {
namespace {

TEST(RealFit, ExplainsTheFirstSecondOfZigZag) {
  const std::filesystem::path folder =
      std::filesystem::path(CLOTHFIT_SOURCE_DIR) / ".." / "shared/real/mocap/zig_zag";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << folder << " is not there; real recordings are not shipped";
  }
  const Recording recording = ReadRecording(folder);
  FitConfig config = DefaultConfig(recording);
  config.resolution = {5, 5};
  config.frames = std::array<int, 2>{0, 120};
  config.max_iterations = 8;
  const Scene scene = MakeScene(recording, config);
  const FitResult fit = RunFit(scene, config);
  ASSERT_TRUE(fit.after.marker_rms.has_value());
  // Two hands move a cloth of 0.33 m by a tenth of a metre and
  // more; what this coarse cloth leaves is 6 mm.
  EXPECT_LT(*fit.after.marker_rms, 0.008);
  EXPECT_LT(fit.cost_after, 0.6 * fit.cost_before);
  EXPECT_EQ(fit.steps.halvings, 0);
}

}  // namespace
}  // namespace clothfit
