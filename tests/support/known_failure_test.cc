// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/known_failure.h"

#include <map>
#include <stdexcept>

namespace clothfit {
namespace {

TEST(KnownFailure, HidesWhatFails) {
  const int answer = 41;
  EXPECT_KNOWN_FAILURE("counted from nought", EXPECT_EQ(answer, 42));
  EXPECT_KNOWN_FAILURE("commas", EXPECT_EQ((std::map<int, int>{{1, 2}}), (std::map<int, int>{})));
  EXPECT_KNOWN_FAILURE("one of two", EXPECT_EQ(answer, 41); EXPECT_EQ(answer, 42));
}

TEST(KnownFailure, OfAnAssertionEndsTheStatementAlone) {
  bool is_reached = false;
  EXPECT_KNOWN_FAILURE("fatal", ASSERT_TRUE(false); is_reached = true);
  EXPECT_FALSE(is_reached);
}

TEST(KnownFailure, FailsWhereAllHolds) {
  EXPECT_NONFATAL_FAILURE(EXPECT_KNOWN_FAILURE("mended long ago", EXPECT_TRUE(true)),
                          "mended long ago");
  EXPECT_NONFATAL_FAILURE(EXPECT_KNOWN_FAILURE("nothing is asserted", SUCCEED()),
                          "take EXPECT_KNOWN_FAILURE off");
}

TEST(KnownFailure, IsNoException) {
  EXPECT_THROW(EXPECT_KNOWN_FAILURE("thrown", throw std::runtime_error("no scene")),
               std::runtime_error);
}

}  // namespace
}  // namespace clothfit
