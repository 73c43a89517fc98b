// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/default_terms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

using testing::ElementsAre;

RankedCandidate Lacking(const std::string& name, const std::vector<std::string>& parameters,
                        double score, int first_column) {
  RankedCandidate candidate;
  candidate.summary.name = name;
  candidate.summary.score = score;
  candidate.names = parameters;
  candidate.amounts.setConstant(static_cast<Eigen::Index>(parameters.size()), -1e9);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    candidate.columns.push_back(first_column + static_cast<int>(i));
  return candidate;
}

Ranking WithoutDissipation() {
  Ranking ranking;
  ranking.candidates = {
      Lacking("wind", {"wind.x", "wind.y", "wind.z"}, 90.0, 0),
      Lacking("bending.damping", {"bending.damping"}, 80.0, 3),
      Lacking("air_drag", {"air_drag.normal", "air_drag.saturation", "air_drag.tangential"}, 85.0,
              4)};
  return ranking;
}

double InitialOf(const std::string& name) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  return table[RequireParameter(table, name)].parameter.initial;
}

TEST(DefaultTerms, IsWhatASimulationHasUnlessToldOtherwise) {
  const Ranking ranking = WithoutDissipation();
  EXPECT_FALSE(IsDefaultTerm(ranking.candidates[0]));
  EXPECT_TRUE(IsDefaultTerm(ranking.candidates[1]));
  EXPECT_TRUE(IsDefaultTerm(ranking.candidates[2]));
  RankedCandidate camera = ranking.candidates[1];
  camera.summary.kind = CandidateKind::kObservation;
  EXPECT_FALSE(IsDefaultTerm(camera));
}

TEST(DefaultTerms, BeginsTogetherAsASimulationDoes) {
  const std::optional<RankedCandidate> all = AllDefaultTerms(WithoutDissipation());
  ASSERT_TRUE(all);
  EXPECT_THAT(all->Effects(), ElementsAre("air_drag", "bending.damping"));
  EXPECT_EQ(all->summary.name, "air_drag, bending.damping");
  EXPECT_EQ(all->summary.score, 85.0);
  EXPECT_THAT(all->columns, ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(all->names, ElementsAre("bending.damping", "air_drag.normal", "air_drag.saturation",
                                      "air_drag.tangential"));
  ASSERT_EQ(all->amounts.size(), 4);
  for (std::size_t i = 0; i < all->names.size(); ++i)
    EXPECT_EQ(all->amounts[static_cast<Eigen::Index>(i)], InitialOf(all->names[i]));
}

TEST(DefaultTerms, IsNoGroupOfOne) {
  Ranking ranking = WithoutDissipation();
  ranking.candidates.pop_back();
  EXPECT_FALSE(AllDefaultTerms(ranking));
  EXPECT_THAT(ranking.candidates[1].Effects(), ElementsAre("bending.damping"));
}

}  // namespace
}  // namespace clothfit
