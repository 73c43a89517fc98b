// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/plan.h"

#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "fitting/files/sha256.h"
#include "fitting/trials/recording.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

std::vector<Trial> Plan(const std::string& name, int first_seed = 1, int num_seeds = 1) {
  TrialPlanOptions options;
  options.first_seed = first_seed;
  options.num_seeds = num_seeds;
  return MakeTrialPlan("PLAN", name, options);
}

std::string LabelOf(const Trial& trial) { return PlantedTruth(trial).Label(trial); }

TEST(TrialPlan, IsTheSameEveryTime) {
  const std::vector<Trial> first = Plan("all"), second = Plan("all");
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 400U);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].name, second[i].name);
    EXPECT_EQ(LabelOf(first[i]), LabelOf(second[i]));
    EXPECT_EQ(first[i].recording.parameters, second[i].recording.parameters);
    EXPECT_EQ(first[i].recording.seed, second[i].recording.seed);
  }
}

TEST(TrialPlan, SeedsDrawOtherTrialsOfTheSameKinds) {
  const std::vector<Trial> two = Plan("listed", 3, 2), second = Plan("listed", 4);
  ASSERT_EQ(two.size(), 2 * second.size());
  for (std::size_t i = 0; i < second.size(); ++i) {
    EXPECT_EQ(two[second.size() + i].name, second[i].name);
    EXPECT_EQ(LabelOf(two[second.size() + i]), LabelOf(second[i]));
    EXPECT_NE(two[i].recording.parameters, second[i].recording.parameters);
    EXPECT_EQ(two[i].effects[0].term, second[i].effects[0].term);
  }
}

TEST(TrialPlan, HasNamesOfItsOwnAndOptionsThatCanBeUsed) {
  std::set<std::string> names;
  std::set<std::uint64_t> seeds;
  for (const Trial& trial : Plan("all", 1, 2)) {
    EXPECT_TRUE(names.insert(trial.name).second) << trial.name;
    EXPECT_TRUE(seeds.insert(trial.seed).second) << trial.name;
    EXPECT_NO_THROW(trial.recording.Check(trial.name));
    EXPECT_EQ(trial.recording.resolution, Eigen::Vector2i(11, 11));
    EXPECT_EQ(trial.recording.frame_count, 150);
    EXPECT_EQ(trial.recording.refinement, 2);
    // At most half the step of a fit, 1/120 s.
    EXPECT_LE(1.0 / (trial.recording.frame_rate * trial.recording.steps_per_frame),
              1.0 / 240.0 + 1e-12);
  }
  EXPECT_GT(names.size(), 800U);
}

TEST(TrialPlan, SamplesAllKindsInProportion) {
  TrialPlanOptions options;
  const std::vector<Trial> all = MakeTrialPlan("plan", "all", options);
  options.sample = 50;
  const std::vector<Trial> some = MakeTrialPlan("plan", "all", options);
  ASSERT_EQ(some.size(), 50u);
  const auto count = [](const std::vector<Trial>& trials, TrialKind kind) {
    return std::count_if(trials.begin(), trials.end(),
                         [&](const Trial& trial) { return trial.kind == kind; });
  };
  for (const TrialKind kind : {TrialKind::kClean, TrialKind::kFault, TrialKind::kListed})
    EXPECT_NEAR(static_cast<double>(count(some, kind)),
                50.0 * static_cast<double>(count(all, kind)) / static_cast<double>(all.size()),
                1.0);
  std::set<std::string> names;
  for (const Trial& trial : all) names.insert(trial.name);
  for (const Trial& trial : some) EXPECT_EQ(names.erase(trial.name), 1u) << trial.name;
  options.sample = 10000;  // more than there are
  EXPECT_EQ(MakeTrialPlan("plan", "all", options).size(), all.size());
  options.sample = -1;
  EXPECT_THROW(MakeTrialPlan("plan", "all", options), InputError);
}

TEST(TrialPlan, PlantsEveryAbsentTermInTwoMotionsTwoObservationsAndThreeSizes) {
  struct Seen {
    std::set<SyntheticScenario> motions;
    std::set<std::pair<SyntheticScenario, TrialObservation>> observed;
    std::set<EffectSize> sizes;
    int count = 0;
  };
  std::map<std::string, Seen> seen;
  for (const Trial& trial : Plan("listed")) {
    ASSERT_EQ(trial.effects.size(), 1U);
    Seen& of = seen[trial.effects[0].term];
    of.motions.insert(trial.recording.scenario);
    of.observed.insert({trial.recording.scenario, trial.observation});
    of.sizes.insert(trial.effects[0].size);
    ++of.count;
  }
  const std::vector<TermInfo> absent = AbsentTerms();
  EXPECT_GE(absent.size(), 26U);
  for (const TermInfo& term : absent) {
    const Seen& of = seen[term.name];
    EXPECT_GE(of.motions.size(), 2U) << term.name;
    EXPECT_GE(of.observed.size(), 2 * of.motions.size()) << term.name;
    EXPECT_EQ(of.sizes.size(), 3U) << term.name;
    EXPECT_EQ(of.count, static_cast<int>(3 * of.observed.size())) << term.name;
  }
}

