// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The command line itself, and the commands that need no fit.
#include <algorithm>
#include <fstream>
#include <sstream>

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

TEST(CommandLine, TellsWhatItIsMadeOf) {
  const TestFolder folder;
  const CommandResult result = RunCommand({"--version", "--verbose"}, folder.path());
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out, StartsWith(RunCommand({"--version"}, folder.path()).out));
  for (const char* library : {"CGAL", "Ceres", "CHOLMOD", "CLI11", "Eigen", "Embree", "fmt",
                              "nlohmann-json", "NLopt", "OpenCV", "yaml-cpp", "zlib"})
    EXPECT_THAT(result.out,
                testing::ContainsRegex("\n" + std::string(library) + " +[0-9]+\\.[0-9]"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\nOpenBLAS +OpenBLAS [0-9]"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\ncompiler +(GCC|Clang) [0-9]+"));
  EXPECT_THAT(result.out, HasSubstr("\ninstruction set "));
  EXPECT_THAT(result.out, HasSubstr("\nReports of bugs: "));
}

// The commands that `help` lists, in its order: lines that are indented by two under a title.
std::vector<std::string> ListedCommands(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help);
  bool is_list = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Options:" || line == "Examples:") is_list = false;
    if (line == "Make and check recordings:" || line == "Commands:") is_list = true;
    const bool is_row = is_list && line.size() > 2 && line[1] == ' ' && line[2] != ' ';
    if (is_row) names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

// No line that a terminal would break, and no word of the parser.
void ExpectPlain(const std::string& help) {
  for (const char* word :
       {"Excludes", "REQUIRED", "Positionals", " x 2", ":INT", "{", "[]", "SUBCOMMAND"})
    EXPECT_THAT(help, testing::Not(HasSubstr(word)));
  std::istringstream lines(help.substr(0, help.find("Example")));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(CommandLine, HelpsOnEveryCommandWithAnExample) {
  const TestFolder folder;
  const CommandResult help = RunCommand({"help"}, folder.path());
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out, RunCommand({"--help"}, folder.path()).out);
  const std::vector<std::string> names = ListedCommands(help.out);
  ASSERT_EQ(names.size(), 22U);
  for (const std::string& name : names) {
    if (name == "help") continue;
    const CommandResult one = RunCommand({"help", name}, folder.path());
    EXPECT_EQ(one.status, 0);
    EXPECT_EQ(one.err, "");
    EXPECT_THAT(one.out, StartsWith("clothfit " + name + ": "));
    EXPECT_THAT(one.out, HasSubstr("\n  clothfit " + name)) << "an example";
    ExpectPlain(one.out);
  }
  EXPECT_EQ(RunCommand({"help", "fit"}, folder.path()).out,
            RunCommand({"fit", "--help"}, folder.path()).out);
  const std::string markers = RunCommand({"help", "import", "markers"}, folder.path()).out;
  EXPECT_THAT(markers, StartsWith("clothfit import markers: "));
  EXPECT_THAT(markers, HasSubstr("Usage: clothfit import markers -o RECORDING FILE [OPTIONS]\n"));
  EXPECT_EQ(RunCommand({"help", "import", "motive"}, folder.path()).out, markers);
}

TEST(CommandLine, GroupsOptionsAndTellsDefaults) {
  const TestFolder folder;
  const std::string fit = RunCommand({"help", "fit"}, folder.path()).out;
  for (const char* title : {"The run:", "The model:", "What is fitted:", "How it is searched:"})
    EXPECT_THAT(fit, HasSubstr("\n" + std::string(title) + "\n"));
  EXPECT_THAT(fit, testing::ContainsRegex("--window S[^-]*\\(default: 0.25\\)"));
  EXPECT_THAT(fit, testing::ContainsRegex("--optimiser NAME[^-]*\\(Lev[^\\)]*\\)"));
  EXPECT_THAT(fit, HasSubstr("(default: lm)"));
}

TEST(CommandLine, TellsDefaultsOfSyntheticRecordings) {
  const TestFolder folder;
  const std::string help = RunCommand({"help", "synthesize"}, folder.path()).out;
  for (const char* title : {"The motion:", "The cloth:", "The observations:", "The pictures:"})
    EXPECT_THAT(help, HasSubstr("\n" + std::string(title) + "\n"));
  for (const char* option : {"--frames N", "--size U V", "--noise M", "--tracks, --no-tracks",
                             "--held-out SHARE", "--picture-size W H", "--video CONTAINER"}) {
    const std::size_t begin = help.find("\n  " + std::string(option));
    ASSERT_NE(begin, std::string::npos) << option;
    EXPECT_THAT(help.substr(begin, help.find("\n  -", begin + 1) - begin), HasSubstr("(default:"));
  }
  EXPECT_THAT(help, HasSubstr("number of frames (default: 90, with --images 150)"));
}

