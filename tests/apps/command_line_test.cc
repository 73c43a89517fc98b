// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line itself, and the commands that need no fit.
#include <nlohmann/json.hpp>

#include "autodiff_sim/terms/parameter_table.h"
#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::StartsWith;

const char* const kCommands[] = {"fit",   "simulate",  "predict", "check",
                                 "terms", "gradcheck", "report",  "export"};

SmallRecordingOptions Tiny() {
  SmallRecordingOptions options;
  options.particles = 5;
  options.frames = 10;
  return options;
}

TEST(CommandLine, TellsItsVersion) {
  const TestFolder folder;
  const CommandResult result = RunCommand({"--version"}, folder.path());
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, StartsWith(std::string("clothfit ") + CLOTHFIT_VERSION));
  EXPECT_EQ(result.err, "");
}

TEST(CommandLine, HelpsOnEverythingWithAnExample) {
  const TestFolder folder;
  const CommandResult help = RunCommand({"--help"}, folder.path());
  EXPECT_EQ(help.status, 0);
  for (const char* name : kCommands) {
    EXPECT_THAT(help.out, HasSubstr(name));
    const CommandResult one = RunCommand({name, "--help"}, folder.path());
    EXPECT_EQ(one.status, 0);
    EXPECT_EQ(one.err, "");
    EXPECT_THAT(one.out, HasSubstr("Example"));
    EXPECT_THAT(one.out, HasSubstr(std::string("\n  clothfit ") + name));
  }
}

TEST(CommandLine, AnswersWrongNamesWithTheNearestRightOne) {
  const TestFolder folder;
  EXPECT_THAT(BadInputLine(RunCommand({"fti"}, folder.path())),
              HasSubstr("fti: did you mean 'fit'?"));
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "rec", "--frmes", "3"}, folder.path())),
              HasSubstr("--frmes: did you mean '--frames'?"));
  EXPECT_THAT(BadInputLine(RunCommand({"check", "a", "b"}, folder.path())),
              HasSubstr("b: one argument too many"));
  EXPECT_THAT(BadInputLine(RunCommand({}, folder.path())), HasSubstr("subcommand is required"));
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "rec", "--window", "abc"}, folder.path())),
              HasSubstr("--window"));
}

TEST(Terms, ListsEveryParameter) {
  const TestFolder folder;
  const CommandResult table = RunCommand({"terms"}, folder.path());
  const CommandResult json = RunCommand({"terms", "--json"}, folder.path());
  EXPECT_EQ(table.status, 0);
  EXPECT_EQ(json.status, 0);
  const nlohmann::json parsed = nlohmann::json::parse(json.out);
  EXPECT_EQ(parsed.at("terms").size(), AllTerms().size());
  EXPECT_EQ(parsed.at("terms")[0].at("parameters")[0].at("name"), "gravity.scale");
  EXPECT_THAT(table.out, HasSubstr("relaxation time (tried: 0.1, 1, 10, 100)"));
  EXPECT_THAT(table.out, HasSubstr("when it begins (tried at shares: 0, 0.25, 0.5, 0.75)"));
  for (const NamedParameter& named : MakeParameterTable()) {
    EXPECT_THAT(table.out, HasSubstr("  " + named.name + " "));
    EXPECT_THAT(json.out, HasSubstr("\"" + named.name + "\""));
  }
}

TEST(Check, SummarisesARecording) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(Tiny()), folder.path() / "rec");
  const CommandResult result = RunCommand({"check", "rec"}, folder.path());
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("10 at 30 Hz"));
  EXPECT_THAT(result.out, HasSubstr("160 positions of 16 points"));
  EXPECT_EQ(result.err, "");
}

TEST(Check, WarnsOfWhatIsAssumed) {
  const TestFolder folder;
  Recording recording = MakeSmallRecording(Tiny());
  recording.cloth.areal_density.reset();
  WriteRecording(recording, folder.path() / "rec");
  const CommandResult result = RunCommand({"check", "rec"}, folder.path());
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("clothfit: warning: areal density"));
}

TEST(Simulate, WritesATrajectory) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(Tiny()), folder.path() / "rec");
  const std::vector<std::string> words = {"simulate", "rec", "-o",    "out",
                                          "--frames", "4",   "--set", "air_drag.normal=2"};
  const CommandResult result = RunCommand(words, folder.path());
  EXPECT_EQ(result.status, 0) << result.err;
  const fs::path out = folder.path() / "out";
  EXPECT_THAT(ReadTextFile(out / "trajectory.npy"), HasSubstr("'shape': (4, 25, 3)"));
  EXPECT_THAT(ReadTextFile(out / "mesh.obj"), HasSubstr("vt 0.4 0.4\n"));
  EXPECT_THAT(ReadTextFile(out / "config.yaml"), HasSubstr("air_drag.normal: {value: 2,"));

  EXPECT_THAT(BadInputLine(RunCommand(words, folder.path())), HasSubstr("--force replaces it"));
  std::vector<std::string> forced = words;
  forced.emplace_back("--force");
  EXPECT_EQ(RunCommand(forced, folder.path()).status, 0);
  EXPECT_THAT(
      BadInputLine(RunCommand({"simulate", "rec", "-o", "b", "--frames", "11"}, folder.path())),
      HasSubstr("--frames: 11: expected 1 to 10"));
}

TEST(Simulate, CountsWhatPassesThroughObstacles) {
  const TestFolder folder;
  Recording recording = MakeSmallRecording(Tiny());
  ObstacleDescription ball{"ball", BallShape{0.1}, {{}}};
  ball.path[0].position = {0.21, 0.19, 0.85};  // the cloth falls from z = 1 m
  recording.obstacles = {ball};
  WriteRecording(recording, folder.path() / "rec");
  std::vector<std::string> words = {"simulate",      "rec", "-o", "on", "--check-intersections",
                                    "--self-contact"};
  const CommandResult on = RunCommand(words, folder.path());
  EXPECT_EQ(on.status, 0) << on.err;
  EXPECT_THAT(on.out, HasSubstr("intersections after any step: 0"));
  EXPECT_THAT(ReadTextFile(folder.path() / "on" / "log.txt"), HasSubstr("contact: at most"));
  EXPECT_THAT(ReadTextFile(folder.path() / "on" / "report" / "obstacles.json"),
              HasSubstr("\"name\":\"ball\",\"positions\":\"obstacle_0.npy\""));
  EXPECT_THAT(ReadTextFile(folder.path() / "on" / "config.yaml"), HasSubstr("self_contact: true"));
  words[3] = "off";
  words.insert(words.end(), {"--without", "obstacle"});
  const CommandResult off = RunCommand(words, folder.path());
  EXPECT_EQ(off.status, 1);
  EXPECT_THAT(off.err, HasSubstr("the cloth passes through"));
}

TEST(Gradcheck, FindsTheDerivativesRight) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(Tiny()), folder.path() / "rec");
  const CommandResult result = RunCommand({"gradcheck", "rec", "--frames", "4", "--parameters",
                                           "air_drag", "--set", "air_drag.saturation=0.1"},
                                          folder.path());
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, testing::ContainsRegex("air_drag.saturation .* agrees"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("bending")));
}

}  // namespace
}  // namespace clothfit
