// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Bad input is told in one line that names the place; nothing is left behind.
#include <algorithm>
#include <csignal>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/apps/command.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 6;
    recording_ = MakeSmallRecording(options);
    WriteRecording(recording_, path() / "rec");
  }

  const fs::path& path() const { return folder_.path(); }

  // The line with which a fit refuses; no run is made then.
  std::string FitLine(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"fit", "rec", "-o", "run"};
    words.insert(words.end(), more.begin(), more.end());
    const std::string line = BadInputLine(RunCommand(words, path()));
    EXPECT_FALSE(fs::exists(path() / "run"));
    return line;
  }

  void Replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = ReadTextFile(path() / file);
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    folder_.Write(file, text.replace(at, from.size(), to));
  }

  void UseMesh(const std::string& obj) {
    recording_.cloth.initial = MeshPlacement{folder_.Write("cloth.obj", obj)};
    WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  }

  TestFolder folder_;
  Recording recording_;
};

TEST_F(BadInput, MissingFolderAndFile) {
  EXPECT_THAT(BadInputLine(RunCommand({"check", "nowhere"}, path())), HasSubstr("nowhere"));
  EXPECT_THAT(FitLine({"--config", "gone.yaml"}), HasSubstr("gone.yaml: no such file"));
  fs::remove(path() / "rec" / "handles" / "left.csv");
  EXPECT_THAT(FitLine(), testing::ContainsRegex("handles\\[0\\].path: no such file: .*left.csv"));
}

TEST_F(BadInput, WrongKeyOfTheRecording) {
  Replace("rec/recording.yaml", "frame_rate", "framerate");
  EXPECT_THAT(FitLine(), HasSubstr("framerate: unknown key; did you mean 'frame_rate'?"));
}

TEST_F(BadInput, ContactThatCannotBegin) {
  ObstacleDescription ball{"ball", BallShape{0.1}, {{}}};
  ball.path[0].position = {0.2, 0.2, 1.05};  // the cloth lies at z = 1 m
  recording_.obstacles = {ball};
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  EXPECT_THAT(FitLine(), HasSubstr("recording.yaml: obstacles: ball: the cloth is in it"));
  recording_.obstacles.clear();
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  const std::string line =
      FitLine({"--self-contact", "--set", "contact.thickness=0.02", "--resolution", "30", "30"});
  EXPECT_THAT(line, HasSubstr("contact.thickness: 0.020000 m; expected at most"));
  recording_.ground_height = 100.0;
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  EXPECT_THAT(FitLine({"--self-contact"}), HasSubstr("recording.yaml: ground.height: "));
}

TEST_F(BadInput, NanInAnObservation) {
  Replace("rec/markers.csv", "\n1,", "\n1,0,0,0,nan,0,0\n1,");
  EXPECT_THAT(FitLine(), testing::ContainsRegex("markers.csv: line [0-9]+: x: expected a finite"));
}

TEST_F(BadInput, MarkerOutsideTheCloth) {
  Replace("rec/markers.csv", "\n1,", "\n1,99,0.41,0,0,0,0\n1,");
  EXPECT_THAT(FitLine(), HasSubstr("u = 0.41 is outside the cloth"));
}

TEST_F(BadInput, FrameOutsideTheRecording) {
  Replace("rec/markers.csv", "\n1,", "\n6,99,0,0,0,0,0\n1,");
  EXPECT_THAT(FitLine(), HasSubstr("frame 6 is outside 0..5"));
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  EXPECT_THAT(FitLine({"--frames", "0", "6"}), HasSubstr("expected first <= last within 0 to 5"));
  EXPECT_THAT(FitLine({"--every", "0"}), HasSubstr("--every: 0; expected an integer from 1"));
  EXPECT_THAT(FitLine({"--threads", "-1"}), HasSubstr("--threads: -1; expected"));
  EXPECT_THAT(FitLine({"--finest", "-1"}), HasSubstr("--finest: -1; expected an integer from 0"));
}

TEST_F(BadInput, NothingObserved) {
  fs::remove(path() / "rec" / "markers.csv");
  EXPECT_THAT(FitLine(), HasSubstr("rec"));
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  EXPECT_THAT(FitLine({"--frames", "5", "5"}), HasSubstr("nothing to fit"));  // held out
}

