// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where attraction targets are between the frames.
#include <algorithm>

#include <gtest/gtest.h>

#include "fitting/rollout/attraction_targets.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

constexpr int kCourseFrames = 10;

SyntheticOptions Swinging() {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_count = kCourseFrames;
  options.frame_rate = 24.0;
  options.steps_per_frame = 5;
  options.held_out_share = 0.0;
  options.markers = {3, 3};
  return options;
}

Scene SceneOf(const Recording& recording, int every = 1) {
  FitConfig config = DefaultConfig(recording);
  config.attract = true;  // gives tracks their rays
  config.every = every;
  return MakeScene(recording, config);
}

Recording SeenByMarkersAndTracks() {
  SyntheticOptions options = Swinging();
  options.num_cameras = 2;
  options.tracks = true;
  return MakeSyntheticRecording(options).recording;
}

TEST(AttractionCourses, PassThroughWhatWasSeen) {
  const Scene scene = SceneOf(SeenByMarkersAndTracks());
  const AttractionCourses courses(scene);
  for (int frame = 1; frame < kCourseFrames; ++frame) {
    StepInputs at_frame, on_course;
    AddAttractionTargets(scene, frame, &at_frame);
    courses.AddTargets(scene.FrameTime(frame), &on_course);
    ASSERT_EQ(on_course.points.size(), at_frame.points.size());
    ASSERT_EQ(on_course.rays.size(), at_frame.rays.size());
    ASSERT_FALSE(at_frame.points.empty());
    ASSERT_FALSE(at_frame.rays.empty());
    for (const PointTarget& point : at_frame.points) {
      EXPECT_TRUE(std::any_of(on_course.points.begin(), on_course.points.end(), [&](const auto& p) {
        return (p.position - point.position).norm() < 1e-12;
      }));
    }
    for (const RayTarget& ray : at_frame.rays) {
      EXPECT_TRUE(std::any_of(on_course.rays.begin(), on_course.rays.end(), [&](const auto& r) {
        return (r.direction - ray.direction).norm() + (r.moment - ray.moment).norm() < 1e-12;
      }));
    }
  }
}

TEST(AttractionCourses, MoveAtTheirRates) {
  const Scene scene = SceneOf(SeenByMarkersAndTracks());
  const AttractionCourses courses(scene);
  constexpr double kStep = 1e-5;  // s
  for (const double share : {0.2, 0.7}) {
    for (int frame = 1; frame < kCourseFrames; ++frame) {
      const double time = scene.FrameTime(frame - 1) + share / scene.recording.frame_rate;
      StepInputs before, now, after;
      courses.AddTargets(time - kStep, &before);
      courses.AddTargets(time, &now);
      courses.AddTargets(time + kStep, &after);
      double fastest = 0.0;
      for (std::size_t i = 0; i < now.points.size(); ++i) {
        ASSERT_TRUE(now.points[i].velocity);
        const Eigen::Vector3d moved = after.points[i].position - before.points[i].position;
        EXPECT_LT((moved / (2.0 * kStep) - *now.points[i].velocity).norm(), 1e-6);
        fastest = std::max(fastest, now.points[i].velocity->norm());
      }
      EXPECT_GT(fastest, 1e-3);
      for (std::size_t i = 0; i < now.rays.size(); ++i) {
        ASSERT_TRUE(now.rays[i].rates);
        const RayTarget &first = before.rays[i], &last = after.rays[i];
        const Eigen::Vector3d turned = last.direction - first.direction;
        const Eigen::Vector3d moved = last.moment - first.moment;
        EXPECT_LT((turned / (2.0 * kStep) - now.rays[i].rates->direction).norm(), 1e-6);
        EXPECT_LT((moved / (2.0 * kStep) - now.rays[i].rates->moment).norm(), 1e-6);
        EXPECT_NEAR(now.rays[i].direction.norm(), 1.0, 1e-12);
      }
    }
  }
}

// Where every second frame is fitted, the targets of those between are near what was seen there,
// and go on evenly from piece to piece.
TEST(AttractionCourses, LeadThroughFramesThatAreLeftOut) {
  const Recording recording = SeenByMarkersAndTracks();
  const Scene all = SceneOf(recording), thinned = SceneOf(recording, 2);
  const AttractionCourses courses(thinned);
  constexpr double kStep = 1e-5;  // s
  for (int frame = 1; frame <= thinned.last_fitted_frame; ++frame) {
    StepInputs seen, before, now, after;
    AddAttractionTargets(all, frame, &seen);
    const double time = all.FrameTime(frame);
    courses.AddTargets(time - kStep, &before);
    courses.AddTargets(time, &now);
    ASSERT_EQ(now.points.size(), seen.points.size());
    ASSERT_EQ(now.rays.size(), seen.rays.size());
    for (const PointTarget& point : seen.points) {
      EXPECT_TRUE(std::any_of(now.points.begin(), now.points.end(), [&](const auto& p) {
        return (p.position - point.position).norm() < (frame % 2 == 0 ? 1e-12 : 0.02);
      }));
    }
    if (frame == thinned.last_fitted_frame) continue;
    courses.AddTargets(time + kStep, &after);
    for (std::size_t i = 0; i < now.points.size(); ++i) {
      const Eigen::Vector3d moved = after.points[i].position - before.points[i].position;
      EXPECT_LT((moved / (2.0 * kStep) - now.points[i].velocity.value()).norm(), 1e-3);
    }
  }
}

// Between frames, too, a ray is one that the camera sees.
TEST(AttractionCourses, RaysGoThroughTheCamera) {
  const Scene scene = SceneOf(SeenByMarkersAndTracks());
  StepInputs inputs;
  AttractionCourses(scene).AddTargets(scene.FrameTime(3) + 0.3 / scene.recording.frame_rate,
                                      &inputs);
  ASSERT_FALSE(inputs.rays.empty());
  for (const RayTarget& ray : inputs.rays) {
    double nearest = 1.0;
    for (const Camera& camera : scene.recording.cameras) {
      const Eigen::Vector3d centre = CameraCentre(camera);
      nearest = std::min(nearest, (ray.moment - centre.cross(ray.direction)).norm());
    }
    EXPECT_LT(nearest, 1e-12);
  }
}

TEST(AttractionCourses, StandStillWhereNothingWasSeenBefore) {
  Recording recording = MakeSyntheticRecording(Swinging()).recording;
  const int missing = 4;
  auto& markers = recording.markers;
  markers.erase(std::remove_if(markers.begin(), markers.end(),
                               [&](const Marker& m) { return m.frame == missing && m.id == 0; }),
                markers.end());
  const Scene scene = SceneOf(recording);
  const AttractionCourses courses(scene);
  const auto between = [&](int frame) {
    StepInputs inputs;
    courses.AddTargets(scene.FrameTime(frame) - 0.4 / scene.recording.frame_rate, &inputs);
    return inputs.points;
  };
  EXPECT_EQ(between(missing - 1).size(), 9u);
  EXPECT_EQ(between(missing).size(), 8u);
  const std::vector<PointTarget> next = between(missing + 1);
  ASSERT_EQ(next.size(), 9u);
  EXPECT_EQ(std::count_if(next.begin(), next.end(), [](const auto& p) { return !p.velocity; }), 1);
}

}  // namespace
}  // namespace clothfit
