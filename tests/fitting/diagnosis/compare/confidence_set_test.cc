// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/confidence_set.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

using Names = std::vector<std::string>;

FittedModel Costing(const char* name, double cost, bool is_fault = false) {
  FittedModel model;
  model.candidate.summary.name = name;
  model.scene.fit.cost_after = cost;
  if (is_fault) model.candidate.faults = {0};
  return model;
}

// Of a fit that costs 1000, of which the null leaves 100.
Ranking Ranked() {
  Ranking ranking;
  ranking.null_mean = 200.0;
  ranking.num_rows = 200;
  ranking.discretisation_rms = 0.5;
  return ranking;
}

TEST(ConfidenceSet, IsOfWhatFitsAboutAsWell) {
  // The best leaves 20 above the null and the mesh makes 25: up to 90 more is as good.
  const std::vector<FittedModel> models = {Costing("gravity_tilt", 200.0), Costing("wind", 120.0),
                                           Costing("gust", 215.0)};
  const ConfidenceSet confidence_set = FindConfidenceSet(Ranked(), models, 1, 1000.0);
  EXPECT_EQ(confidence_set.names, (Names{"wind", "gravity_tilt"}));
  ASSERT_EQ(confidence_set.fitted.size(), 2u);
  EXPECT_EQ(confidence_set.fitted[0], &models[1].scene);
  EXPECT_EQ(confidence_set.fitted[1], &models[0].scene);
}

TEST(ConfidenceSet, OfAPoorFitIsATenthOfWhatItGains) {
  const std::vector<FittedModel> models = {Costing("gust", 600.0), Costing("wind", 630.0),
                                           Costing("attractor", 650.0)};
  EXPECT_EQ(FindConfidenceSet(Ranked(), models, 0, 1000.0).names, (Names{"gust", "wind"}));
}

TEST(ConfidenceSet, OfAFaultHasNoMotionToTellItApart) {
  const std::vector<FittedModel> models = {Costing("camera cam0: pose", 120.0, true),
                                           Costing("wind", 125.0)};
  const ConfidenceSet confidence_set = FindConfidenceSet(Ranked(), models, 0, 1000.0);
  EXPECT_EQ(confidence_set.names, (Names{"camera cam0: pose", "wind"}));
  EXPECT_TRUE(confidence_set.fitted.empty());
  const ConfidenceSet of_wind = FindConfidenceSet(Ranked(), models, 1, 1000.0);
  EXPECT_EQ(of_wind.names, (Names{"wind", "camera cam0: pose"}));
  EXPECT_EQ(of_wind.fitted.size(), 1u);
}

}  // namespace
}  // namespace clothfit
