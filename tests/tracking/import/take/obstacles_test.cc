// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take/obstacles.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"
#include "tracking/import/markers/rigid_body.h"

namespace clothfit {
namespace {

using testing::HasSubstr;
using Places = std::vector<Eigen::Vector3d>;

// Pairs of markers on opposite sides at the ends of a bar of 20 mm radius along y.
const Places kBar = {{-0.02, 0.0, 1.0}, {0.02, 0.0, 1.0}, {-0.02, 0.7, 1.0}, {0.02, 0.7, 1.0}};
const Places kTable = {{0.0, 0.0, 0.5}, {0.8, 0.0, 0.5}, {0.8, 0.6, 0.501}, {0.0, 0.6, 0.499}};

constexpr int kFrames = 10;

// `motion` of the frame's number moves the markers.
template <class Motion>
MarkerTake TakeWith(const Places& points, Motion motion) {
  MarkerTake take;
  take.file = "take.csv";
  take.frame_rate = 100.0;
  RigidBody body{"Thing", {}};
  for (size_t i = 0; i < points.size(); ++i) {
    MarkerPath path{"Thing:" + std::to_string(i), {}};
    for (int frame = 0; frame < kFrames; ++frame) {
      path.positions.emplace_back(motion(frame) * points[i]);
    }
    body.markers.push_back(path);
  }
  take.bodies = {body};
  return take;
}

Eigen::Isometry3d AtRest(int /*frame*/) { return Eigen::Isometry3d::Identity(); }

ObstacleDescription ObstacleOf(const MarkerTake& take,
                               const std::vector<std::string>& choices = {}) {
  std::vector<std::string> notes;
  const std::vector<ObstacleDescription> obstacles = MakeObstacles(take, choices, &notes);
  EXPECT_EQ(obstacles.size(), 1u);
  EXPECT_EQ(notes.size(), 1u);
  return obstacles.front();
}

Eigen::Isometry3d PoseOf(const ObstacleDescription::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  const double angle = pose.rotation.norm();
  if (angle > 0.0) result.rotate(Eigen::AngleAxisd(angle, pose.rotation / angle));
  result.pretranslate(pose.position);
  return result;
}

TEST(TakeObstacles, ABarLiesAlongItsMarkers) {
  const ObstacleDescription obstacle = ObstacleOf(TakeWith(kBar, AtRest));
  EXPECT_EQ(obstacle.name, "Thing");
  ASSERT_EQ(obstacle.path.size(), 1u);
  const auto& bar = std::get<BarShape>(obstacle.shape);
  EXPECT_NEAR(bar.radius, 0.02, 1e-5);
  EXPECT_NEAR(bar.length, 0.7, 1e-5);
  const Eigen::Isometry3d pose = PoseOf(obstacle.path[0]);
  EXPECT_LT((pose.translation() - Eigen::Vector3d(0.0, 0.35, 1.0)).norm(), 1e-9);
  EXPECT_NEAR(std::abs(pose.linear().col(2).y()), 1.0, 1e-9);
}

TEST(TakeObstacles, ATableLiesBelowItsMarkers) {
  const ObstacleDescription obstacle = ObstacleOf(TakeWith(kTable, AtRest));
  const auto& box = std::get<BoxShape>(obstacle.shape);
  EXPECT_NEAR(box.size.x(), 0.8, 2e-3);
  EXPECT_NEAR(box.size.y(), 0.6, 2e-3);
  EXPECT_EQ(box.size.z(), 0.02);
  EXPECT_EQ(box.below, 0.5);
  const Eigen::Isometry3d pose = PoseOf(obstacle.path[0]);
  EXPECT_GT(pose.linear()(2, 2), 0.99);
  EXPECT_NEAR(pose.translation().z(), 0.49, 2e-3);
}

TEST(TakeObstacles, AreWhatTheUserSays) {
  const auto bar = ObstacleOf(TakeWith(kTable, AtRest), {"Thing=capsule:radius=0.3,length=1"});
  EXPECT_EQ(std::get<BarShape>(bar.shape).radius, 0.3);
  EXPECT_EQ(std::get<BarShape>(bar.shape).length, 1.0);
  const auto box =
      ObstacleOf(TakeWith(kTable, AtRest), {"Thing=box:thickness=0.1,margin=0.05,below=0"});
  EXPECT_NEAR(std::get<BoxShape>(box.shape).size.x(), 0.9, 2e-3);
  EXPECT_EQ(std::get<BoxShape>(box.shape).below, 0.0);
  EXPECT_NEAR(PoseOf(box.path[0]).translation().z(), 0.45, 2e-3);
  std::vector<std::string> notes;
  EXPECT_TRUE(MakeObstacles(TakeWith(kTable, AtRest), {"Thing=none"}, &notes).empty());
}

TEST(TakeObstacles, MoveAsTheirMarkersDo) {
  const auto motion = [](int frame) {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.rotate(Eigen::AngleAxisd(0.1 * frame, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()));
    result.pretranslate(Eigen::Vector3d(0.05 * frame, 0.0, 0.0));
    return result;
  };
  MarkerTake take = TakeWith(kBar, motion);
  const ObstacleDescription obstacle = ObstacleOf(take);
  ASSERT_EQ(obstacle.path.size(), size_t{kFrames});
  const Eigen::Isometry3d first = PoseOf(obstacle.path[0]);
  for (int frame = 0; frame < kFrames; ++frame) {
    const Eigen::Isometry3d expected = motion(frame) * first;
    EXPECT_LT((PoseOf(obstacle.path[size_t(frame)]).matrix() - expected.matrix()).norm(), 1e-9);
  }
  for (MarkerPath& marker : take.bodies[0].markers) marker.positions[4].reset();
  const RigidMotion lost = FindRigidMotion(take.bodies[0]);
  EXPECT_EQ(lost.num_lost, 1);
  EXPECT_EQ(lost.path[4].matrix(), lost.path[3].matrix());
}

TEST(TakeObstacles, WrongChoicesAreRefused) {
  const MarkerTake take = TakeWith(kBar, AtRest);
  const auto error = [&](const std::string& choice) {
    return InputErrorOf([&] {
      std::vector<std::string> notes;
      MakeObstacles(take, {choice}, &notes);
    });
  };
  EXPECT_THAT(error("Thin=none"), HasSubstr("has no rigid body 'Thin'; did you mean 'Thing'?"));
  EXPECT_THAT(error("Thing"), HasSubstr("expected NAME=capsule, NAME=box or NAME=none"));
  EXPECT_THAT(error("Thing=ball"), HasSubstr("expected capsule, box or none, found 'ball'"));
  EXPECT_THAT(error("Thing=capsule:size=3"), HasSubstr("found 'size'"));
  EXPECT_THAT(error("Thing=capsule:radius=-3"),
              HasSubstr("radius: expected metres above 0, found '-3'"));
  EXPECT_THAT(error("Thing=capsule:radius"), HasSubstr("radius: expected metres above 0"));
}

TEST(TakeObstacles, ABodyNeedsThreeMarkers) {
  MarkerTake take = TakeWith({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, AtRest);
  std::vector<std::string> notes;
  EXPECT_TRUE(MakeObstacles(take, {}, &notes).empty());
  EXPECT_THAT(notes.at(0), HasSubstr("rigid body Thing: no obstacle, since it has 2 markers"));
  EXPECT_THAT(InputErrorOf([&] { MakeObstacles(take, {"Thing=box"}, &notes); }),
              HasSubstr("expected three markers of 'Thing' or more, found 2"));
}

TEST(TakeOutBodies, TakesPrefixesThatKeepTheirDistances) {
  MarkerTake take = TakeWith(kBar, AtRest);
  take.markers = take.bodies[0].markers;
  take.bodies.clear();
  for (const std::string name : {"Cloth:a", "Cloth:b", "Cloth:c", "alone"}) {
    MarkerPath path{name, {}};
    for (int frame = 0; frame < kFrames; ++frame) {
      path.positions.emplace_back(Eigen::Vector3d(0.1 * frame * double(name.back()), 0.0, 0.0));
    }
    take.markers.push_back(path);
  }
  take.markers.back().positions = take.markers.front().positions;
  TakeOutBodies({}, {}, &take);
  ASSERT_EQ(take.bodies.size(), 1u);
  EXPECT_EQ(take.bodies[0].name, "Thing");
  EXPECT_EQ(take.bodies[0].markers.size(), 4u);
  EXPECT_EQ(NamesOf(take), (std::vector<std::string>{"Cloth:a", "Cloth:b", "Cloth:c", "alone"}));
}

}  // namespace
}  // namespace clothfit
