// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which candidates are worth a fit, by rankings that are made by hand.
#include "fitting/diagnosis/rank/short_list.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

RankedCandidate Physics(const char* name, double score, double share, double p_value) {
  RankedCandidate candidate;
  candidate.summary.name = name;
  candidate.summary.score = score;
  candidate.summary.share = share;
  candidate.summary.p_value = p_value;
  candidate.summary.detection_limit = 0.1;
  candidate.names = {"wind.x"};
  candidate.amounts = Eigen::VectorXd::Constant(1, 0.5);
  candidate.sigma = Eigen::VectorXd::Constant(1, 0.01);
  return candidate;
}

// Of the ranking's only fault, whose typical sigma is 0.0003 m.
RankedCandidate Shift(double amount, double detection_limit, double share) {
  RankedCandidate candidate = Physics("camera 0: pose", 100.0, share, 1e-9);
  candidate.summary.kind = CandidateKind::kObservation;
  candidate.summary.detection_limit = detection_limit;
  candidate.names = {"camera 0: shift x"};
  candidate.amounts[0] = amount;
  candidate.faults = {0};
  return candidate;
}

Ranking Ranked(std::vector<RankedCandidate> candidates) {
  Ranking ranking;
  ranking.candidates = std::move(candidates);
  ranking.gate_p_value = 1e-6;
  ranking.residual_rms = 1.5;
  Fault shift{Fault::Kind::kCameraShift, "camera 0: pose", "camera 0: shift x", "m"};
  shift.typical = 0.0003;
  ranking.faults = {shift};
  return ranking;
}

std::string WhyNot(Ranking ranking, bool has_points = true) {
  ShortList(has_points, {}, &ranking);
  const Candidate& first = ranking.candidates.front().summary;
  EXPECT_EQ(first.is_short_listed, first.why_not.empty());
  return first.why_not;
}

TEST(ShortList, TakesWhatStandsOutAndExplainsEnough) {
  EXPECT_EQ(WhyNot(Ranked({Physics("wind", 100.0, 0.5, 1e-9)})), "");
  EXPECT_EQ(WhyNot(Ranked({Physics("wind", 100.0, 0.03, 1e-9)})), "explains 3 % of it");
  EXPECT_EQ(WhyNot(Ranked({Physics("wind", 100.0, 0.5, 0.2)})),
            "the null does as much with p = 0.2");
}

TEST(ShortList, ManyCandidatesNeedSmallerPValues) {
  std::vector<RankedCandidate> many(20, Physics("hem", 1.0, 0.5, 0.9));
  many.front() = Physics("wind", 100.0, 0.5, 0.01);
  EXPECT_EQ(WhyNot(Ranked(many)), "the null does as much with p = 0.01");
  EXPECT_EQ(WhyNot(Ranked({many.front()})), "");
}

TEST(ShortList, TellsParametersWithUnitsAndIntervals) {
  Ranking ranking = Ranked({Physics("wind", 100.0, 0.5, 1e-9), Shift(0.004, 0.001, 0.5)});
  ShortList(true, {}, &ranking);
  const EffectParameter& wind = ranking.candidates[0].summary.parameters.at(0);
  EXPECT_EQ(wind.unit, "m/s");
  EXPECT_NEAR(wind.upper90 - wind.lower90, 2.0 * 1.645 * 0.01, 1e-4);
  EXPECT_EQ(ranking.candidates[1].summary.parameters.at(0).unit, "m");
}

TEST(ShortList, OfOutlinesAloneNoPhysicsThatMeshAndStepMayMake) {
  Ranking may_be_mesh = Ranked({Physics("wind", 100.0, 0.5, 1e-9)});
  may_be_mesh.gate_p_value = 0.4;
  EXPECT_EQ(WhyNot(may_be_mesh, false), "mesh and step may make all that is left");
  EXPECT_EQ(WhyNot(may_be_mesh, true), "");
  EXPECT_EQ(WhyNot(Ranked({Physics("wind", 100.0, 0.5, 1e-9)}), false), "");
}

TEST(ShortList, OfOutlinesAloneAFaultHasToExplainAHundredth) {
  Ranking ranking = Ranked({Shift(0.004, 0.001, 0.5)});
  ranking.num_rows = 10000;
  ranking.candidates.front().summary.score = 200.0;  // of 22500
  EXPECT_EQ(WhyNot(ranking, false), "explains 0.89 % of what outlines alone leave");
  EXPECT_EQ(WhyNot(ranking, true), "");
  ranking.candidates.front().summary.score = 300.0;
  EXPECT_EQ(WhyNot(ranking, false), "");
}

TEST(ShortList, AFaultHasToBeLargerThanWellMadeRecordingsHaveIt) {
  EXPECT_EQ(WhyNot(Ranked({Shift(0.0008, 1e-5, 0.5)})), "no larger than in well-made recordings");
  EXPECT_EQ(WhyNot(Ranked({Shift(-0.0010, 1e-5, 0.5)})), "");
}

TEST(ShortList, WithLargeResidualsAFaultHasToStandOutTwice) {
  Ranking large = Ranked({Shift(0.004, 0.003, 0.5)});
  EXPECT_EQ(WhyNot(large), "");
  large.residual_rms = 2.5;
  EXPECT_EQ(WhyNot(large), "the fit leaves large residuals, and it does not stand out of the null");
  large.candidates.front().summary.detection_limit = 0.001;
  EXPECT_EQ(WhyNot(large), "");
}

TEST(ShortList, PhysicsThatExplainsMoreCompetesWithAFault) {
  Ranking ranking = Ranked({Shift(0.004, 0.001, 0.5), Physics("wind", 150.0, 0.03, 1e-9),
                            Physics("hem", 50.0, 0.02, 1e-9), Physics("gust", 150.0, 0.03, 0.5)});
  ShortList(true, {}, &ranking);
  EXPECT_TRUE(ranking.candidates[1].summary.is_short_listed);
  EXPECT_FALSE(ranking.candidates[2].summary.is_short_listed);
  EXPECT_FALSE(ranking.candidates[3].summary.is_short_listed);
}

}  // namespace
}  // namespace clothfit
