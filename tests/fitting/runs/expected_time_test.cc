// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/expected_time.h"

#include <limits>

#include <gmock/gmock.h>

namespace clothfit {
namespace {

TEST(ExpectedTime, IsToldOnceWhenItIsNoGuess) {
  ExpectedTime time;
  EXPECT_EQ(time.Tell(0.0, 5.0), "");
  EXPECT_EQ(time.Tell(0.01, 9.0), "");
  EXPECT_EQ(time.Tell(std::numeric_limits<double>::quiet_NaN(), 9.0), "");
  EXPECT_EQ(time.Tell(0.1, 30.0), "takes about 5 minutes in all");
  EXPECT_EQ(time.Tell(0.2, 90.0), "");
}

TEST(ExpectedTime, NamesWhatMakesALongFitShorter) {
  EXPECT_THAT(ExpectedTime().Tell(0.05, 90.0),
              testing::AllOf(testing::HasSubstr("about 30 minutes"), testing::HasSubstr("--frames"),
                             testing::HasSubstr("--every N"), testing::HasSubstr("--resolution")));
}

TEST(ExpectedTime, IsNotWorthALineWhereItIsShort) {
  ExpectedTime time;
  EXPECT_EQ(time.Tell(0.1, 5.0), "");
  EXPECT_EQ(time.Tell(0.2, 500.0), "");  // and stays so
}

}  // namespace
}  // namespace clothfit
