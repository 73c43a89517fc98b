// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/marker_tracker.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/flat_scene.h"
#include "tracking/features/cloth_coordinates.h"

namespace clothfit {
namespace {

// Features that are made, not detected: each point of the cloth has a descriptor of its own.
class MarkerTrackerTest : public testing::Test {
 protected:
  MarkerTrackerTest() : random_(4) {
    cameras_ = {LookAt({0.1, -0.5, 1.3}, {0.4, 0.3, 0.0}),
                LookAt({0.9, -0.4, 1.3}, {0.4, 0.3, 0.0}),
                LookAt({0.4, 0.9, 1.3}, {0.4, 0.3, 0.0})};
    std::normal_distribution<float> normal;
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 6; ++j) {
        uv_.emplace_back(0.05 + 0.1 * i, 0.05 + 0.1 * j);
        cv::Mat descriptor(1, 128, CV_32F);
        for (int k = 0; k < 128; ++k) descriptor.at<float>(k) = 40.0F * normal(random_);
        descriptors_.push_back(descriptor);
      }
    }
  }

  Eigen::Vector3d Place(std::size_t point, int frame) const {
    return {uv_[point].x() + 0.01 * frame, uv_[point].y(), 0.02 * frame};
  }
  std::vector<Features> Views(int frame) {
    std::vector<Features> views(cameras_.size());
    std::normal_distribution<float> normal;
    for (std::size_t c = 0; c < cameras_.size(); ++c) {
      for (std::size_t p = 0; p < uv_.size(); ++p) {
        views[c].pixels.push_back(ProjectPoint(cameras_[c], Place(p, frame)));
        cv::Mat noisy = descriptors_[p].clone();
        for (int k = 0; k < 128; ++k) noisy.at<float>(k) += 3.0F * normal(random_);
        views[c].descriptors.push_back(noisy);
      }
    }
    return views;
  }
  // Without the seventh point.
  static std::vector<Features> Hidden(std::vector<Features> views) {
    for (Features& view : views) view.pixels[7] = {-500.0, -500.0};
    return views;
  }
  // With something beside the seventh point that looks the same.
  std::vector<Features> Doubled(std::vector<Features> views, int frame) const {
    for (std::size_t c = 0; c < views.size(); ++c) {
      views[c].pixels.push_back(ProjectPoint(cameras_[c], Place(7, frame)) +
                                Eigen::Vector2d(60.0, 0.0));
      views[c].descriptors.push_back(views[c].descriptors.row(7));
    }
    return views;
  }
  std::vector<std::vector<std::optional<Eigen::Vector2d>>> Uv() const {
    return {cameras_.size(), {uv_.begin(), uv_.end()}};
  }
  double LargestError(const std::vector<TrackedMarker>& markers, int frame) const {
    double largest = 0.0;
    for (const TrackedMarker& m : markers) {
      const Eigen::Vector3d place(m.uv.x() + 0.01 * frame, m.uv.y(), 0.02 * frame);
      largest = std::max(largest, (m.position - place).norm());
    }
    return largest;
  }

  std::mt19937 random_;
  std::vector<Camera> cameras_;
  std::vector<Eigen::Vector2d> uv_;
  std::vector<cv::Mat> descriptors_;
};

TEST_F(MarkerTrackerTest, JoinsTheViewsOfEachPointAndFollowsIt) {
  for (const auto how : {Reidentification::kReference, Reidentification::kTracking}) {
    for (const auto place : {MarkerPlace::kClosestPoints, MarkerPlace::kReprojection}) {
      MarkerTrackerOptions options;
      options.reidentification = how;
      options.place = place;
      MarkerTracker tracker(cameras_, 30.0, options);
      const std::vector<TrackedMarker> first = tracker.Start(Views(0), Uv());
      ASSERT_EQ(first.size(), uv_.size());
      EXPECT_LT(LargestError(first, 0), 1e-6);
      for (int frame = 1; frame <= 5; ++frame) {
        const std::vector<TrackedMarker> found = tracker.Advance(Views(frame));
        ASSERT_EQ(found.size(), uv_.size());
        EXPECT_EQ(found[3].num_cameras, 3);
        EXPECT_LT(LargestError(found, frame), 1e-6);
      }
    }
  }
}

TEST_F(MarkerTrackerTest, FilterByMoveInTheImage) {
  MarkerTracker tracker(cameras_, 30.0, {});
  tracker.Start(Views(0), Uv());
  std::vector<Features> views = Views(1);
  views[0].pixels[7].x() += 15.0;                        // beyond 6 px a frame
  EXPECT_EQ(tracker.Advance(views).size(), uv_.size());  // the other two cameras carry it
  EXPECT_EQ(tracker.counts().at("no feature"), 1);
  EXPECT_EQ(tracker.counts().at("image move"), 1);
}

