// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Models that are alike in one motion, and what tells them apart.
#include "fitting/diagnosis/compare/separating_motion.h"

#include <map>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/contact/obstacle_body.h"
#include "tests/support/unfitted_scene.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

class SeparatingMotionTest : public testing::Test {
 protected:
  FittedScene With(const std::map<std::string, double>& values) const {
    return UnfittedScene(recording_, values);
  }

  static Recording Hanging() {
    SyntheticOptions options;
    options.resolution = {6, 6};
    options.frame_rate = 30.0;
    options.frame_count = 30;
    options.steps_per_frame = 4;
    return MakeSyntheticRecording(options).recording;
  }
  Recording recording_ = Hanging();
};

// How drag saturates shows at speed.
TEST_F(SeparatingMotionTest, DragShowsWhereTheClothMoves) {
  const FittedScene one = With({{"air_drag.saturation", 0.1}}),
                    two = With({{"air_drag.saturation", 0.5}});
  const auto found = FindSeparatingMotion({&one, &two});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->motion, "twice as fast");
  EXPECT_GT(found->apart_here, 0.0);
  EXPECT_GT(found->apart, found->apart_here);
}

TEST_F(SeparatingMotionTest, ThePlaceThatTheClothDoesNotReachShowsWhereItDoes) {
  // Beside the hanging cloth, where its edge is once it has been turned about its middle.
  const FittedScene nothing = With({});
  const Eigen::Map<const Eigen::Matrix3Xd> x(nothing.scene.initial.data(), 3,
                                             nothing.scene.initial.size() / 3);
  const Eigen::Vector3d middle = x.rowwise().mean();
  const double half = 0.5 * (x.row(0).maxCoeff() - x.row(0).minCoeff());
  ASSERT_GT(half, 5.0 * (x.row(1).maxCoeff() - x.row(1).minCoeff()));
  const FittedScene sticky = With({{"attractor.stiffness", 20.0},
                                   {"attractor.range", 0.05},
                                   {"attractor.x", middle.x()},
                                   {"attractor.y", middle.y() + half + 0.05},
                                   {"attractor.z", middle.z()}});
  const auto found = FindSeparatingMotion({&nothing, &sticky});
  ASSERT_TRUE(found.has_value());
  EXPECT_THAT(found->motion, HasSubstr("turned by 90 degrees"));
  EXPECT_GT(found->apart, 1.5 * found->apart_here);
  EXPECT_THAT(Describe(*found), HasSubstr("turned by 90 degrees about the vertical would"));
}

TEST_F(SeparatingMotionTest, TheNearestOfSeveralDecides) {
  const FittedScene one = With({{"air_drag.normal", 0.6}}), two = With({{"air_drag.normal", 0.9}});
  const FittedScene far = With({{"wind.y", 3.0}});
  const auto two_models = FindSeparatingMotion({&one, &two}),
             three_models = FindSeparatingMotion({&one, &far, &two});
  ASSERT_TRUE(two_models && three_models);
  EXPECT_EQ(three_models->apart, two_models->apart);
}

TEST_F(SeparatingMotionTest, EqualModelsArePartedByNothing) {
  const FittedScene one = With({}), same = With({});
  const auto found = FindSeparatingMotion({&one, &same});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->apart, 0.0);
  EXPECT_EQ(found->apart_here, 0.0);
  EXPECT_FALSE(FindSeparatingMotion({&one}).has_value());
}

TEST_F(SeparatingMotionTest, NothingIsTurnedIntoAnObstacle) {
  FittedScene wind = With({{"wind.y", 0.8}}), tilt = With({{"gravity_tilt.angle_1", 0.06}});
  const auto ball = std::make_shared<Obstacle>(MakeBall(0.1));
  ball->path[0].origin_in_world = {9.0, 9.0, 9.0};  // in nobody's way, which nobody looks at
  for (FittedScene* model : {&wind, &tilt}) model->scene.world.obstacles = {ball};
  const auto found = FindSeparatingMotion({&wind, &tilt});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->motion.find("turned"), std::string::npos);
}

}  // namespace
}  // namespace clothfit