TEST(TrialPlan, LeavesOutWhatIsThereAlwaysAndWhatHelpsFits) {
  std::set<std::string> absent;
  for (const TermInfo& term : AbsentTerms()) absent.insert(term.name);
  for (const char* name : {"gravity", "stretch", "shear", "bending", "air_drag", "ground",
                           "attraction_point", "attraction_ray"})
    EXPECT_EQ(absent.count(name), 0U) << name;
  EXPECT_EQ(absent.count("wind"), 1U);
  EXPECT_EQ(absent.count("stretch_orthotropy"), 1U);
}

TEST(TrialPlan, SwitchesEveryEffectOnAndMoreForLargerSizes) {
  int compared = 0;
  for (const auto& effects : {ListedEffects(), UnlistedEffects()}) {
    for (const PlantableEffect& effect : effects) {
      const TermInfo& term = TermOf(effect.term);
      EXPECT_FALSE(effect.amounts.empty()) << effect.term;
      bool is_on = false;
      for (const Parameter& p : term.parameters) {
        is_on = is_on || (SwitchesOff(p) &&
                          (effect.amounts.count(p.name) > 0 || effect.shape.count(p.name) > 0));
      }
      EXPECT_TRUE(is_on) << effect.term;
      for (const auto& [name, values] : effect.amounts) {
        const double way = effect.term == "grip_slip" ? -1.0 : 1.0;  // downwards
        EXPECT_LT(way * values[0], way * values[1]) << effect.term << "." << name;
        EXPECT_LT(way * values[1], way * values[2]) << effect.term << "." << name;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(TrialPlan, KeepsTheGroundsEffectsToMotionsOnTheGround) {
  int checked = 0;
  for (const PlantableEffect& effect : ListedEffects()) {
    if (TermOf(effect.term).needs != Needs::kGround) continue;
    EXPECT_TRUE(MakeSyntheticMotion(effect.motion, {0.5, 0.5}, 5.0).ground_height) << effect.term;
    ++checked;
  }
  EXPECT_EQ(checked, 4);
}

TEST(TrialPlan, CountsWhatTheStudyAsksFor) {
  EXPECT_EQ(Plan("clean").size(), 60U);
  EXPECT_EQ(Plan("fault").size(), 60U);
  EXPECT_EQ(Plan("pairs").size(), 40U);
  EXPECT_EQ(Plan("all").size(), 60 + 60 + 40 + Plan("listed").size() + Plan("unlisted").size());
  std::set<FaultKind> faults;
  for (const Trial& trial : Plan("fault")) {
    ASSERT_TRUE(trial.fault);
    faults.insert(trial.fault->kind);
    EXPECT_TRUE(trial.effects.empty());
  }
  EXPECT_EQ(faults.size(), kFaultKinds.size());
}

TEST(TrialPlan, SaysWhatIsWrong) {
  const auto problem = [](const std::string& plan, const TrialPlanOptions& options) {
    try {
      MakeTrialPlan("PLAN", plan, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(problem("lsited", {}), HasSubstr("did you mean 'listed'?"));
  TrialPlanOptions options;
  options.only = {"wimd"};
  EXPECT_THAT(problem("listed", options), HasSubstr("did you mean 'wind'?"));
  options.only = {"vortex"};
  EXPECT_THAT(problem("listed", options), HasSubstr("has none of these"));
  options = {};
  options.num_seeds = 0;
  EXPECT_THAT(problem("listed", options), HasSubstr("--seeds"));
}

TEST(TrialPlan, CanBeReducedToSomeEffects) {
  TrialPlanOptions options;
  options.only = {"wind", "camera-pose"};
  int wind = 0, pose = 0;
  for (const Trial& trial : MakeTrialPlan("PLAN", "all", options)) {
    const bool has_wind = !trial.effects.empty() &&
                          (trial.effects[0].term == "wind" || trial.effects.back().term == "wind");
    const bool has_pose = trial.fault && trial.fault->kind == FaultKind::kCameraPose;
    EXPECT_TRUE(has_wind || has_pose) << trial.name;
    wind += has_wind ? 1 : 0;
    pose += has_pose ? 1 : 0;
  }
  EXPECT_GT(wind, 12);
  EXPECT_EQ(pose, 12);
}

TEST(Commitment, IsThatOfTheLabelAndTheNonce) {
  std::set<std::string> digests;
  for (const Trial& trial : Plan("quick")) {
    const TrialTruth truth = PlantedTruth(trial);
    const Commitment commitment = Commit(trial, truth);
    EXPECT_EQ(commitment.digest, Sha256(truth.Label(trial) + "\n" + commitment.nonce));
    EXPECT_EQ(commitment.nonce.size(), 32U);
    EXPECT_EQ(truth.Label(trial).find(','), std::string::npos);
    digests.insert(commitment.digest);
    TrialTruth other = truth;
    other.effects.emplace_back("hem");
    EXPECT_NE(Commit(trial, other).digest, commitment.digest);
  }
  EXPECT_EQ(digests.size(), Plan("quick").size());
}

}  // namespace
}  // namespace clothfit
