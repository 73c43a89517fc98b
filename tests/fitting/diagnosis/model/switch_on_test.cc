// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/switch_on.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::ElementsAre;

TEST(AtShares, AreOfEachSignOfTheEstimateAtItsPlace) {
  const Probe here = {{"hem.low_u", 0.1}}, there = {{"hem.low_u", 0.2}};
  RankedCandidate candidate;
  candidate.probe = here;
  candidate.amounts = Eigen::Vector2d(2.0, -4.0);
  candidate.other_starts = {{there, Eigen::Vector2d(-1.0, 0.0)}};
  const RankedCandidate starts = AtShares(candidate);
  EXPECT_EQ(starts.probe, here);
  EXPECT_EQ(starts.amounts, candidate.amounts);
  std::vector<double> first;
  for (const RankedCandidate::Start& one : starts.other_starts) first.push_back(one.amounts[0]);
  EXPECT_THAT(first, ElementsAre(0.3 * 2.0, 0.1 * 2.0, 3.0 * 2.0, -1.0, -0.3, -0.1, -3.0));
  EXPECT_EQ(starts.other_starts[2].probe, here);
  EXPECT_EQ(starts.other_starts[3].probe, there);
}

}  // namespace
}  // namespace clothfit
