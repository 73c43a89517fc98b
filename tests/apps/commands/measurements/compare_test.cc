// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Optimisers side by side, and fits by others than Levenberg-Marquardt.
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

// Two free parameters: --fix and --free as a user would.
const std::vector<std::string> kTwoFree = {"--fix",  "stretch",
                                           "--fix",  "shear",
                                           "--fix",  "bending",
                                           "--free", "bending.stiffness",
                                           "--fix",  "air_drag.tangential"};

class CompareCommand : public testing::Test {
 protected:
  CompareCommand() {
    SmallRecordingOptions options;
    options.particles = 5;
    options.frames = 20;
    WriteRecording(MakeSmallRecording(options), folder_.path() / "rec");
  }
  CommandResult Run(std::vector<std::string> words) const {
    words.insert(words.end(), kTwoFree.begin(), kTwoFree.end());
    return RunCommand(words, folder_.path());
  }
  CommandResult Compare(std::vector<std::string> more) const {
    std::vector<std::string> words = {"compare",           "rec", "-o",       "cmp",
                                      "--max-simulations", "30",  "--starts", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

  TestFolder folder_;
};

TEST_F(CompareCommand, WritesTablesCurvesAndAPicture) {
  const CommandResult compared = Compare({"--contenders", "lm,bobyqa,pattern"});
  ASSERT_EQ(compared.status, 0) << compared.err;
  EXPECT_THAT(compared.out, HasSubstr("| pattern/joint |"));
  const fs::path folder = folder_.path() / "cmp";
  for (const char* file : {"comparison.md", "comparison.svg", "comparison.json", "config.yaml"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  int runs = 0;
  ReadCsv(folder / "history.csv", {"contender", "start", "simulations", "seconds", "error"},
          [](const CsvRow&) {});
  ReadCsv(folder / "runs.csv",
          {"contender", "start", "error", "open_loop_error", "truth_rms", "simulations", "seconds",
           "converged", "reason"},
          [&](const CsvRow&) { ++runs; });
  EXPECT_EQ(runs, 6);
  // It is not overwritten by chance, but gone on with.
  EXPECT_THAT(BadInputLine(Compare({"--contenders", "lm,bobyqa,pattern"})), HasSubstr("--force"));
  const std::string before = ReadTextFile(folder / "runs.csv");
  ASSERT_EQ(Compare({"--contenders", "lm,bobyqa,pattern", "--resume"}).status, 0);
  EXPECT_EQ(ReadTextFile(folder / "runs.csv"), before);
  EXPECT_THAT(BadInputLine(Compare({"--resume", "--spread", "0.1"})), HasSubstr("--resume"));
}

TEST_F(CompareCommand, NamesWhatIsWrong) {
  EXPECT_THAT(BadInputLine(Compare({"--contenders", "newton"})),
              HasSubstr("--contenders: 'newton': expected OPTIMISER"));
  EXPECT_THAT(BadInputLine(Compare({"--contenders", "lm/fast"})), HasSubstr("'fast'"));
  EXPECT_THAT(BadInputLine(Compare({"--spread", "-1"})), HasSubstr("--spread"));
  EXPECT_FALSE(fs::exists(folder_.path() / "cmp"));
}

TEST_F(CompareCommand, FitsByOtherOptimisers) {
  const CommandResult fitted =
      Run({"fit", "rec", "-o", "run", "--optimiser", "sbplx", "--max-simulations", "50"});
  ASSERT_EQ(fitted.status, 0) << fitted.err;
  const nlohmann::json summary =
      nlohmann::json::parse(ReadTextFile(folder_.path() / "run" / "summary.json"));
  EXPECT_LT(summary.at("fit").at("marker_rms_m").get<double>(),
            summary.at("before").at("fit").at("marker_rms_m").get<double>());
  EXPECT_THAT(ReadTextFile(folder_.path() / "run" / "log.txt"), HasSubstr("sbplx/joint"));
  EXPECT_THAT(BadInputLine(Run({"fit", "rec", "-o", "x", "--optimiser", "newton"})),
              HasSubstr("--optimiser: newton; expected one of lm"));
  EXPECT_THAT(BadInputLine(Run({"fit", "rec", "-o", "x", "--strategy", "three-loop"})),
              HasSubstr("--strategy: 'three-loop': expected one of joint"));
}

}  // namespace
}  // namespace clothfit
