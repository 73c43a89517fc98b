// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// From pictures to a fitted surface, as a user does it.
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class Pictures : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    made_ = new CommandResult(Run({"synthesize",
                                   "-o",
                                   "rec",
                                   "--preset",
                                   "experiment-3",
                                   "--size",
                                   "0.6",
                                   "0.6",
                                   "--resolution",
                                   "9",
                                   "9",
                                   "--refinement",
                                   "1",
                                   "--steps",
                                   "4",
                                   "--cameras",
                                   "3",
                                   "--frames",
                                   "12",
                                   "--picture-size",
                                   "320",
                                   "240",
                                   "--truth-points",
                                   "9",
                                   "9",
                                   "--held-out",
                                   "0.25"}));
  }
  static void TearDownTestSuite() {
    delete made_;
    delete folder_;
  }
  static CommandResult Run(const std::vector<std::string>& words) {
    return RunCommand(words, folder_->path());
  }
  static TestFolder* folder_;
  static CommandResult* made_;
};
TestFolder* Pictures::folder_ = nullptr;
CommandResult* Pictures::made_ = nullptr;

TEST_F(Pictures, BecomeAFittedSurface) {
  ASSERT_EQ(made_->status, 0) << made_->err;
  const CommandResult fit = Run({"fit", "rec", "-o", "run", "--max-iterations", "3"});
  ASSERT_EQ(fit.status, 0) << fit.err;
  EXPECT_THAT(fit.err, HasSubstr("tracking"));
  const auto summary =
      nlohmann::json::parse(ReadTextFile(folder_->path() / "run" / "summary.json"));
  EXPECT_LT(summary.at("cost").at("after"), summary.at("cost").at("before"));
  // The run knows its observations from anywhere.
  const CommandResult evaluated = Run({"evaluate", "run", "--truth", "rec", "-o", "errors.csv"});
  ASSERT_EQ(evaluated.status, 0) << evaluated.err;
  EXPECT_THAT(evaluated.out, HasSubstr("held out"));
  EXPECT_TRUE(fs::exists(folder_->path() / "errors.csv"));
  EXPECT_THAT(BadInputLine(Run({"evaluate", "run", "--truth", "rec", "-o", "errors.csv"})),
              HasSubstr("--force"));
  EXPECT_THAT(BadInputLine(Run({"evaluate", "run", "--truth", "run/observations"})),
              HasSubstr("nothing to compare with"));
}

TEST_F(Pictures, AreTrackedIntoARecording) {
  const CommandResult tracked = Run({"track", "rec", "-o", "seen", "--no-markers"});
  ASSERT_EQ(tracked.status, 0) << tracked.err;
  EXPECT_THAT(tracked.out, HasSubstr("tracks"));
  EXPECT_EQ(Run({"check", "seen"}).status, 0);
  EXPECT_FALSE(fs::exists(folder_->path() / "seen" / "markers.csv"));
  EXPECT_THAT(BadInputLine(Run({"track", "rec", "-o", "seen"})), HasSubstr("--force"));
  EXPECT_THAT(BadInputLine(Run({"track", "seen", "-o", "again"})),
              HasSubstr("neither images nor videos"));
  EXPECT_THAT(BadInputLine(Run({"track", "rec", "-o", "b", "--window", "4"})), HasSubstr("window"));
}

}  // namespace
}  // namespace clothfit
