// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/outliers/swapped_markers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/normal_numbers.h"

namespace clothfit {
namespace {

using testing::IsEmpty;

constexpr int kFlagSide = 12, kFlagFrames = 60;
constexpr double kFlagSize = 0.8, kFlagSigma = 0.002;  // m

// A flag: its free end runs at up to 4 m/s, 15 cm a frame, where markers are 7 cm apart.
Recording MakeFlag() {
  Recording recording;
  recording.frame_count = kFlagFrames;
  recording.frame_rate = 30.0;
  recording.cloth.size = {kFlagSize, kFlagSize};
  NormalNumbers noise(5, 0);
  for (int frame = 0; frame < kFlagFrames; ++frame) {
    for (int id = 0; id < kFlagSide * kFlagSide; ++id) {
      const Eigen::Vector2d uv =
          kFlagSize / (kFlagSide - 1) * Eigen::Vector2d(id % kFlagSide, id / kFlagSide);
      const double t = frame / recording.frame_rate;
      const double turn = 0.8 * std::sin(7.0 * t);
      const double wave = 0.02 * std::sin(4.0 * uv.y() + 9.0 * t);
      const Eigen::Vector3d place(uv.x() * std::cos(turn), uv.x() * std::sin(turn) + wave, uv.y());
      recording.markers.push_back({frame, id, uv, place + kFlagSigma * noise.NextVector<3>()});
    }
  }
  return recording;
}

void HideMarkers(const std::vector<std::pair<int, int>>& ids_and_frames, Recording* recording) {
  auto& markers = recording->markers;
  const auto is_hidden = [&](const Marker& m) {
    return std::count(ids_and_frames.begin(), ids_and_frames.end(), std::make_pair(m.id, m.frame)) >
           0;
  };
  markers.erase(std::remove_if(markers.begin(), markers.end(), is_hidden), markers.end());
}

std::vector<std::string> SwapsFound(const Recording& recording) {
  std::vector<std::string> found;
  for (const SwappedMarkers& swap : FindSwappedMarkers(recording)) found.push_back(ToString(swap));
  return found;
}

TEST(SwappedMarkers, AreNoneInAFlagThatIsThrownAbout) {
  EXPECT_THAT(SwapsFound(MakeFlag()), IsEmpty());
}

TEST(SwappedMarkers, AreFoundFromTheirFrameOnAndPutRight) {
  const Recording truth = MakeFlag();
  Recording recording = truth;
  SwapBack({{3, 140}, 17}, &recording);
  SwapBack({{64, 65}, 40}, &recording);  // neighbours
  SwapBack({{7, 90}, 40}, &recording);
  const std::vector<SwappedMarkers> found = FindSwappedMarkers(recording);
  EXPECT_THAT(SwapsFound(recording),
              testing::UnorderedElementsAre("markers 3 and 140 swapped from frame 17 on",
                                            "markers 64 and 65 swapped from frame 40 on",
                                            "markers 7 and 90 swapped from frame 40 on"));
  for (const SwappedMarkers& swap : found) SwapBack(swap, &recording);
  for (std::size_t i = 0; i < truth.markers.size(); ++i) {
    ASSERT_EQ(recording.markers[i].id, truth.markers[i].id);
    ASSERT_EQ(recording.markers[i].uv, truth.markers[i].uv);
  }
}

TEST(SwappedMarkers, ThatComeBackAreSwappedTwice) {
  Recording recording = MakeFlag();
  SwapBack({{20, 77}, 12}, &recording);
  SwapBack({{20, 77}, 30}, &recording);
  EXPECT_THAT(SwapsFound(recording),
              testing::ElementsAre("markers 20 and 77 swapped from frame 12 on",
                                   "markers 20 and 77 swapped from frame 30 on"));
}

TEST(SwappedMarkers, AreFoundWhereOneIsHiddenAtFirst) {
  Recording recording = MakeFlag();
  SwapBack({{20, 77}, 12}, &recording);
  HideMarkers({{20, 12}, {77, 13}}, &recording);
  EXPECT_THAT(SwapsFound(recording),
              testing::ElementsAre("markers 20 and 77 swapped from frame 12 on"));
}

TEST(SwappedMarkers, AreFoundInTurnAndWithOneThatIsHidden) {
  Recording recording = MakeFlag();
  SwapBack({{20, 77, 130, 4}, 25}, &recording);
  SwapBack({{31, 95, 60}, 25}, &recording);
  HideMarkers({{95, 25}, {95, 26}, {95, 27}, {95, 28}}, &recording);
  EXPECT_THAT(SwapsFound(recording),
              testing::UnorderedElementsAre("markers 4, 130, 77 and 20 swapped from frame 25 on",
                                            "markers 31, 60 and 95 swapped from frame 25 on"));
  for (const SwappedMarkers& swap : FindSwappedMarkers(recording)) SwapBack(swap, &recording);
  EXPECT_THAT(SwapsFound(recording), IsEmpty());
}

TEST(SwappedMarkers, AreFoundWhereOneIsHiddenForLong) {
  Recording recording = MakeFlag();
  SwapBack({{20, 77}, 25}, &recording);
  for (int frame = 19; frame < 36; ++frame) HideMarkers({{77, frame}}, &recording);
  EXPECT_THAT(SwapsFound(recording),
              testing::ElementsAre("markers 20 and 77 swapped from frame 25 on"));
}

// A third one is nearer to where the swapped ones were going than to its own place.
TEST(SwappedMarkers, AreFoundBesideAGrossErrorAtTheirPlace) {
  Recording recording = MakeFlag();
  SwapBack({{20, 77}, 25}, &recording);
  Eigen::Vector3d at_20 = Eigen::Vector3d::Zero();
  for (const Marker& m : recording.markers)
    if (m.frame == 25 && m.id == 20) at_20 = m.position;
  for (Marker& m : recording.markers)
    if (m.frame == 25 && m.id == 3) m.position = at_20 + Eigen::Vector3d(0.005, 0.0, 0.0);
  EXPECT_THAT(SwapsFound(recording),
              testing::ElementsAre("markers 20 and 77 swapped from frame 25 on"));
}

// A gross error at another marker's place, and one that stays nowhere.
TEST(SwappedMarkers, AreNoGrossErrors) {
  Recording recording = MakeFlag();
  std::vector<Eigen::Vector3d> at_20;
  for (const Marker& m : recording.markers)
    if (m.frame == 20) at_20.push_back(m.position);
  for (Marker& m : recording.markers) {
    if (m.frame == 20 && m.id == 5) m.position = at_20[100];
    if (m.frame >= 30 && m.id == 9) m.position.z() += 0.3;
  }
  EXPECT_THAT(SwapsFound(recording), IsEmpty());
}

// Recordings of another program, thrown about and with gross errors: in one of them six pairs of
// labels were exchanged at frame 40, two of which share markers.
TEST(SwappedMarkers, OfAnotherProgramAreAllFoundAndNoOthers) {
  const std::filesystem::path folder =
      std::filesystem::path(CLOTHFIT_SOURCE_DIR) / ".." / "shared/independent";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << folder << " is not there; recordings of other programs are not shipped";
  for (const char* name : {"d01", "d03", "d06", "d09", "d11"})
    EXPECT_THAT(SwapsFound(ReadRecording(folder / name)), IsEmpty()) << name;
  EXPECT_THAT(SwapsFound(ReadRecording(folder / "d08")),
              testing::UnorderedElementsAre("markers 1 and 145 swapped from frame 40 on",
                                            "markers 12 and 42 swapped from frame 40 on",
                                            "markers 25 and 31 swapped from frame 40 on",
                                            "markers 51, 80 and 57 swapped from frame 40 on",
                                            "markers 59 and 143 swapped from frame 40 on"));
}

}  // namespace
}  // namespace clothfit
