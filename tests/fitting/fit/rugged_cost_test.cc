// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/rugged_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(RuggedCost, IsSaidWithWhatMayHelp) {
  const std::string said = SayCostIsRugged(0.22, 0.5);
  EXPECT_THAT(said, StartsWith("the fit came to rest where a full step promises 22 % less cost"));
  EXPECT_THAT(said, HasSubstr("(--window 0.25)"));
  EXPECT_THAT(SayCostIsRugged(0.22, 0.0), HasSubstr("(--window 0.25)"));  // as it is by default
}

TEST(RuggedCost, IsFoundAmongTheStatementsOfAFit) {
  const std::string said = SayCostIsRugged(0.5, 0.25);
  EXPECT_EQ(RuggedCostAmong({"only the ratios of a and b are determined", said}), said);
  EXPECT_EQ(RuggedCostAmong({"only the ratios of a and b are determined"}), "");
  EXPECT_EQ(RuggedCostAmong({}), "");
}

}  // namespace
}  // namespace clothfit
