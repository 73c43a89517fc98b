// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One new file and one line in the list make a force term: it is simulated, fitted, listed, looked
// for and planted, while nothing but layer_push.h and the list names it. Its derivatives are tested
// by force_term_test.cc and catalogue_rollout_test.cc, which this program has too.
#include <algorithm>
#include <set>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/commands/commands.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "autodiff_sim/terms/terms.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/rank/ranking.h"
#include "fitting/trials/finite_elements/laws.h"
#include "fitting/trials/recording.h"
#include "tests/project/source_file.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

constexpr double kPressure = 0.4;  // Pa
const std::string kTerm = LayerPush::kName;

// A cloth that hangs and is turned while a part of it is pushed.
Recording PushedCloth() {
  SyntheticOptions options;
  options.scenario = SyntheticScenario::kTwoCornerTurn;
  options.size = {0.5, 0.5};
  options.resolution = {5, 5};
  options.refinement = 1;
  options.markers = {5, 5};
  options.marker_sigma = 0.001;
  options.frame_rate = 20.0;
  options.frame_count = 40;
  options.steps_per_frame = 6;
  options.parameters = {
      {kTerm + ".pressure", kPressure}, {kTerm + ".height", -0.3}, {kTerm + ".depth", 0.1}};
  return MakeSyntheticRecording(options).recording;
}

// Only the material parameters's damping of stretch is fitted beside it.
FitConfig AlmostFixed(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = name == "stretch.damping";
  return config;
}

// The tests above this one are of the whole program only if these are all who know the list.
TEST(NewTerm, IsKnownToTheSourcesThatAreCompiledAgain) {
  std::set<std::string> know;
  for (const project::SourceFile& file :
       project::ReadFolders(CLOTHFIT_SOURCE_DIR, {"autodiff_sim", "tracking", "fitting", "apps"})) {
    for (const std::string& line : file.lines) {
      if (line.find("#include \"autodiff_sim/terms/terms.h\"") == 0) know.insert(file.path);
    }
  }
  EXPECT_THAT(know, testing::ElementsAre("autodiff_sim/step/simulation.cc",
                                         "autodiff_sim/terms/parameter_table.cc",
                                         "fitting/trials/terms/trial_terms.cc"));
}

TEST(NewTerm, IsListed) {
  EXPECT_EQ(AllTerms().back().name, kTerm);
  CLI::App app;
  Action action;
  AddTermsCommand(&app, &action);
  app.parse("terms --all", false);
  testing::internal::CaptureStdout();
  EXPECT_EQ(action(), kExitSuccess);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_THAT(text, HasSubstr("layer_push: a push along y in a layer of heights (an example)\n"
                              "  may be missing; drives; tied to world\n"));
  EXPECT_THAT(text, HasSubstr("layer_push.pressure"));
}

TEST(NewTerm, IsSimulatedAndFitted) {
  const Recording recording = PushedCloth();
  FitConfig config = AlmostFixed(recording);
  config.parameters.at(kTerm + ".height").value = -0.3;
  config.parameters.at(kTerm + ".depth").value = 0.1;
  config.parameters.at(kTerm + ".pressure").free = true;
  const auto fitted = FitAfresh({recording, config}, Start::kPlain, 10, FitRunner());
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(fitted->values.parameters.at(kTerm + ".pressure").value, kPressure, 0.02);
}

TEST(NewTerm, IsLookedForAndFound) {
  const Recording recording = PushedCloth();
  const auto fitted = FitAfresh({recording, AlmostFixed(recording)}, Start::kPlain, 3, FitRunner());
  ASSERT_TRUE(fitted);
  DiagnosisOptions options;
  const std::set<std::string> competitors = {kTerm, "wind", "crease", "heavy_patch"};
  for (const TermInfo& term : AllTerms()) {
    if (competitors.count(term.name) == 0) options.excluded.push_back(term.name);
  }
  RankingStart quick;
  quick.draws = 1;
  const Ranking ranking = RankCandidates(*fitted, options, quick);
  // Faults of the markers compete in the same list.
  const auto first = std::find_if(ranking.candidates.begin(), ranking.candidates.end(),
                                  [](const RankedCandidate& candidate) {
                                    return candidate.summary.kind == CandidateKind::kPhysics;
                                  });
  ASSERT_NE(first, ranking.candidates.end());
  EXPECT_EQ(first->summary.name, kTerm);
  EXPECT_TRUE(first->summary.is_short_listed);
  EXPECT_LT(first->summary.p_value, 1e-3);
  EXPECT_TRUE(first->Exceeds(3.0));  // of the detection limit
}

TEST(NewTerm, IsPlantedByTrials) {
  TrialPlanOptions options;
  options.only = {kTerm};
  options.frame_count = 20;
  const std::vector<Trial> trials = MakeTrialPlan("plan", "listed", options);
  EXPECT_EQ(trials.size(), 12U);  // two motions, two kinds of observation, three sizes
  std::set<std::string> motions;
  for (const Trial& trial : trials) {
    motions.insert(ToString(trial.recording.scenario));
    EXPECT_EQ(trial.effects.front().term, kTerm);
  }
  EXPECT_EQ(motions.size(), 2U);
  const Trial& large = trials[2];
  ASSERT_EQ(large.effects.front().size, EffectSize::kLarge);
  EXPECT_GT(DistanceBetween(TruePoints(large), TruePoints(WithoutEffects(large))), 0.005);
  const EffectClass effect = ClassOf(kTerm);
  EXPECT_TRUE(effect.is_driving);
  EXPECT_THAT(effect.tied_to, testing::ElementsAre("world"));
}

TEST(NewTerm, IsLeftOutByTheSecondGenerator) {
  EXPECT_FALSE(FemKnows(kTerm));
  EXPECT_TRUE(FemKnows("wind"));
  TrialPlanOptions options;
  options.finite_elements = true;
  for (const Trial& trial : MakeTrialPlan("plan", "listed", options))
    EXPECT_NE(trial.effects.front().term, kTerm);
}

}  // namespace
}  // namespace clothfit
