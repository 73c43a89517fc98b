// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/screening.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

constexpr double kAddedMass = 0.15;  // kg/m^2, as much as the cloth itself

RankedCandidate ShortListed(const char* term, const char* parameter, double amount) {
  RankedCandidate candidate;
  candidate.summary.name = candidate.term.name = candidate.term.term = term;
  candidate.summary.is_short_listed = true;
  candidate.names = {parameter};
  candidate.amounts = Eigen::VectorXd::Constant(1, amount);
  return candidate;
}

// A cloth that takes air along, and what a fit without that makes of it.
class Race : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recording recording =
        MakeSmallRecording({5, 30, 0.001, {{"added_mass.normal", kAddedMass}}});
    told_ = DefaultConfig(recording);
    for (auto& [name, setting] : told_.parameters) setting.free = false;
    for (const char* name : {"stretch.stiffness", "bending.stiffness", "air_drag.normal"})
      told_.parameters.at(name).free = true;
    current_ = FitAfresh({recording, told_}, Start::kPlain, 10, FitRunner());
    ASSERT_TRUE(current_);
    ranking_.candidates = {ShortListed("added_mass", "added_mass.normal", 0.02)};
    ranking_.residual_rms = 1.5;
  }

  static RankedCandidate Tilt() {
    return ShortListed("gravity_tilt", "gravity_tilt.angle_1", 0.001);
  }

  static std::vector<FittedModel> Run(const std::vector<RankedCandidate>& candidates,
                                      double null_mean, const DiagnosisOptions& options) {
    Ranking ranking = ranking_;
    ranking.candidates = candidates;
    ranking.null_mean = null_mean;
    return ModelScreening(told_, options).Run(*current_, ranking);
  }

  static inline FitConfig told_;
  static inline std::optional<FittedScene> current_;
  static inline Ranking ranking_;
};

TEST_F(Race, FindsTheAmountFromAMaterialThatHadToStandForIt) {
  const std::vector<FittedModel> models = Run(ranking_.candidates, 0.0, {});
  ASSERT_EQ(models.size(), 1u);
  EXPECT_LT(models[0].scene.fit.cost_after, 0.5 * current_->fit.cost_after);
  EXPECT_NEAR(models[0].scene.values.parameters.at("added_mass.normal").value, kAddedMass,
              0.2 * kAddedMass);
}

// What is tilted pulls as a steady wind does, and the first of them explains most. The other is not
// even short-listed.
TEST(Competitors, AreToldOfThoughTheFirstExplainsMost) {
  const Recording recording = MakeSmallRecording({5, 30, 0.001, {{"wind.y", 0.5}}});
  FitConfig given = DefaultConfig(recording);
  for (auto& [name, setting] : given.parameters) setting.free = name == "air_drag.normal";
  const auto current = FitAfresh({recording, given}, Start::kPlain, 10, FitRunner());
  ASSERT_TRUE(current);
  Ranking ranking;
  ranking.candidates = {ShortListed("wind", "wind.y", 0.3),
                        ShortListed("gravity_tilt", "gravity_tilt.angle_1", 0.03)};
  ranking.candidates[1].summary.is_short_listed = false;
  ranking.null_mean = 0.2 * current->fit.cost_after;
  ranking.extent = {{-0.25, -0.3, -0.5}, {0.25, 0.3, 0.0}, {0.5, 0.5}, 1.2};
  DiagnosisOptions options;
  options.max_models = 1;
  const std::vector<FittedModel> models = ModelScreening(given, options).Run(*current, ranking);
  ASSERT_EQ(models.size(), 2u);
  for (const FittedModel& model : models)
    EXPECT_LT(model.scene.fit.cost_after, 0.5 * current->fit.cost_after)
        << model.candidate.summary.name;
}

// A tilted gravity was named before it was known that the cloth takes air along. Beside that it is
// the wind that explains the rest.
TEST(Competitors, AreFittedBesideWhatWasFoundSince) {
  const Recording recording =
      MakeSmallRecording({5, 30, 0.001, {{"wind.y", 0.5}, {"added_mass.normal", kAddedMass}}});
  FitConfig given = DefaultConfig(recording);
  for (auto& [name, setting] : given.parameters) setting.free = name == "air_drag.normal";
  FitConfig with_mass = given;
  with_mass.parameters.at("added_mass.normal").free = true;
  with_mass.parameters.at("added_mass.normal").value = 0.05;
  FitConfig with_both = with_mass;
  with_both.parameters.at("gravity_tilt.angle_1").free = true;
  const auto mass = FitAfresh({recording, with_mass}, Start::kPlain, 20, FitRunner());
  const auto both = FitAfresh({recording, with_both}, Start::kPlain, 20, FitRunner());
  ASSERT_TRUE(mass && both);
  Ranking ranking;
  ranking.candidates = {ShortListed("gravity_tilt", "gravity_tilt.angle_1", 0.03),
                        ShortListed("wind", "wind.y", 0.3)};
  ranking.extent = {{-0.25, -0.3, -0.5}, {0.25, 0.3, 0.0}, {0.5, 0.5}, 1.2};
  const DiagnosisOptions options;
  const std::vector<FittedModel> competitors =
      ModelScreening(given, options)
          .FitCompetitors(*mass, ranking, {{ranking.candidates[0], *both}});
  ASSERT_EQ(competitors.size(), 1u);  // not the tilt itself
  EXPECT_EQ(competitors[0].candidate.summary.name, "wind");
  EXPECT_LT(competitors[0].scene.fit.cost_after, 0.8 * both->fit.cost_after);
  EXPECT_NEAR(competitors[0].scene.values.parameters.at("added_mass.normal").value, kAddedMass,
              0.3 * kAddedMass);
}

}  // namespace
}  // namespace clothfit
