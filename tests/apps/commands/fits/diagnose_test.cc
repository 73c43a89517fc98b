// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The options of clothfit diagnose.
#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

struct DiagnoseCommand : testing::Test {
  DiagnoseCommand() {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 12;
    WriteRecording(MakeSmallRecording(options), folder_.path() / "rec");
  }
  // Of a config that has two unknowns and no air that could be missing.
  CommandResult Diagnose(const std::vector<std::string>& more) {
    std::vector<std::string> words = {
        "diagnose", "rec",      "-o", "out",   "--max-effects", "1",     "--max-models",
        "1",        "--finest", "4",  "--fix", "stretch",       "--fix", "shear"};
    words.insert(words.end(), more.begin(), more.end());
    return RunCommand(words, folder_.path());
  }
  TestFolder folder_;
};

TEST_F(DiagnoseCommand, FitsTheFramesThatAreAskedFor) {
  const CommandResult result = Diagnose({"--frames", "0", "6", "--quiet"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(ReadTextFile(folder_.path() / "out" / "config.yaml"), HasSubstr("frames: [0, 6]"));
  // The fit that it was read from leaves the others out.
  EXPECT_THAT(ReadTextFile(folder_.path() / "out" / "fit" / "summary.json"),
              HasSubstr("\"fitted\": 7"));
}

TEST_F(DiagnoseCommand, RefusesFramesThatCannotBeFitted) {
  EXPECT_THAT(BadInputLine(Diagnose({"--frames", "5", "1"})),
              HasSubstr("error: --frames: 5 1; expected"));
  EXPECT_THAT(BadInputLine(Diagnose({"--frames", "0", "12"})),
              HasSubstr("--frames (observations.frames): 0 12; expected first <= last within 0 "
                        "to 11"));
  EXPECT_THAT(BadInputLine(Diagnose({"--frames", "11", "11"})), HasSubstr("nothing to fit"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

}  // namespace
}  // namespace clothfit
