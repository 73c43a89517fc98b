// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/terminal/progress_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ProgressText, SaysHowMuchIsDoneAndHowLongItTakes) {
  EXPECT_EQ(ProgressText(0.25, 60.0, false), " 25 %, 3:00 left");
  EXPECT_EQ(ProgressText(0.5, 7.0, true), "[##########..........]  50 %, 0:07 left");
}

TEST(ProgressText, KnowsNoTimeAtFirst) { EXPECT_EQ(ProgressText(0.01, 2.0, false), "  1 %"); }

// The estimate of a fit may run ahead of it: it is done when it has ended, not before.
TEST(ProgressText, IsNeverAllBeforeTheEnd) {
  for (const double fraction : {0.991, 0.9999, 1.0, 1.7}) {
    EXPECT_EQ(ProgressText(fraction, 100.0, false), " 99 %");
    EXPECT_THAT(ProgressText(fraction, 100.0, true), Not(HasSubstr("]100")));
    EXPECT_THAT(ProgressText(fraction, 100.0, true), HasSubstr(".]"));
  }
  EXPECT_EQ(ProgressText(-1.0, 100.0, false), "  0 %");
}

TEST(ProgressDisplay, DoesNotGoBack) {
  testing::internal::CaptureStderr();
  ProgressDisplay display;
  display.Show("one", "", 0.6);
  display.Show("two", "a", 0.3);
  display.Finish();
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_THAT(text, HasSubstr(" 60 %"));
  EXPECT_THAT(text, HasSubstr("  two, a"));
  EXPECT_THAT(text, Not(HasSubstr(" 30 %")));
}

TEST(ProgressDisplay, NotesStay) {
  testing::internal::CaptureStderr();
  ProgressDisplay display;
  display.Note("takes long\x1b[2J");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "takes long\\x1b[2J\n");
}

TEST(ProgressDisplay, ShortWorkShowsNothingWhereLinesComeNowAndThen) {
  testing::internal::CaptureStderr();
  ProgressDisplay display(ProgressDisplay::Lines::kNowAndThen);
  display.Show("one", "", 0.6);
  display.Finish();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace clothfit