TEST(CommandLine, TakesAnOlderNameOfAnOptionAndDoesNotListIt) {
  const TestFolder folder;
  for (const char* command : {"diagnose", "trials"}) {
    const std::string help = RunCommand({"help", command}, folder.path()).out;
    EXPECT_THAT(help, HasSubstr("--no-nudge"));
    EXPECT_THAT(help, testing::Not(HasSubstr("--no-guide")));
  }
  const std::vector<std::string> list = {"trials", "--list", "unlisted", "--only", "vortex"};
  for (const char* option : {"--no-nudge", "--no-guide"}) {
    std::vector<std::string> words = list;
    words.emplace_back(option);
    EXPECT_EQ(RunCommand(words, folder.path()).status, 0) << option;
  }
}

TEST(CommandLine, TakesTheBeginningsOfCommands) {
  const TestFolder folder;
  const std::string check = RunCommand({"check", "--help"}, folder.path()).out;
  EXPECT_EQ(RunCommand({"ch", "--help"}, folder.path()).out, check);
  EXPECT_EQ(RunCommand({"help", "ch"}, folder.path()).out, check);
  EXPECT_EQ(RunCommand({"im", "mo", "--help"}, folder.path()).out,
            RunCommand({"import", "markers", "--help"}, folder.path()).out);
  EXPECT_THAT(BadInputLine(RunCommand({"s", "rec"}, folder.path())),
              HasSubstr("s: may be synthesize, simulate, study, status"));
  EXPECT_THAT(BadInputLine(RunCommand({"help", "fti"}, folder.path())),
              HasSubstr("fti: did you mean 'fit'?"));
}

TEST(CommandLine, AnswersWrongNamesWithTheNearestRightOne) {
  const TestFolder folder;
  const auto line = [&](const std::vector<std::string>& words) {
    return BadInputLine(RunCommand(words, folder.path()));
  };
  EXPECT_THAT(line({"fti"}), HasSubstr("fti: did you mean 'fit'?"));
  EXPECT_THAT(line({"wash"}),
              HasSubstr("wash: no command of 'clothfit'; 'clothfit help' lists them"));
  EXPECT_THAT(line({"fit", "rec", "--frmes", "3"}), HasSubstr("--frmes: did you mean '--frames'?"));
  EXPECT_THAT(line({"fit", "rec", "--out", "x"}), HasSubstr("--out: did you mean '--output'?"));
  EXPECT_THAT(line({"fit", "rec", "--washing-machine"}),
              HasSubstr("no option of 'clothfit fit'; 'clothfit help fit' lists them"));
  EXPECT_THAT(line({"-v"}), HasSubstr("-v: did you mean '--version'?"));
  EXPECT_THAT(line({"fit", "--version"}),
              HasSubstr("--version: did you mean 'clothfit --version'?"));
  EXPECT_THAT(line({"check", "a", "b"}), HasSubstr("b: one argument too many"));
  EXPECT_THAT(line({}), HasSubstr("expected a command; 'clothfit help' lists them"));
  EXPECT_THAT(line({"import"}), HasSubstr("expected a command; 'clothfit help import' lists them"));
  EXPECT_THAT(line({"fit", "rec", "--window", "abc"}),
              HasSubstr("--window: abc; expected a number"));
}

TEST(CommandLine, ErrorsNameTheOptionThatWasTyped) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(Tiny()), folder.path() / "rec");
  const auto line = [&](const std::string& option, const std::vector<std::string>& values) {
    std::vector<std::string> words = {"fit", "rec", option};
    words.insert(words.end(), values.begin(), values.end());
    return BadInputLine(RunCommand(words, folder.path()));
  };
  EXPECT_THAT(line("--optimiser", {"adam"}),
              HasSubstr("error: --optimiser: adam; expected one of"));
  EXPECT_THAT(line("--resolution", {"2", "1"}), HasSubstr("error: --resolution: 2 1; expected"));
  EXPECT_THAT(line("--frames", {"5", "1"}), HasSubstr("error: --frames: 5 1; expected"));
  EXPECT_THAT(line("--window", {"-1"}), HasSubstr("error: --window: -1; expected 0 or more"));
  EXPECT_THAT(line("--alpha", {"0", "--beta", "0"}),
              HasSubstr("error: --alpha, --beta: both are 0"));
}

