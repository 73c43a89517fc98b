// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The map of the missing force in words, and the force of what was named beside it.
#include "fitting/diagnosis/locate/discrepancy_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/diagnosis/classify/class_text.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

Scene SceneOfFourFrames() {
  SmallRecordingOptions options;
  options.particles = 4;
  options.frames = 4;
  const Recording recording = MakeSmallRecording(options);
  return MakeScene(recording, DefaultConfig(recording));
}

Discrepancy PushedAlong(const Eigen::Vector3d& direction) {
  Discrepancy discrepancy;
  discrepancy.is_significant = true;
  discrepancy.last_frame = 3;
  discrepancy.low_uv = Eigen::Vector2d::Zero();
  discrepancy.high_uv = Eigen::Vector2d::Ones();
  discrepancy.direction = direction;
  discrepancy.peak = 0.22;
  discrepancy.peak_sigma = 0.1;
  return discrepancy;
}

TEST(DiscrepancyText, SaysThatItIsTheMapsAndTheOtherTheModels) {
  const Scene scene = SceneOfFourFrames();
  EXPECT_EQ(DiscrepancyText(scene, ForceLayout(), 3, PushedAlong(Eigen::Vector3d::UnitY())),
            "By the map of the missing force, all the time the whole cloth is pushed along +y with "
            "up to 0.22 N/m^2 (+- 0.1) more than the baseline has.");
  ActingForce acting;
  acting.peak = 0.11;
  EXPECT_THAT(ClassOfActing(scene, acting).words, testing::StartsWith("In the fitted model it "));
  EXPECT_THAT(ClassOfActing(scene, acting).words, testing::HasSubstr("with 0.11 N/m^2"));
}

TEST(DiscrepancyText, HasNoDirectionOfNothing) {
  EXPECT_EQ(
      DiscrepancyText(SceneOfFourFrames(), ForceLayout(), 3, PushedAlong(Eigen::Vector3d::Zero())),
      "By the map of the missing force, all the time the whole cloth is pushed with up to "
      "0.22 N/m^2 (+- 0.1) more than the baseline has.");
}

}  // namespace
}  // namespace clothfit