TEST_F(BadInput, DegenerateAndFlippedTriangles) {
  const std::string vertices =
      "v 0 0 1\nv 0.4 0 1\nv 0 0.4 1\nv 0.4 0.4 1\nvt 0 0\nvt 0.4 0\nvt 0 0.4\nvt 0.4 0.4\n";
  UseMesh(vertices + "f 1/1 2/2 3/3\nf 2/2 3/3 4/4\n");
  EXPECT_THAT(FitLine(), HasSubstr("cloth.obj"));
  UseMesh(vertices + "vt 0.8 0\nf 1/1 2/2 3/3\nf 2/2 4/5 1/1\n");
  EXPECT_THAT(FitLine(), HasSubstr("cloth.obj"));
}

TEST_F(BadInput, HandlesOfTheSameParticle) {
  recording_.handles.push_back(recording_.handles.front());
  recording_.handles.back().name = "twin";
  recording_.handles.back().uv = {1e-6, 1e-6};
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  EXPECT_THAT(FitLine(), HasSubstr("handles"));
}

TEST_F(BadInput, ParametersByWrongNamesAndOutOfBounds) {
  EXPECT_THAT(FitLine({"--set", "air_drag.norml=1"}),
              HasSubstr("--set: 'air_drag.norml': did you mean 'air_drag.normal'?"));
  EXPECT_THAT(FitLine({"--set", "tangential=1"}), HasSubstr("did you mean 'air_drag.tangential'?"));
  EXPECT_THAT(FitLine({"--set", "air_drag.normal=50"}),
              HasSubstr("--set: air_drag.normal = 50 kg/m^3: expected 0.001 to 20"));
  EXPECT_THAT(FitLine({"--set", "air_drag.normal"}), HasSubstr("expected air_drag.normal=NUMBER"));
  EXPECT_THAT(FitLine({"--without", "air_drg"}), HasSubstr("did you mean 'air_drag'?"));
  EXPECT_THAT(FitLine({"--fix", "bendng"}), HasSubstr("--fix: 'bendng': did you mean 'bending'?"));
  EXPECT_THAT(FitLine({"--without", "air_drag", "--free", "air_drag.normal"}),
              HasSubstr("a free parameter starts inside its bounds"));
  EXPECT_THAT(FitLine({"--free", "bending", "--fix", "bending"}), HasSubstr("named by --fix too"));
}

TEST_F(BadInput, OptionsOutOfRange) {
  EXPECT_THAT(FitLine({"--window", "-1"}), HasSubstr("--window: -1; expected 0 or more"));
  EXPECT_THAT(FitLine({"--initial-order", "3"}), HasSubstr("--initial-order: 3; expected"));
  EXPECT_THAT(FitLine({"--resolution", "1", "9"}), HasSubstr("--resolution: 1 9; expected"));
  EXPECT_THAT(FitLine({"--loss", "hubr"}), HasSubstr("--loss"));
}

TEST_F(BadInput, WrongKeyAndValueOfAConfig) {
  folder_.Write("fit.yaml", "strategy: {windw: 1}\n");
  EXPECT_THAT(FitLine({"--config", "fit.yaml"}),
              HasSubstr("fit.yaml: strategy.windw: unknown key; did you mean 'window'?"));
  folder_.Write("fit.yaml", "parameters: {air_drag.normal: {value: -1}}\n");
  EXPECT_THAT(FitLine({"--config", "fit.yaml"}),
              HasSubstr("fit.yaml: parameters.air_drag.normal.value: -1"));
}

TEST_F(BadInput, OutputThatCannotBeMade) {
  folder_.Write("file", "");
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "rec", "-o", "file"}, path())),
              HasSubstr("file: is a file; expected a folder"));
  EXPECT_THAT(BadInputLine(RunCommand({"fit", "rec", "-o", "file/run"}, path())),
              HasSubstr("file/run: cannot be made"));
}

TEST_F(BadInput, FullDiskWhilePredicting) {
  ASSERT_EQ(RunCommand({"fit", "rec", "-o", "run", "--max-iterations", "0"}, path()).status, 0);
  std::string points = "frame,u,v\n";
  for (int i = 0; i < 100; ++i) points += "1,0,0\n";
  folder_.Write("points.csv", points);
  // Room for the error's line, not for the table.
  const auto limit_files = [] {
    const rlimit limit = {500, 500};
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  EXPECT_THAT(BadInputLine(RunCommand({"predict", "run", "--at", "points.csv", "-o", "out.csv"},
                                      path(), limit_files)),
              HasSubstr("out.csv: cannot be written: File too large"));
  EXPECT_FALSE(fs::exists(path() / "out.csv"));
  for (const fs::directory_entry& entry : fs::directory_iterator(path()))
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos);
}