TEST(CommandLine, ErrorsNameTheKeyOfASyntheticRecordingThatWasSet) {
  const TestFolder folder;
  folder.Write("made.yaml", "rate: 0\n");
  const auto line = [&](const std::string& option, const std::string& value) {
    return BadInputLine(RunCommand({"synthesize", "-o", "rec", option, value}, folder.path()));
  };
  EXPECT_THAT(line("--frames", "0"), HasSubstr("error: --frames: 0: expected 2 to 1000000"));
  EXPECT_THAT(line("--set", "air_drag.normal=-1"),
              HasSubstr("error: --set: air_drag.normal: -1: expected"));
  EXPECT_THAT(line("--config", "made.yaml"), HasSubstr("error: made.yaml: rate: 0: expected"));
}

TEST(CommandLine, SaysWhatToDoNext) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(Tiny()), folder.path() / "my rec");
  EXPECT_THAT(RunCommand({"check", "my rec"}, folder.path()).out,
              testing::EndsWith("\nnext: clothfit fit 'my rec'\n"));
  const auto last = [&](const std::vector<std::string>& words) {
    const std::string out = RunCommand(words, folder.path()).out;
    return out.substr(out.rfind('\n', out.size() - 2) + 1);
  };
  EXPECT_EQ(last({"terms", "wind"}),
            "next: clothfit fit RECORDING --set wind.x=VALUE --free wind\n");
  EXPECT_EQ(last({"terms", "--all"}),
            "next: clothfit fit RECORDING --set TERM.PARAMETER=VALUE --free TERM\n");
  EXPECT_EQ(last({"trials", "--list", "clean"}), "next: clothfit trials clean -o FOLDER\n");
}

TEST(Terms, ListsEveryParameter) {
  const TestFolder folder;
  const CommandResult table = RunCommand({"terms", "--all"}, folder.path());
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

TEST(Terms, ListsThemFirstAndEachOnRequest) {
  const TestFolder folder;
  const std::string list = RunCommand({"terms"}, folder.path()).out;
  for (const TermInfo& term : AllTerms()) EXPECT_THAT(list, HasSubstr(term.name + " "));
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), static_cast<int>(AllTerms().size()) + 2);
  const std::string obstacle = RunCommand({"terms", "obstacle"}, folder.path()).out;
  EXPECT_THAT(obstacle, HasSubstr("\nobstacle: "));
  EXPECT_THAT(obstacle, testing::Not(HasSubstr("bending")));
  EXPECT_THAT(BadInputLine(RunCommand({"terms", "obstacel"}, folder.path())),
              HasSubstr("TERM: 'obstacel': did you mean 'obstacle'?"));
}

TEST(Check, KnowsAFileFromARecording) {
  const TestFolder folder;
  std::ofstream(folder.path() / "take.csv") << "Format Version,1.23\n";
  EXPECT_THAT(BadInputLine(RunCommand({"check", "take.csv"}, folder.path())),
              HasSubstr("take.csv: is a file; 'clothfit import' makes a recording of it"));
}

TEST(Export, GoesByTheNameOfTheFile) {
  const TestFolder folder;
  WriteRecording(MakeSmallRecording(Tiny()), folder.path() / "rec");
  ASSERT_EQ(RunCommand({"simulate", "rec", "-o", "run"}, folder.path()).status, 0);
  EXPECT_EQ(RunCommand({"export", "run", "-o", "a.glb"}, folder.path()).status, 0);
  EXPECT_THAT(ReadTextFile(folder.path() / "a.glb"), StartsWith("glTF"));
  EXPECT_THAT(BadInputLine(
                  RunCommand({"export", "run", "--format", "gltf", "-o", "a.gltf"}, folder.path())),
              HasSubstr("a.gltf: expected a name that ends in .glb"));
  EXPECT_THAT(BadInputLine(RunCommand({"export", "run", "-o", "a.xyz"}, folder.path())),
              HasSubstr("--format: is missing"));
}

TEST(Export, SaysWhatEachFormatIs) {
  const TestFolder folder;
  const std::string help = RunCommand({"help", "export"}, folder.path()).out;
  for (const char* row :
       {"gltf    .glb: binary glTF 2.0", "usda    .usda: Universal Scene Description as text",
        "mdd     .mdd: point cache of LightWave", "npy     .npy: NumPy array, float64",
        "blender .py: the cloth as a script"})
    EXPECT_THAT(help, HasSubstr("\n  " + std::string(row)));
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
