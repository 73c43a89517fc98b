// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit report and clothfit export, as a user calls them.
#include "tests/apps/command.h"
#include "tests/support/small_run.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class ReportCommand : public testing::Test {
 protected:
  ReportCommand() { MakeSmallRun(folder_.path()); }
  CommandResult Run(const std::vector<std::string>& words) const {
    return RunCommand(words, folder_.path());
  }
  TestFolder folder_;
};

TEST_F(ReportCommand, WritesAPageIntoTheRun) {
  const CommandResult result = Run({"report", "run"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("The markers are off by"));
  EXPECT_THAT(result.out, HasSubstr("report: run/report.html ("));
  const std::string page = ReadTextFile(folder_.path() / "run" / "report.html");
  EXPECT_THAT(page, HasSubstr("three.js"));  // the bundle with its licences
  EXPECT_THAT(BadInputLine(Run({"report", "run"})), HasSubstr("--force replaces it"));
  EXPECT_EQ(Run({"report", "run", "--force"}).status, 0);
  EXPECT_EQ(Run({"report", "run", "-o", "other.html"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_.path() / "other.html"));
}

TEST_F(ReportCommand, ShowsARecordingBeforeItIsFitted) {
  const CommandResult result = Run({"report", "rec"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("report: rec.html ("));
  const std::string page = ReadTextFile(folder_.path() / "rec.html");
  for (const char* words : {"What it holds", "Markers seen", "Default material", "path known in"})
    EXPECT_THAT(page, HasSubstr(words));
  EXPECT_FALSE(fs::exists(folder_.path() / "rec" / "report.html"));
}

TEST_F(ReportCommand, ComparesTwoRuns) {
  fs::copy(folder_.path() / "run", folder_.path() / "again", fs::copy_options::recursive);
  const CommandResult result = Run({"report", "run", "again"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("run and again predict the held-out frames equally"));
  EXPECT_THAT(result.out, HasSubstr("All settings are the same."));
  EXPECT_THAT(result.out, HasSubstr("report: run-again.html ("));
  EXPECT_TRUE(fs::exists(folder_.path() / "run-again.html"));
  EXPECT_FALSE(fs::exists(folder_.path() / "run" / "report.html"));
  EXPECT_THAT(BadInputLine(Run({"report", "run", "again"})), HasSubstr("--force replaces it"));
  EXPECT_EQ(Run({"report", "run", "again", "-o", "both.html"}).status, 0);
  EXPECT_THAT(BadInputLine(Run({"report", "run", "run", "-o", "a.html"})),
              HasSubstr("is the same run as run"));
  EXPECT_THAT(BadInputLine(Run({"report", "run", "rec", "-o", "a.html"})),
              HasSubstr("rec: is a recording; 'clothfit report rec' shows it"));
  EXPECT_THAT(BadInputLine(Run({"report", "run", "none", "-o", "a.html"})),
              HasSubstr("none: no such folder"));
  EXPECT_THAT(BadInputLine(Run({"report", "run", "", "-o", "a.html"})), HasSubstr("OTHER"));
  fs::remove(folder_.path() / "again" / "trajectory.npy");
  EXPECT_THAT(BadInputLine(Run({"report", "run", "again", "-o", "a.html"})),
              HasSubstr("again/trajectory.npy: is missing"));
}

TEST_F(ReportCommand, SaysInOneLineWhatIsWrong) {
  EXPECT_THAT(BadInputLine(Run({"report", "run", "--pictures", "none"})), HasSubstr("none"));
  EXPECT_THAT(BadInputLine(Run({"report", "run", "-o", "none/a.html"})),
              HasSubstr("none: no such folder"));
  fs::remove(folder_.path() / "run" / "summary.json");
  EXPECT_THAT(BadInputLine(Run({"report", "run"})),
              HasSubstr("run/summary.json: is missing; expected the run of a fit that has ended"));
}

TEST_F(ReportCommand, ExportsAndRefusesToOverwrite) {
  const CommandResult result = Run({"export", "run", "--format", "gltf", "-o", "a.glb"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "12 frames: a.glb\nnext: open a.glb, in Blender for example\n");
  EXPECT_THAT(BadInputLine(Run({"export", "run", "--format", "gltf", "-o", "a.glb"})),
              HasSubstr("--force replaces it"));
  EXPECT_THAT(BadInputLine(Run({"export", "run", "--format", "glft", "-o", "b.glb"})),
              HasSubstr("did you mean 'gltf'?"));
  EXPECT_THAT(BadInputLine(Run({"export", "run", "-o", "cloth.py"})),
              HasSubstr("--format: is missing: .py may be newton, blender"));
  EXPECT_EQ(Run({"export", "run", "-o", "cloth.xml"}).status, 0);
  EXPECT_EQ(Run({"export", "run", "--format", "obj", "-o", "frames"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_.path() / "frames" / "000011.obj"));
}

}  // namespace
}  // namespace clothfit
