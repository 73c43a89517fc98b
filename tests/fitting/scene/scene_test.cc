// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/scene/scene.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// A flat cloth held by a corner whose path is not known.
Scene HeldByAHiddenHandle(int frames) {
  Recording recording;
  recording.frame_count = frames;
  recording.frame_rate = 10.0;
  recording.cloth.size = {0.4, 0.4};
  recording.cloth.resolution = {4, 4};
  recording.cloth.initial = FlatPlacement{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  HandleDescription handle;
  handle.name = "corner";
  handle.uv = {0.4, 0.0};
  recording.handles = {handle};
  FitConfig config = DefaultConfig(recording);
  config.spline_spacing = 0.1;  // s: a frame
  return MakeScene(recording, config);
}

// Four control points act at any time, so at the only time of a single frame, too.
TEST(HandlePath, HasFourControlPointsAtEveryTime) {
  for (const int frames : {1, 2, 3, 10}) {
    const Scene scene = HeldByAHiddenHandle(frames);
    const HandlePath& path = scene.handles.at(0).path;
    ASSERT_EQ(path.num_controls(), std::max(frames - 1, 1) + 3) << frames;
    for (int frame = 0; frame < frames; ++frame) {
      int first = -1;
      std::array<double, 4> weights;
      path.Weights(scene.FrameTime(frame), &first, &weights);
      EXPECT_GE(first, 0);
      EXPECT_LE(first + 4, path.num_controls());
      EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-14);
      EXPECT_NEAR((path.At(scene.FrameTime(frame)) - Eigen::Vector3d(0.4, 0.0, 1.0)).norm(), 0.0,
                  1e-14);
    }
  }
}

TEST(Scene, FitsOneFrameInSoMany) {
  Recording recording;
  recording.frame_count = 12;
  recording.cloth.size = {0.4, 0.4};
  recording.cloth.resolution = {4, 4};
  recording.cloth.initial = FlatPlacement{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  recording.splits.held_out_frames = Splits::FrameRange{10, 11};
  FitConfig config = DefaultConfig(recording);
  config.every = 3;
  const auto fitted = [&] {
    const Scene scene = MakeScene(recording, config);
    std::vector<int> frames;
    for (int frame = 0; frame < recording.frame_count; ++frame)
      if (scene.is_fitted[static_cast<std::size_t>(frame)]) frames.push_back(frame);
    return frames;
  };
  EXPECT_EQ(fitted(), (std::vector<int>{0, 3, 6, 9}));
  config.frames = {2, 11};
  EXPECT_EQ(fitted(), (std::vector<int>{2, 5, 8}));  // 11 is held out
}

}  // namespace
}  // namespace clothfit