TEST_F(MarkerTrackerTest, FilterByReprojection) {
  MarkerTracker tracker(cameras_, 30.0, {});
  tracker.Start(Views(0), Uv());
  std::vector<Features> views = Views(1);
  views[1].pixels[7].y() += 5.0;  // within 6 px a frame
  const std::vector<TrackedMarker> found = tracker.Advance(views);
  EXPECT_LT(LargestError(found, 1), 0.02);
  EXPECT_GE(tracker.counts().at("reprojection"), 1);
}

TEST_F(MarkerTrackerTest, FilterByMoveInTheWorld) {
  MarkerTrackerOptions options;
  options.max_world_speed = 0.5;  // m/s; the cloth moves by 0.022 m in 1/30 s
  MarkerTracker tracker(cameras_, 30.0, options);
  tracker.Start(Views(0), Uv());
  EXPECT_TRUE(tracker.Advance(Views(1)).empty());
  EXPECT_EQ(tracker.counts().at("world move"), static_cast<int>(uv_.size()));
  options.check_world_move = false;
  MarkerTracker without(cameras_, 30.0, options);
  without.Start(Views(0), Uv());
  EXPECT_EQ(without.Advance(Views(1)).size(), uv_.size());
}

// What was lost a moment ago and has a double nearby comes back only where three cameras agree: two
// rays nearly meet by chance more often.
TEST_F(MarkerTrackerTest, WhatWasLostAndHasDoublesNeedsThreeCameras) {
  for (const bool has_doubles : {false, true}) {
    for (const int num_cameras : {2, 3}) {
      MarkerTracker tracker(cameras_, 30.0, {});
      tracker.Start(Views(0), Uv());
      tracker.Advance(Hidden(Views(1)));
      std::vector<Features> views = has_doubles ? Doubled(Views(2), 2) : Views(2);
      if (num_cameras == 2) views[2].pixels[7] = {-500.0, -500.0};
      const bool comes_back = !has_doubles || num_cameras == 3;
      EXPECT_EQ(tracker.Advance(views).size(), uv_.size() - (comes_back ? 0 : 1));
      EXPECT_EQ(tracker.counts().count("ambiguous"), comes_back ? 0 : 1);
    }
  }
}

// What was lost for long comes back if its look is its own.
TEST_F(MarkerTrackerTest, WhatWasLostForLongMustNotHaveHadDoubles) {
  for (const bool had_doubles : {false, true}) {
    MarkerTracker tracker(cameras_, 30.0, {});
    std::vector<std::vector<std::optional<Eigen::Vector2d>>> uv = Uv();
    for (auto& of_view : uv) {
      if (had_doubles) of_view.emplace_back();  // it lies beside the cloth
    }
    tracker.Start(had_doubles ? Doubled(Views(0), 0) : Views(0), uv);
    int frame = 1;
    for (; frame <= 6; ++frame) EXPECT_EQ(tracker.Advance(Hidden(Views(0))).size(), 47);
    EXPECT_EQ(tracker.Advance(Views(0)).size(), had_doubles ? 47 : 48);
  }
}

// On a pattern that repeats every 5 cm, some markers jump by one repeat: near on the scale of the
// cloth, and still contradicted by their neighbours.
TEST(Vote, ThrowsOutWhatIsOffByOneRepeat) {
  std::mt19937 random(3);
  std::vector<TrackedMarker> markers;
  std::vector<bool> is_off;
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      TrackedMarker m;
      m.uv = {0.04 * i, 0.04 * j};
      m.position = {m.uv.x(), m.uv.y(), 0.0};
      is_off.push_back(random() % 20 == 0);
      if (is_off.back()) m.position[random() % 2] += random() % 2 == 0 ? 0.05 : -0.05;
      markers.push_back(m);
    }
  }
  for (const int num_neighbours : {0, 16}) {
    MarkerTrackerOptions options;
    options.num_neighbours = num_neighbours;
    const std::vector<bool> stays = VoteOnDistances(markers, options);
    int wrongly_kept = 0, wrongly_lost = 0, off = 0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
      off += is_off[i] ? 1 : 0;
      wrongly_kept += stays[i] && is_off[i] ? 1 : 0;
      wrongly_lost += !stays[i] && !is_off[i] ? 1 : 0;
    }
    if (num_neighbours == 0) {
      EXPECT_GT(wrongly_kept, off / 8);  // the whole cloth says too little
    } else {
      EXPECT_LE(wrongly_kept, off / 20);
    }
    EXPECT_LE(wrongly_lost, 9);  // 1 %
  }
}

