// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/forecast_screening.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

// A fit of a small recording that knows all but a few material parameters.
FittedScene BaselineOf(const std::map<std::string, double>& parameters) {
  const Recording recording = MakeSmallRecording({6, 36, 0.001, parameters});
  FitConfig told = DefaultConfig(recording);
  for (auto& [name, setting] : told.parameters) setting.free = false;
  for (const char* name : {"stretch.stiffness", "bending.stiffness"})
    told.parameters.at(name).free = true;
  return FitAfresh({recording, told}, Start::kWindows, 6, FitRunner()).value();
}

DiagnosisOptions Among(const std::vector<std::string>& names) {
  DiagnosisOptions options;
  for (const TermInfo& term : AllTerms()) {
    if (std::find(names.begin(), names.end(), term.name) == names.end())
      options.excluded.push_back(term.name);
  }
  return options;
}

TEST(ForecastScreening, PutsWhatIsMissingFirst) {
  const FittedScene baseline = BaselineOf({{"wind.y", 0.8}});
  const DiagnosisOptions options = Among({"wind", "hem", "gravity_tilt", "added_mass"});
  const std::optional<ForecastRound> round =
      ForecastScreening(baseline.config, options).Run(baseline, {}, {}, options.least_share);
  ASSERT_TRUE(round);
  EXPECT_TRUE(round->before.of_forecasts);
  ASSERT_FALSE(round->judged.empty());
  const JudgedModel& best = round->judged.front();
  EXPECT_EQ(best.candidate.summary.name, "wind");
  EXPECT_GT(best.log_evidence, kStrongEvidence);
  EXPECT_NEAR(best.model.fine.values.parameters.at("wind.y").value, 0.8, 0.08);
  EXPECT_LT(LeftByForecasts(best.model.fine), 0.5 * LeftByForecasts(round->before));
}

// On the coarse mesh no model explains three quarters of more than all.
TEST(ForecastScreening, JudgesNoneWhereNoneExplainsEnough) {
  const FittedScene baseline = BaselineOf({{"wind.y", 0.8}});
  const std::optional<ForecastRound> round =
      ForecastScreening(baseline.config, Among({"wind"})).Run(baseline, {}, {}, 1.4);
  ASSERT_TRUE(round);
  EXPECT_FALSE(round->ranking.candidates.empty());
  EXPECT_TRUE(round->judged.empty());
}

// Where nothing is missing, states that are a little wrong may speak for something; it explains
// next to nothing of what forecasts leave.
TEST(ForecastScreening, FindsNoExplanationWhereNothingIsMissing) {
  const FittedScene baseline = BaselineOf({});
  const DiagnosisOptions options = Among({"wind", "hem", "added_mass"});
  const std::optional<ForecastRound> round =
      ForecastScreening(baseline.config, options).Run(baseline, {}, {}, options.least_share);
  ASSERT_TRUE(round);
  for (const JudgedModel& one : round->judged) {
    const auto whole = FitBeyondForecasts(one.model.fine, 12, FitRunner());
    ASSERT_TRUE(whole);
    EXPECT_LT(LogEvidence(baseline.fit.cost_after, whole->fit.cost_after,
                          static_cast<double>(one.candidate.NumUnknowns()), ScaleOf(*whole)),
              kStrongEvidence)
        << one.candidate.summary.name;
  }
}

// What was fitted to forecasts is gone on with to all frames.
TEST(ForecastScreening, IsGoneOnWith) {
  const FittedScene baseline = BaselineOf({{"wind.y", 0.8}});
  ModelStart start = GoOn(baseline);
  for (const char* name : {"wind.x", "wind.y", "wind.z"})
    start.config.parameters.at(name).free = true;
  const auto forecasts =
      FitToForecasts(start, baseline.scene.mesh.grid, {}, FitRunner(), &baseline);
  ASSERT_TRUE(forecasts && forecasts->of_forecasts);
  const auto whole = FitBeyondForecasts(*forecasts, 12, FitRunner());
  ASSERT_TRUE(whole);
  EXPECT_FALSE(whole->of_forecasts);
  EXPECT_LT(whole->fit.cost_after, 0.5 * baseline.fit.cost_after);
  EXPECT_NEAR(whole->values.parameters.at("wind.y").value, 0.8, 0.05);
}

// Where nothing is gone on with, windows from the config's own material find what forecasts' lost.
TEST(ForecastScreening, IsFittedAfreshWhereItHasLostTheMotion) {
  FittedScene lost = BaselineOf({});
  const FitConfig given = lost.config;
  FitConfig config = given;
  config.parameters.at("stretch.stiffness").value = 4.0;
  const FitRunner runner;
  const std::optional<FittedScene> forecasts = FitToForecasts(
      {lost.scene.recording, config}, lost.scene.mesh.grid, {0, kAllLengths, 0}, runner);
  ASSERT_TRUE(forecasts);
  const std::optional<FittedScene> near = FitBeyondForecasts(*forecasts, 1, runner);
  ASSERT_TRUE(near && HasLargeResidual(near->scene, near->config, near->fit));
  const std::optional<FittedScene> found =
      FitToAllFrames(given, *near, *forecasts, {5, 5}, 1, runner);
  ASSERT_TRUE(found);
  EXPECT_FALSE(HasLargeResidual(found->scene, found->config, found->fit));
  EXPECT_LT(found->fit.cost_after, near->fit.cost_after);
}

// Where windows lead nowhere either: a model never costs more than the one within it.
TEST(ForecastScreening, BeginsWithoutTheEffectWhereThatCostsLess) {
  const FittedScene before = BaselineOf({});
  FitConfig lost = before.config;
  lost.parameters.at("stretch.stiffness").value = 4.0;
  ModelStart start{before.scene.recording, lost};
  for (const char* name : {"wind.x", "wind.y", "wind.z"})
    start.config.parameters.at(name).free = true;
  const FitRunner runner;
  const std::optional<FittedScene> forecasts =
      FitToForecasts(start, before.scene.mesh.grid, {0, kAllLengths, 0}, runner);
  ASSERT_TRUE(forecasts);
  FittedScene dear = before;
  dear.fit.cost_after = 1e9;
  const auto fit = [&](const FittedScene& without) {
    return FitToAllFrames(lost, without, *forecasts, {5, 5}, 1, runner);
  };
  const std::optional<FittedScene> alone = fit(dear), nested = fit(before);
  ASSERT_TRUE(alone && nested);
  EXPECT_GT(alone->fit.cost_after, before.fit.cost_after);
  EXPECT_LE(nested->fit.cost_after, before.fit.cost_after);
  EXPECT_TRUE(nested->config.parameters.at("wind.x").free);
}

}  // namespace
}  // namespace clothfit
