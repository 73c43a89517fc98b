// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A page in a folder of results is clothfit's where `clothfit report` wrote it, and else
// somebody's.
#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/files/folder_lock.h"
#include "tracking/files/manifest.h"
#include "tracking/recording/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using Words = std::vector<std::string>;

class KeptPages : public testing::Test {
 protected:
  KeptPages() {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 10;
    WriteRecording(MakeSmallRecording(options), folder_.path() / "rec");
    EXPECT_EQ(Fit().status, 0);
  }
  CommandResult Run(const Words& words) const { return RunCommand(words, folder_.path()); }
  CommandResult Fit() const {
    return Run({"fit", "rec", "-o", "run", "--max-iterations", "0", "--window", "0", "--quiet",
                "--force"});
  }
  fs::path run() const { return folder_.path() / "run"; }

  TestFolder folder_;
};

TEST_F(KeptPages, OneOfSomebodyElseStays) {
  const fs::path mine = folder_.Write("run/report.html", "mine");
  for (const Words& words : {Words{"report", "run"}, Words{"report", "run", "--force"}})
    EXPECT_THAT(BadInputLine(Run(words)),
                HasSubstr("report.html: exists already and is not replaced, since 'report' did"));
  EXPECT_EQ(Fit().status, 0);
  EXPECT_EQ(ReadTextFile(mine), "mine");
}

TEST_F(KeptPages, OneOfReportIsReplacedAndGoesWithTheRun) {
  EXPECT_FALSE(ReadManifest(run())->Lists("report.html"));
  for (const Words& words : {Words{"report", "run"}, Words{"report", "run", "--force"},
                             Words{"report", "run", "-o", "run/other.html"}})
    ASSERT_EQ(Run(words).status, 0);
  EXPECT_TRUE(ReadManifest(run())->Lists("report.html"));
  EXPECT_EQ(Fit().status, 0);
  for (const char* name : {"report.html", "other.html"}) EXPECT_FALSE(fs::exists(run() / name));
}

TEST_F(KeptPages, NoneIsWrittenIntoAFolderThatIsUnderWay) {
  const FolderLock lock(run(), FolderLock::Kind::kAlone);
  EXPECT_THAT(BadInputLine(Run({"report", "run"})), HasSubstr("run: another clothfit is writing"));
  EXPECT_FALSE(fs::exists(run() / "report.html"));
  EXPECT_EQ(Run({"report", "run", "-o", "page.html"}).status, 0);
}

}  // namespace
}  // namespace clothfit
