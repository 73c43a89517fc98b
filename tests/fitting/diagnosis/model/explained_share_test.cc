// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/explained_share.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(ExplainedShare, SharesAreOfWhatIsAboveTheNull) {
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 60.0, 20.0, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 10.0, 20.0, 0.0), 1.0);   // better than the null
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 90.0, 120.0, 0.0), 0.0);  // beneath it from the start
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 110.0, 20.0, 0.0), 0.0);
}

TEST(ExplainedShare, SharesBelowTheNullAreOfWhatCanBeExplained) {
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 90.0, 120.0, 20.0), 0.5);
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 70.0, 120.0, 20.0), 1.0);
  EXPECT_DOUBLE_EQ(ShareExplained(100.0, 60.0, 20.0, 20.0), 0.5);  // the excess is more
}

// Half of what is beyond noise, where another mesh might make all of it.
TEST(ShareBeyondMesh, CountsFromWhatMeshMakesOrFromNoise) {
  EXPECT_DOUBLE_EQ(ShareBeyondMesh(100.0, 70.0, 20.0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(ShareBeyondMesh(100.0, 30.0, 20.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(ShareBeyondMesh(100.0, 40.0, 20.0, 2.0), 0.75);
  EXPECT_DOUBLE_EQ(ShareBeyondMesh(100.0, 70.0, 20.0, 2.0), 0.0);
}

}  // namespace
}  // namespace clothfit
