// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::HasSubstr;

// A cloth of 0.4 x 0.4 m, flat at a height of 1 m about x = y = 0, in the air.
Recording FallingCloth() {
  Recording recording;
  recording.cloth.size = {0.4, 0.4};
  recording.cloth.resolution = {5, 5};
  recording.cloth.initial = FlatPlacement{{-0.2, -0.2, 1.0}, {1, 0, 0}, {0, 1, 0}};
  return recording;
}

ObstacleDescription Ball(const Eigen::Vector3d& position) {
  return {"ball", BallShape{0.1}, {{position, Eigen::Vector3d::Zero()}}};
}

TEST(LackOfSupport, IsOfClothWithoutHandleAndGround) {
  EXPECT_THAT(DescribeLackOfSupport(FallingCloth()), HasSubstr("it falls freely"));
  Recording on_ground = FallingCloth();
  on_ground.ground_height = 0.0;
  EXPECT_THAT(DescribeLackOfSupport(on_ground), HasSubstr("nothing moves it but its fall"));
  Recording held = FallingCloth();
  held.handles.emplace_back();
  EXPECT_EQ(DescribeLackOfSupport(held), "");
}

TEST(LackOfSupport, KnowsAnObstacleThatMayCatchIt) {
  int checked = 0;
  const auto expect = [&](const ObstacleDescription& obstacle, bool may_catch) {
    Recording recording = FallingCloth();
    recording.obstacles = {obstacle};
    EXPECT_EQ(DescribeLackOfSupport(recording).empty(), may_catch) << checked;
    ++checked;
  };
  expect(Ball({0, 0, 0.2}), true);
  expect(Ball({0.3, 0, 0.2}), true);  // under an edge
  expect(Ball({0.5, 0, 0.2}), false);
  expect(Ball({0, 0, 1.6}), false);  // above
  ObstacleDescription moving = Ball({0.5, 0, 0.2});
  moving.path.resize(2);
  expect(moving, true);
  expect({"bar", BarShape{0.02, 0.6}, {{{0.5, 0, 0.2}, {0, 1.57, 0}}}}, true);
  expect({"bar", BarShape{0.02, 0.3}, {{{0.5, 0, 0.2}, {0, 1.57, 0}}}}, false);
  expect({"box", BoxShape{{0.4, 0.4, 0.1}}, {{{0.5, 0, 0.2}, {0, 0, 0}}}}, true);
  expect({"box", BoxShape{{0.1, 0.1, 0.1}}, {{{0.5, 0, 0.2}, {0, 0, 0}}}}, false);
  expect({"bust", MeshShape{"bust.obj"}, {{{0.5, 0, 0.2}, {0, 0, 0}}}}, true);
  EXPECT_EQ(checked, 10);
  Recording mesh = FallingCloth();
  mesh.cloth.initial = MeshPlacement{"cloth.obj"};
  EXPECT_THAT(DescribeLackOfSupport(mesh), HasSubstr("it falls freely"));
  mesh.obstacles = {Ball({0.5, 0, 0.2})};
  EXPECT_EQ(DescribeLackOfSupport(mesh), "");
}

}  // namespace
}  // namespace clothfit