TEST_F(BadInput, FilesTooLargeWhileFitting) {
  // Room for the config and the log, not for the trajectory.
  const auto limit_files = [] {
    const rlimit limit = {6000, 6000};
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  const CommandResult result = RunCommand(
      {"fit", "rec", "-o", "run", "--max-iterations", "0", "--quiet"}, path(), limit_files);
  EXPECT_THAT(BadInputLine(result), HasSubstr(": cannot be written: File too large"));
  EXPECT_FALSE(fs::exists(path() / "run" / "summary.json"));
}

TEST_F(BadInput, FullStandardOutput) {
  const CommandResult result = RunCommand({"terms"}, path(), [] {
    if (std::freopen("/dev/full", "w", stdout) == nullptr) _exit(127);
  });
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("standard output: cannot be written"));
}

// What broke commands once, or would have.
TEST_F(BadInput, SizesBeyondReason) {
  const auto refuses = [&](const std::string& from, const std::string& to,
                           const std::string& because) {
    WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
    std::string text = ReadTextFile(path() / "rec" / "recording.yaml");
    const std::size_t at = text.find(from + ": ");
    ASSERT_NE(at, std::string::npos) << from;
    const std::size_t end = text.find('\n', at);
    folder_.Write("rec/recording.yaml", text.replace(at, end - at, from + ": " + to));
    const CommandResult result = RunCommand({"check", "rec"}, path());
    EXPECT_THAT(BadInputLine(result), HasSubstr(because)) << to;
    EXPECT_LT(result.most_memory, 1e9) << to;
  };
  refuses("resolution", "[100000, 100000]", "cloth.resolution: expected 2 to 1000 particles");
  refuses("frame_count", "10000000", "frame_count: expected 1..1000000, found 10000000");
  refuses("frame_rate", "1e-320", "frame_rate: expected 0.01 to 100000, found 1e-320");
  refuses("gravity", "[0, 0, -1e308]", "gravity: expected at most 1000 m/s^2");
  refuses("size", "[0.4, 1e10]", "cloth.size[1]: expected 0.0001 to 1000");
  refuses("name", "\"a\\x1b[2J\"", "name: 'a\\x1b[2J'; expected UTF-8 without control characters");
  refuses("name", "\"a\\u202eb\"", "a\\u202eb");
}

TEST_F(BadInput, WarnsOfSizesThatMayBeMeant) {
  recording_.cloth.size = {0.4, 40.0};
  WriteRecording(recording_, path() / "rec", Overwrite::kAllow);
  const CommandResult result = RunCommand({"check", "rec"}, path());
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("clothfit: warning: the cloth is 0.4 x 40 m; is that meant?"));
}

TEST_F(BadInput, FilesThatAreNone) {
  const fs::path markers = path() / "rec" / "markers.csv";
  const auto line = [&] { return BadInputLine(RunCommand({"check", "rec"}, path())); };
  fs::remove(markers);
  ASSERT_EQ(mkfifo(markers.c_str(), 0600), 0);
  EXPECT_THAT(line(), HasSubstr("markers.csv: is a pipe; expected a file"));
  fs::remove(markers);
  fs::create_symlink("markers.csv", markers);
  EXPECT_THAT(line(), HasSubstr("markers.csv: cannot be read: Too many levels of symbolic links"));
  fs::remove(markers);
  fs::create_symlink("/etc/passwd", markers);
  EXPECT_THAT(line(), HasSubstr("leads to /etc/passwd; expected a file inside the recording"));
  fs::remove(markers);
  fs::create_symlink("loop", path() / "loop");
  EXPECT_THAT(BadInputLine(RunCommand({"check", "loop/rec"}, path())),
              HasSubstr("Too many levels of symbolic links"));
}

TEST_F(BadInput, LinesThatSteerATerminal) {
  Replace("rec/markers.csv", "\n1,", "\n\x1b[2J" + std::string(2'000'000, 'x') + ",");
  const std::string line = FitLine();
  EXPECT_THAT(line, HasSubstr("'\\x1b[2Jxxx"));
  EXPECT_LT(line.size(), 500u);
}

