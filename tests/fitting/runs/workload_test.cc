// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/workload.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/small_recording.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

TEST(Workload, GrowsWithWhatItIsOf) {
  SmallRecordingOptions options;
  options.particles = 4;
  options.frames = 6;
  const Recording recording = MakeSmallRecording(options);
  FitConfig config = DefaultConfig(recording);
  const auto work = [&] { return WorkOfFit(MakeScene(recording, config), config); };
  const Workload small = work();
  EXPECT_EQ(small.num_particles, 16);
  EXPECT_GT(small.num_free, 0);
  EXPECT_LT(small.bytes, AvailableMemory());
  config.resolution = {8, 8};
  const Workload finer = work();
  EXPECT_GT(finer.bytes, 3.0 * small.bytes);
  config.max_step /= 10.0;
  EXPECT_GT(work().steps, 9.0 * finer.steps);
  EXPECT_GT(work().bytes, finer.bytes);
}

TEST(Workload, IsRefusedBeyondTheMachine) {
  const Recording recording = MakeSmallRecording();
  const Scene scene = MakeScene(recording, DefaultConfig(recording));
  EXPECT_NO_THROW(CheckAffordable(scene, {1e6, 1e3, 36, 10}));
  EXPECT_THAT(InputErrorOf([&] {
                CheckAffordable(scene, {1e15, 1e3, 36, 10});
              }),
              HasSubstr("takes about 1e+06 GB of memory (36 particles, 30 frames, 10 unknowns)"));
  EXPECT_THAT(InputErrorOf([&] {
                CheckAffordable(scene, {1e6, 1e9, 36, 10});
              }),
              HasSubstr("1e+09 steps to simulate"));
}

TEST(Workload, BoundsThePathsThatAreUnknown) {
  Recording recording = MakeSmallRecording();
  recording.frame_count = 100'000;
  recording.handles[0].path.reset();
  for (std::size_t h = 1; h < recording.handles.size(); ++h) recording.handles[h].path.reset();
  EXPECT_THAT(InputErrorOf([&] { MakeScene(recording, DefaultConfig(recording)); }),
              HasSubstr("take more than 2000 control points"));
}

}  // namespace
}  // namespace clothfit
