// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes of a laboratory, imported without any option: the right markers, handles and obstacle.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "tracking/import/markers/rigid_body.h"
#include "tracking/import/take/file.h"
#include "tracking/import/take/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

fs::path TakesFolder() {
  return fs::path(CLOTHFIT_SOURCE_DIR).parent_path() / "shared" / "real" / "takes";
}

// The body's markers, with z up.
std::vector<Eigen::Vector3d> BodyOf(const YAML::Node& known) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& marker : known["body"]) {
    const auto place = marker.second.as<std::vector<double>>();
    points.emplace_back(place[0], -place[2], place[1]);
  }
  return points;
}

Eigen::Isometry3d RestingPose(const ObstacleDescription& obstacle) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d& rotation = obstacle.path[0].rotation;
  if (rotation.norm() > 0.0) {
    pose.rotate(Eigen::AngleAxisd(rotation.norm(), rotation.normalized()));
  }
  pose.pretranslate(obstacle.path[0].position);
  return pose;
}

constexpr double kNear = 0.005;  // m

// Pairs of markers stand on opposite sides of the bar's ends, which have round caps.
void ExpectBarAt(const std::vector<Eigen::Vector3d>& markers, const ObstacleDescription& obstacle) {
  const auto& bar = std::get<BarShape>(obstacle.shape);
  const Eigen::Isometry3d pose = RestingPose(obstacle);
  for (const Eigen::Vector3d& marker : markers) {
    const Eigen::Vector3d local = pose.inverse() * marker;
    EXPECT_NEAR(local.head<2>().norm(), bar.radius, kNear);
    EXPECT_NEAR(std::abs(local.z()), 0.5 * bar.length, kNear);
  }
}

void ExpectTableBelow(const std::vector<Eigen::Vector3d>& markers,
                      const ObstacleDescription& obstacle) {
  const auto& box = std::get<BoxShape>(obstacle.shape);
  const Eigen::Isometry3d pose = RestingPose(obstacle);
  EXPECT_GT(pose.linear()(2, 2), 0.99);
  EXPECT_GT(box.below, 0.0);
  for (const Eigen::Vector3d& marker : markers) {
    const Eigen::Vector3d local = pose.inverse() * marker;
    EXPECT_NEAR(local.z(), 0.5 * box.size.z(), kNear);
    EXPECT_NEAR(std::abs(local.x()), 0.5 * box.size.x(), 2 * kNear);
    EXPECT_NEAR(std::abs(local.y()), 0.5 * box.size.y(), 2 * kNear);
  }
}

void CheckTake(const YAML::Node& known) {
  const std::string name = known["take"].as<std::string>();
  SCOPED_TRACE(name);
  std::vector<std::string> notes;
  const ImportedTake take =
      MakeTakeRecording(ReadTake(TakesFolder() / name, {}, &notes), TakeOptions());
  // Ten markers on each cloth. In this take one is away from its place for a while.
  const size_t expected = name == "textured_hang/textured_hang_exp_4.csv" ? 9 : 10;
  EXPECT_EQ(take.uv.size(), expected);
  std::set<std::string> handles;
  for (const HandleDescription& handle : take.recording.handles) handles.insert(handle.name);
  const auto held = known["held"].as<std::vector<std::string>>();
  EXPECT_EQ(handles, std::set<std::string>(held.begin(), held.end()));
  ASSERT_EQ(take.recording.obstacles.size(), 1u);
  const ObstacleDescription& obstacle = take.recording.obstacles[0];
  ASSERT_EQ(obstacle.path.size(), 1u);
  if (obstacle.name == "Bar") {
    ExpectBarAt(BodyOf(known), obstacle);
  } else {
    ExpectTableBelow(BodyOf(known), obstacle);
  }
  EXPECT_LT(*take.recording.noise.marker, 0.004);   // m
  EXPECT_EQ(take.recording.noise.obstacles, 0.01);  // m
}

class RealTakes : public testing::TestWithParam<const char*> {};

TEST_P(RealTakes, AreImportedWithoutAnOption) {
  const fs::path file = TakesFolder() / "known.yaml";
  if (!fs::exists(file)) GTEST_SKIP() << "there is no " << file;
  int count = 0;
  for (const auto& known : YAML::LoadFile(file.string())) {
    if (!StartsWith(known["take"].as<std::string>(), GetParam())) continue;
    CheckTake(known);
    ++count;
  }
  EXPECT_GE(count, 5);
}

INSTANTIATE_TEST_SUITE_P(Sets, RealTakes,
                         testing::Values("cotton_hang", "leather_hang", "leather_table",
                                         "silk_hang", "silk_table", "textured_hang",
                                         "textured_table"),
                         [](const testing::TestParamInfo<const char*>& set) {
                           return std::string(set.param);
                         });

}  // namespace
}  // namespace clothfit
