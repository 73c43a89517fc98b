// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/outliers/outliers.h"

#include <cmath>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/normal_numbers.h"

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kMarkersASide = 10, kSheetFrames = 40;
constexpr double kSheetSize = 0.9, kSheetSigma = 0.002;  // m

Eigen::Vector2d UvOf(int id) {
  return kSheetSize / (kMarkersASide - 1) * Eigen::Vector2d(id % kMarkersASide, id / kMarkersASide);
}

// A sheet that swings and waves. stretch: along u, as a whole.
Eigen::Vector3d PlaceOnSheet(const Eigen::Vector2d& uv, double time, double stretch) {
  const double swing = 0.5 * std::sin(3.0 * time);
  const double wave = 0.05 * std::sin(8.0 * uv.x() + 9.0 * time) * std::sin(5.0 * uv.y());
  const double u = stretch * uv.x();
  return {u, std::sin(swing) * uv.y() + wave, -std::cos(swing) * uv.y()};
}

Recording MakeSheet(double stretch = 1.0) {
  Recording recording;
  recording.frame_count = kSheetFrames;
  recording.noise.marker = kSheetSigma;
  recording.cloth.size = {kSheetSize, kSheetSize};
  NormalNumbers noise(7, 0);
  for (int frame = 0; frame < kSheetFrames; ++frame) {
    for (int id = 0; id < kMarkersASide * kMarkersASide; ++id) {
      const Eigen::Vector2d uv = UvOf(id);
      const Eigen::Vector3d position = PlaceOnSheet(uv, frame / recording.frame_rate, stretch) +
                                       kSheetSigma * noise.NextVector<3>();
      recording.markers.push_back({frame, id, uv, position});
    }
  }
  return recording;
}

// An error there may take the end with it.
bool IsBesideEnd(int frame) { return frame == 1 || frame == kSheetFrames - 2; }

using FrameAndId = std::pair<int, int>;

std::set<FrameAndId> LeftOut(const std::vector<Outlier>& out) {
  std::set<FrameAndId> found;
  for (const Outlier& o : out) {
    if (const auto* marker = std::get_if<Marker>(&o.point))
      found.insert({marker->frame, marker->id});
    if (const auto* track = std::get_if<Track>(&o.point)) found.insert({track->frame, track->id});
  }
  return found;
}

TEST(Outliers, OfOneInAHundredAreAllFoundAndNothingElse) {
  Recording recording = MakeSheet();
  const std::size_t all = recording.markers.size();
  NormalNumbers random(11, 0);
  std::set<FrameAndId> planted;
  for (Marker& marker : recording.markers) {
    if (random.Index(100) != 0 || IsBesideEnd(marker.frame)) continue;
    marker.position += 0.18 * random.NextVector<3>().normalized();
    planted.insert({marker.frame, marker.id});
  }
  ASSERT_GT(planted.size(), 20U);
  LeaveOutOutliers(&recording);
  const std::vector<Outlier>& out = recording.left_out;
  EXPECT_EQ(LeftOut(out), planted);
  EXPECT_EQ(recording.markers.size() + planted.size(), all);
  EXPECT_GE(out.front().off, out.back().off);
  EXPECT_THAT(DescribeOutliers(recording), HasSubstr("of 4000 markers (worst: marker "));
}

TEST(Outliers, AreNoneWhereThereAreNone) {
  Recording recording = MakeSheet();
  LeaveOutOutliers(&recording);
  EXPECT_THAT(recording.left_out, IsEmpty());
  EXPECT_EQ(recording.markers.size(),
            static_cast<std::size_t>(kSheetFrames * kMarkersASide * kMarkersASide));
  EXPECT_EQ(DescribeOutliers(recording), "");
}

TEST(Outliers, AreNoneOfAClothThatIsStretchedAsAWhole) {
  Recording recording = MakeSheet(1.4);
  LeaveOutOutliers(&recording);
  EXPECT_THAT(recording.left_out, IsEmpty());
}

// A wrong label is a fault of the recording that is looked for elsewhere.
TEST(Outliers, AreNotLabelsThatAreAlwaysExchanged) {
  Recording recording = MakeSheet();
  for (Marker& marker : recording.markers) {
    if (marker.id != 12 && marker.id != 77) continue;
    marker.id = 12 + 77 - marker.id;
    marker.uv = UvOf(marker.id);
  }
  LeaveOutOutliers(&recording);
  EXPECT_THAT(recording.left_out, IsEmpty());
}

TEST(Outliers, OfTracksAreFoundInEachCamera) {
  Recording recording = MakeSheet();
  recording.noise.track = 0.5;
  recording.cameras.resize(2);
  recording.cameras[1].name = "left";
  NormalNumbers random(5, 0);
  std::set<FrameAndId> planted;
  for (const Marker& m : recording.markers) {
    for (int camera = 0; camera < 2; ++camera) {
      Eigen::Vector2d pixel(500.0 * m.position.x() + 0.5 * camera, 500.0 * m.position.z());
      if (camera == 1 && random.Index(200) == 0 && !IsBesideEnd(m.frame)) {
        pixel += Eigen::Vector2d(30.0, -30.0);
        planted.insert({m.frame, m.id});
      }
      recording.tracks.push_back({m.frame, camera, m.id, m.uv, pixel});
    }
  }
  recording.markers.clear();
  LeaveOutOutliers(&recording);
  const std::vector<Outlier>& out = recording.left_out;
  for (const Outlier& o : out) EXPECT_EQ(std::get<Track>(o.point).camera, 1);
  EXPECT_EQ(LeftOut(out), planted);
  EXPECT_THAT(DescribeOutliers(recording), HasSubstr("in camera left at frame "));
}

}  // namespace
}  // namespace clothfit
