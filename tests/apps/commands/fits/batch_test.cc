// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Many recordings, one table.
#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class BatchCommand : public testing::Test {
 protected:
  BatchCommand() {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 10;
    WriteRecording(MakeSmallRecording(options), folder_.path() / "silk");
    folder_.Write(
        "common.yaml",
        "strategy: {max_iterations: 2}\nparameters:\n  stretch.stiffness: {free: false}\n");
  }
  CommandResult Batch(const std::string& list, const std::vector<std::string>& more = {}) const {
    folder_.Write("list.yaml", list);
    std::vector<std::string> words = {"batch", "list.yaml", "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return RunCommand(words, folder_.path());
  }

  TestFolder folder_;
};

constexpr const char* kTwo =
    "config: common.yaml\nfits:\n  - recording: silk\n  - recording: silk\n    name: stiff\n"
    "    set: {bending.stiffness: 1e-2}\n    fix: [bending]\n";

TEST_F(BatchCommand, FitsAllIntoOneTable) {
  const CommandResult done = Batch(kTwo, {"--threads", "1"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("| silk |"));
  const fs::path out = folder_.path() / "out";
  const std::string table = ReadTextFile(out / "batch.csv");
  EXPECT_THAT(table, HasSubstr("\nstiff,"));
  EXPECT_TRUE(fs::exists(out / "runs" / "silk" / "summary.json"));
  const std::string parameters = ReadTextFile(out / "parameters.csv");
  EXPECT_THAT(parameters, HasSubstr("\nsilk,bending.stiffness,"));
  EXPECT_THAT(parameters, testing::Not(HasSubstr("stiff,bending.stiffness,")));
  EXPECT_THAT(parameters, testing::Not(HasSubstr("stretch.stiffness,")));
  // Not overwritten by chance, but gone on with, and the same whoever does it.
  EXPECT_THAT(BadInputLine(Batch(kTwo)), HasSubstr("--force"));
  fs::remove(out / "jobs" / "stiff.json");
  ASSERT_EQ(Batch(kTwo, {"--resume", "--threads", "2"}).status, 0);
  EXPECT_EQ(ReadTextFile(out / "batch.csv"), table);
  EXPECT_THAT(BadInputLine(Batch("fits:\n  - recording: silk\n", {"--resume"})),
              HasSubstr("--resume"));
}

TEST_F(BatchCommand, NamesWhatIsWrongBeforeItBegins) {
  EXPECT_THAT(BadInputLine(Batch("fits: []\n")), HasSubstr("fits"));
  EXPECT_THAT(BadInputLine(Batch("fits:\n  - recording: none\n")), HasSubstr("none"));
  EXPECT_THAT(BadInputLine(Batch("fits:\n  - recording: silk\n  - recording: silk\n")),
              HasSubstr("another fit is called 'silk'"));
  EXPECT_THAT(BadInputLine(Batch("fits:\n  - recording: silk\n    name: a/b\n")),
              HasSubstr("'a/b'"));
  EXPECT_THAT(BadInputLine(Batch("fits:\n  - recording: silk\n    set: {bending.stifness: 1}\n")),
              HasSubstr("bending.stiffness"));
  EXPECT_THAT(BadInputLine(Batch("fits:\n  - recording: silk\n    speed: 3\n")),
              HasSubstr("speed"));
  EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

}  // namespace
}  // namespace clothfit
