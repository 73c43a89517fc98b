// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/names.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(EditDistance("", ""), 0);
  EXPECT_EQ(EditDistance("size", "size"), 0);
  EXPECT_EQ(EditDistance("sze", "size"), 1);
  EXPECT_EQ(EditDistance("sizes", "size"), 1);
  EXPECT_EQ(EditDistance("sixe", "size"), 1);
  EXPECT_EQ(EditDistance("szie", "size"), 1);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
  EXPECT_EQ(EditDistance("abc", ""), 3);
}

TEST(Suggestion, NamesTheNearestOrAll) {
  const std::vector<std::string> names = {"size", "resolution", "initial"};
  EXPECT_EQ(Suggestion("resolutoin", names), "did you mean 'resolution'?");
  EXPECT_EQ(Suggestion("colour", names), "expected one of size, resolution, initial");
}

TEST(JoinNames, PutsWhatIsAskedForBetweenThem) {
  const std::vector<std::string> names = {"a", "b", "c"};
  EXPECT_EQ(JoinNames({}), "");
  EXPECT_EQ(JoinNames(names), "a, b, c");
  EXPECT_EQ(JoinNames(names, " + "), "a + b + c");
  EXPECT_EQ(JoinNames(names, ", ", " and "), "a, b and c");
  EXPECT_EQ(JoinNames({names[0]}, ", ", " and "), "a");
}

}  // namespace
}  // namespace clothfit