TEST(Vote, ThrowsOutWhatIsTooFarApart) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (const double share : {0.05, 0.2, 0.4}) {
    // A cloth folded in the middle: distances in the world are never longer than on the cloth.
    std::vector<TrackedMarker> markers;
    std::vector<bool> is_outlier;
    for (int i = 0; i < 200; ++i) {
      TrackedMarker m;
      m.uv = {1.4 * chance(random), 1.4 * chance(random)};
      m.position = {m.uv.x() < 0.7 ? m.uv.x() : 1.4 - m.uv.x(), m.uv.y(),
                    m.uv.x() < 0.7 ? 0.0 : 0.05};
      const bool outlier = chance(random) < share;
      // Anywhere in the room.
      if (outlier)
        m.position = {6 * chance(random) - 3, 6 * chance(random) - 3, 2 * chance(random)};
      markers.push_back(m);
      is_outlier.push_back(outlier);
    }
    const std::vector<bool> stays = VoteOnDistances(markers, {});
    int wrongly_kept = 0, wrongly_lost = 0, kept = 0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
      kept += stays[i] ? 1 : 0;
      wrongly_kept += stays[i] && is_outlier[i] ? 1 : 0;
      wrongly_lost += !stays[i] && !is_outlier[i] ? 1 : 0;
    }
    EXPECT_LE(wrongly_kept, 0.05 * kept) << share;  // some land where the cloth might be
    EXPECT_LE(wrongly_lost, 2) << share;
  }
}

TEST(Vote, KeepsAllOfACorrectSet) {
  std::vector<TrackedMarker> markers;
  for (int i = 0; i < 30; ++i) {
    TrackedMarker m;
    m.uv = {0.05 * i, 0.02 * (i % 7)};
    m.position = {1.04 * m.uv.x(), 1.04 * m.uv.y(), 0.0};  // stretched, within what is allowed
    markers.push_back(m);
  }
  for (const bool stays : VoteOnDistances(markers, {})) EXPECT_TRUE(stays);
  EXPECT_TRUE(VoteOnDistances({}, {}).empty());
}

// OpenCV's SIFT takes the place in the doubled picture for twice that in the picture.
TEST(DetectFeatures, HasNoBiasByDoubling) {
  double sum_x = 0.0, sum_y = 0.0;
  int count = 0;
  for (int i = 0; i < 8; ++i) {
    const double x = 60.0 + 0.125 * i, y = 50.0 + 0.25 * i;
    cv::Mat image(110, 120, CV_8UC3);
    for (int r = 0; r < image.rows; ++r) {
      for (int c = 0; c < image.cols; ++c) {
        const double d2 = (c - x) * (c - x) + (r - y) * (r - y);
        image.at<cv::Vec3b>(r, c) = cv::Vec3b::all(
            cv::saturate_cast<uchar>(60.0 + 150.0 * std::exp(-d2 / (2.0 * 4.0 * 4.0))));
      }
    }
    const Features found = DetectFeatures(image, {});
    for (const Eigen::Vector2d& p : found.pixels) {
      if ((p - Eigen::Vector2d(x, y)).norm() > 2.0) continue;
      sum_x += p.x() - x;
      sum_y += p.y() - y;
      ++count;
    }
  }
  ASSERT_GE(count, 6);
  EXPECT_NEAR(sum_x / count, 0.0, 0.1);
  EXPECT_NEAR(sum_y / count, 0.0, 0.1);
}

TEST(ClothCoordinates, AreThoseOfTheFirstSurfaceSeen) {
  const FlatScene scene;
  const Camera camera = LookAt({0.4, -0.4, 1.0}, {0.4, 0.3, 0.0});
  const FlatPlacement lies = FlatScene::Placement({0.0, 0.0, 0.0});
  const ClothCoordinates flat(scene.Place(lies));
  const Eigen::Vector2d uv(0.31, 0.22);
  const Eigen::Vector2d pixel = scene.Project(camera, lies, uv);
  EXPECT_LT((*flat.At(camera, pixel) - uv).norm(), 1e-9);
  EXPECT_FALSE(flat.At(camera, scene.Project(camera, lies, {0.9, 0.2})).has_value());
  // Folded: the half u > 0.4 lies 5 cm above the other. What is below cannot be seen.
  PlacedCloth folded = scene.Place(lies);
  for (int i = 0; i < folded.mesh.num_particles(); ++i) {
    const Eigen::Vector2d at = folded.mesh.uv[i];
    if (at.x() > 0.4) folded.x.segment<3>(3 * i) = Eigen::Vector3d(0.8 - at.x(), at.y(), 0.05);
  }
  const Eigen::Vector2d seen =
      *ClothCoordinates(folded).At(camera, ProjectPoint(camera, Eigen::Vector3d(0.2, 0.3, 0.05)));
  EXPECT_NEAR(seen.x(), 0.6, 1e-6);
  EXPECT_NEAR(seen.y(), 0.3, 1e-6);
}

}  // namespace
}  // namespace clothfit