// On the standard output as on the other.
TEST_F(BadInput, NamesThatSteerATerminal) {
  UseMesh(
      "v 0 0 1\nv 0.4 0 1\nv 0 0.4 1\nv 0.4 0.4 1\nvt 0 0\nvt 0.4 0\nvt 0 0.4\nvt 0.4 0.4\n"
      "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n");
  fs::rename(path() / "rec" / "cloth.obj", path() / "rec" / "a\x1b[2J.obj");
  Replace("rec/recording.yaml", "cloth.obj", "\"a\\x1b[2J.obj\"");
  const CommandResult result = RunCommand({"check", "rec"}, path());
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("initially mesh a\\x1b[2J.obj\n"));
}

bool SteersTerminal(const CommandResult& result) {
  const std::string text = result.out + result.err;
  return text.find("\xe2\x80\xae") != std::string::npos ||
         std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return (c < ' ' && c != '\n') || c == 0x7f; });
}

// Wherever they stand: in the recording, as its folder, as the run's, in the command line.
TEST_F(BadInput, NamesThatSteerATerminalAnywhere) {
  const std::string bad = "a\x1b[2J\r\n\a\x7f\xe2\x80\xae<b>'\"";
  const std::string as_yaml = "\"a\\x1b[2J\\r\\n\\a\\x7f\\u202e<b>\"";
  const std::string file = "rec/recording.yaml", whole = ReadTextFile(path() / file);
  const std::vector<std::string> fit = {"fit", "rec", "-o", bad, "--max-iterations", "0"};
  for (const char* name : {"small", "left", "handles/left.csv", "gravity"}) {
    Replace(file, name, as_yaml);
    for (const std::vector<std::string>& words : {fit, {"check", "rec"}}) {
      const CommandResult result = RunCommand(words, path());
      EXPECT_FALSE(SteersTerminal(result)) << name;
      EXPECT_THAT(BadInputLine(result), HasSubstr("a\\x1b[2J")) << name;
    }
    folder_.Write(file, whole);
  }
  EXPECT_FALSE(SteersTerminal(RunCommand({"fit", "rec", "--set", bad + "=1"}, path())));
  const CommandResult fitted = RunCommand(fit, path());
  EXPECT_EQ(fitted.status, 0);
  EXPECT_FALSE(SteersTerminal(fitted));
  EXPECT_THAT(fitted.out, HasSubstr("run: a\\x1b[2J"));
  fs::rename(path() / "rec", path() / (bad + "rec"));
  const CommandResult checked = RunCommand({"check", bad + "rec"}, path());
  EXPECT_EQ(checked.status, 0);
  EXPECT_FALSE(SteersTerminal(checked));
  EXPECT_THAT(checked.out, HasSubstr("a\\x1b[2J"));
}

TEST_F(BadInput, CalibrationsThatAreCutOff) {
  const std::string whole =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<!-- 3 < 4 -->\n<image_width>640</image_width>\n"
      "<K type_id=\"opencv-matrix\"><rows>3</rows></K>\n</opencv_storage>";
  for (const std::size_t length : {14, 30, 52, 75, 105, 110}) {
    folder_.Write("cut.xml", whole.substr(0, length));
    EXPECT_THAT(BadInputLine(RunCommand({"import", "opencv", "cut.xml", "-o", "out"}, path())),
                HasSubstr("cut.xml: "))
        << length;
  }
  folder_.Write("cut.xml", whole);
  EXPECT_THAT(BadInputLine(RunCommand({"import", "opencv", "cut.xml", "-o", "out"}, path())),
              testing::Not(HasSubstr("tag")));
}

TEST_F(BadInput, CalibrationsNestedTooDeep) {
  std::string deep, list = "%YAML:1.0\n---\nK: ", items = list, maps = list;
  for (int i = 0; i < 100'000; ++i) {
    deep += "<a>";
    list += "{a: ";
    items += "- ";
    maps += "a: ";
  }
  folder_.Write("deep.xml", "<?xml version=\"1.0\"?>\n<opencv_storage>" + deep);
  folder_.Write("deep.yml", list);
  folder_.Write("items.yml", items + "1\n");
  folder_.Write("maps.yml", maps + "1\n");
  const auto error_of = [&](const char* file) {
    return BadInputLine(RunCommand({"import", "opencv", file, "-o", "out"}, path()));
  };
  EXPECT_THAT(error_of("deep.xml"), HasSubstr("is nested too deep"));
  EXPECT_THAT(error_of("deep.yml"), HasSubstr("is nested too deep"));
  EXPECT_THAT(error_of("items.yml"), HasSubstr("items.yml: line 3: column 4"));
  EXPECT_THAT(error_of("maps.yml"), HasSubstr("maps.yml: line 3: column 5"));
}

}  // namespace
}  // namespace clothfit
