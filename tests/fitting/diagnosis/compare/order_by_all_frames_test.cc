// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/order_by_all_frames.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::ElementsAre;
using testing::Pair;

JudgedModel Judged(const std::string& name, double log_evidence) {
  JudgedModel model;
  model.candidate.summary.name = name;
  model.log_evidence = log_evidence;
  return model;
}

std::vector<std::pair<std::string, double>> Order(const std::vector<JudgedModel>& models) {
  std::vector<std::pair<std::string, double>> order;
  for (const JudgedModel& one : models)
    order.emplace_back(one.candidate.summary.name, one.log_evidence);
  return order;
}

std::vector<JudgedModel> Forecasts() {
  return {Judged("gravity_tilt", 100.0), Judged("wind", 60.0), Judged("hem", 20.0)};
}

std::vector<JudgedModel> AllFrames() {
  return {Judged("wind", 900.0), Judged("gravity_tilt", 700.0)};
}

TEST(OrderByAllFrames, IsTheirsWhereTheyMayDecide) {
  std::vector<JudgedModel> forecasts = Forecasts();
  OrderByAllFrames(AllFrames(), true, &forecasts);
  EXPECT_THAT(Order(forecasts),
              ElementsAre(Pair("wind", 900.0), Pair("gravity_tilt", 700.0), Pair("hem", 620.0)));
}

TEST(OrderByAllFrames, LeavesTwoThatContradictEachOtherAlike) {
  std::vector<JudgedModel> forecasts = Forecasts();
  OrderByAllFrames(AllFrames(), false, &forecasts);
  EXPECT_THAT(Order(forecasts),
              ElementsAre(Pair("gravity_tilt", 100.0), Pair("wind", 100.0), Pair("hem", 20.0)));
}

// Wind is a little behind a tilt in one, and far in the other.
TEST(OrderByAllFrames, LeavesWhatEitherCannotTellFromTheBest) {
  std::vector<JudgedModel> forecasts = Forecasts();
  OrderByAllFrames({Judged("gravity_tilt", 700.0), Judged("wind", 698.0)}, false, &forecasts);
  EXPECT_THAT(Order(forecasts),
              ElementsAre(Pair("gravity_tilt", 100.0), Pair("wind", 98.0), Pair("hem", 20.0)));
}

TEST(OrderByAllFrames, IsThatOfForecastsWhereBothPreferTheSame) {
  std::vector<JudgedModel> forecasts = Forecasts();
  OrderByAllFrames({Judged("gravity_tilt", 700.0), Judged("wind", 600.0)}, false, &forecasts);
  EXPECT_EQ(Order(forecasts), Order(Forecasts()));
  OrderByAllFrames({Judged("wind", 700.0)}, true, &forecasts);  // the best was not fitted
  EXPECT_EQ(Order(forecasts), Order(Forecasts()));
}

}  // namespace
}  // namespace clothfit
