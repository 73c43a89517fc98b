// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole folders with one file broken at random: no command crashes, hangs, takes memory without end
// or speaks other than in lines of its own. CLOTHFIT_MUTATIONS says how many (`make test-deep` asks
// for 2000), CLOTHFIT_MUTATION_SEED with which seed, CLOTHFIT_MUTATION_CASE for one alone.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <random>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/base/printable.h"
#include "autodiff_sim/base/sanitized.h"
#include "fitting/files/npy_file.h"
#include "tests/apps/command.h"
#include "tests/support/c3d_file.h"
#include "tests/support/motive_file.h"
#include "tests/support/mutation.h"
#include "tests/support/small_recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

int FromEnvironment(const char* name, int otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : otherwise;
}

// What is broken, and the command that reads it afterwards; all in a folder of its own.
struct Target {
  std::string folder;              // copied
  std::vector<std::string> files;  // of which one is broken
  std::vector<std::string> command;
  bool is_work = false;  // simulates as much as it is told to
};

const std::vector<Target>& Targets() {
  static const std::vector<std::string> kScene = {"recording.yaml", "markers.csv",
                                                  "handles/left.csv"};
  static const std::vector<std::string> kPictures = {
      "recording.yaml",         "cameras.yaml",           "tracks.csv",
      "masks/cam0/000000.png",  "images/cam0/000001.png", "masks",
      "images/cam0/000002.png", "background/cam0.png"};
  static const std::vector<std::string> kRun = {
      "config.yaml",    "summary.json",    "log.txt",         "trajectory.npy",
      "mesh.obj",       "parameters.yaml", "progress.csv",    "residuals.csv",
      "checkpoint.bin", ".clothfit.json",  "report/more.json"};
  static const std::vector<Target> targets = {
      {"rec", kScene, {"check", "rec"}},
      {"rec", kScene, {"simulate", "rec", "-o", "out", "--frames", "3"}, true},
      {"pic", kPictures, {"check", "pic"}},
      {"pic", kPictures, {"check", "pic"}},
      {"vid", {"videos/cam0.mkv", "videos/ceiling.mkv"}, {"check", "vid"}},
      {"vid", {"videos/cam0.mkv"}, {"import", "video", "cam0=vid/videos/cam0.mkv", "-o", "out"}},
      {"mesh", {"cloth.obj", "recording.yaml", "ball.obj"}, {"check", "mesh"}},
      {"opencv", {"cam0.yml"}, {"import", "opencv", "opencv/cam0.yml", "-o", "out"}},
      {"opencv", {"cam0.xml"}, {"import", "opencv", "opencv/cam0.xml", "-o", "out"}},
      {"opencv", {"cam0.json"}, {"import", "opencv", "opencv/cam0.json", "-o", "out"}},
      {"colmap", {"cameras.txt", "images.txt"}, {"import", "colmap", "colmap", "-o", "out"}},
      {"motive", {"take.csv"}, {"import", "markers", "motive/take.csv", "-o", "out"}},
      {"c3d", {"take.c3d"}, {"import", "markers", "c3d/take.c3d", "-o", "out", "--up", "z"}},
      {"run", kRun, {"predict", "run", "--at", "run/points.csv", "-o", "out.csv"}, true},
      {"run", {"points.csv"}, {"predict", "run", "--at", "run/points.csv", "-o", "out.csv"}},
      {"run", kRun, {"report", "run", "-o", "out.html"}},
      {"run", kRun, {"export", "run", "--format", "gltf", "-o", "out.glb"}},
      {"run", kRun, {"fit", "--resume", "-o", "run", "--quiet"}, true},
      {"rec",
       {"fit.yaml"},
       {"fit", "rec", "--config", "rec/fit.yaml", "-o", "out", "--quiet"},
       true},
      {"rec", {"list.yaml"}, {"batch", "rec/list.yaml", "-o", "out", "--quiet"}, true},
      {"rec",
       {"synthesize.yaml"},
       {"synthesize", "--config", "rec/synthesize.yaml", "-o", "out"},
       true},
  };
  return targets;
}

// The folders as they are before anything is broken.
class Folders {
 public:
  Folders() {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 6;
    const Recording recording = MakeSmallRecording(options);
    WriteRecording(recording, path() / "rec");
    folder_.Write("rec/fit.yaml",
                  "strategy: {max_iterations: 0, window: 0.1}\nparameters:\n"
                  "  bending.stiffness: {value: 1e-4, free: true}\n");
    folder_.Write(
        "rec/list.yaml",
        "fits:\n  - {recording: ., name: one, config: fit.yaml, set: {air_drag.normal: 1}}\n");
    folder_.Write("rec/synthesize.yaml",
                  "preset: experiment-1\nimages: false\nframes: 3\nresolution: [4, 4]\n"
                  "refinement: 1\nmarkers: [3, 3]\n");
    Make({"fit", "rec", "-o", "run", "--max-iterations", "1", "--window", "0", "--quiet"});
    folder_.Write("run/points.csv", "frame,u,v\n0,0,0\n3,0.1,0.2\n");
    folder_.Write("run/report/more.json",
                  R"({"sections": [{"id": "a", "title": "A", "blocks": [{"kind": "text",
                      "paragraphs": ["of a stranger"], "more": 1}], "more": 2}]})");
    const std::vector<std::string> pictures = {"--preset",
                                               "experiment-3",
                                               "--size",
                                               "0.6",
                                               "0.6",
                                               "--resolution",
                                               "5",
                                               "5",
                                               "--refinement",
                                               "1",
                                               "--steps",
                                               "2",
                                               "--cameras",
                                               "2",
                                               "--frames",
                                               "3",
                                               "--picture-size",
                                               "48",
                                               "36",
                                               "--truth-points",
                                               "3",
                                               "3",
                                               "--markers",
                                               "3",
                                               "3",
                                               "--tracks",
                                               "--samples",
                                               "1"};
    Make(pictures, {"synthesize", "-o", "pic"});
    fs::copy(path() / "pic" / "truth" / "masks", path() / "pic" / "masks",
             fs::copy_options::recursive);
    Make(pictures, {"synthesize", "-o", "vid", "--video", "mkv"});
    WriteMeshes(recording);
    WriteCalibrations();
    folder_.Write("motive/take.csv", MotiveCsv(TakeOfRecording(recording)));
    folder_.Write("c3d/take.c3d", C3dFile().Bytes(TakeOfRecording(recording)));
  }
  const fs::path& path() const { return folder_.path(); }

 private:
  void Make(const std::vector<std::string>& words, std::vector<std::string> before = {}) const {
    before.insert(before.end(), words.begin(), words.end());
    const CommandResult result = RunCommand(before, path());
    if (result.status != 0) throw std::runtime_error(before[0] + ": " + result.err);
  }

  void WriteMeshes(Recording recording) const {
    const std::string cloth =
        "v 0 0 1\nv 0.4 0 1\nv 0 0.4 1\nv 0.4 0.4 1\nvt 0 0\nvt 0.4 0\nvt 0 0.4\nvt 0.4 0.4\n"
        "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n";
    const std::string ball =
        "v 0 0 0.1\nv 0.1 0 -0.1\nv -0.1 0.1 -0.1\nv -0.1 -0.1 -0.1\n"
        "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
    recording.cloth.initial = MeshPlacement{folder_.Write("cloth.obj", cloth)};
    ObstacleDescription obstacle;
    obstacle.name = "ball";
    obstacle.shape = MeshShape{folder_.Write("ball.obj", ball)};
    recording.obstacles = {obstacle};
    WriteRecording(recording, path() / "mesh");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path() / "mesh")) {
      if (entry.path().extension() != ".obj") continue;
      const bool is_cloth = ReadTextFile(entry.path()).find("vt") != std::string::npos;
      names_[is_cloth ? "cloth.obj" : "ball.obj"] =
          fs::relative(entry.path(), path() / "mesh").string();
    }
  }

  void WriteCalibrations() const {
    folder_.Write(
        "opencv/cam0.yml",
        "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n"
        "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]\n"
        "R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\n"
        "T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ 0., 0., 2. ]\n");
    folder_.Write("opencv/cam0.xml",
                  "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>640</image_width>\n"
                  "<image_height>480</image_height>\n<camera_matrix type_id=\"opencv-matrix\">\n"
                  "  <rows>3</rows>\n  <cols>3</cols>\n  <dt>d</dt>\n  <data>\n"
                  "    500. 0. 320. 0. 500. 240. 0. 0. 1.</data></camera_matrix>\n"
                  "<rvec type_id=\"opencv-matrix\">\n  <rows>3</rows>\n  <cols>1</cols>\n"
                  "  <dt>d</dt>\n  <data>\n    0. 0. 0.</data></rvec>\n"
                  "<tvec type_id=\"opencv-matrix\">\n  <rows>3</rows>\n  <cols>1</cols>\n"
                  "  <dt>d</dt>\n  <data>\n    0. 0. 2.</data></tvec>\n</opencv_storage>\n");
    folder_.Write("opencv/cam0.json",
                  "{\n \"imageSize\": [640, 480],\n \"K\": [[500.0, 0.0, 320.0],\n"
                  "  [0.0, 500.0, 240.0], [0.0, 0.0, 1.0]],\n \"rvec\": [0.0, 0.0, 0.0],\n"
                  " \"tvec\": [0.0, 0.0, 2.0]\n}\n");
    folder_.Write("colmap/cameras.txt",
                  "# Camera list\n1 PINHOLE 640 480 500 510 320 240\n2 PINHOLE 640 480 500 510 320 "
                  "240\n");
    folder_.Write("colmap/images.txt",
                  "# Image list\n1 1 0 0 0 0.1 0.2 0.3 1 a.png\n1.5 2.5 -1\n"
                  "2 0 0.70710678118 0.70710678118 0 1 2 3 2 b.png\n\n");
  }

 public:
  // Of a target's file, where the writer chose the name.
  std::string NameOf(const std::string& file) const {
    const auto found = names_.find(file);
    return found == names_.end() ? file : found->second;
  }

 private:
  TestFolder folder_;
  mutable std::map<std::string, std::string> names_;
};

bool IsClothfitsOwn(const std::string& line) {
  return line.rfind("clothfit: ", 0) == 0 || line.rfind("  ", 0) == 0 || line.find(" %") == 3;
}

// The first line that a terminal would not show as it is; empty where there is none.
std::string SteeringLine(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (Printable(line, 4 * line.size() + 1) != line)
      return "LINE that steers: " + Printable(line, 200);
  return "";
}

// What is wrong with the way in which a command ended; empty where all is as promised.
std::string Fault(const CommandResult& result, bool ended_in_time) {
  constexpr double kMostMemory = 2e9;
  constexpr std::size_t kLongest = 2000;  // bytes of a line
  if (!ended_in_time) return "HANG";
  if (result.status < 0) return fmt::format("CRASH by signal {}", -result.status);
  if (result.most_memory > kMostMemory)
    return fmt::format("MEMORY: {:.1f} GB", result.most_memory / 1e9);
  if (result.status > 2) return fmt::format("STATUS {}", result.status);
  // A simulation that diverges has failed; whatever cannot be used is bad input.
  if (result.status == 1 && result.err.find("fail") == std::string::npos)
    return "STATUS 1: " + result.err;
  std::size_t lines = 0;
  std::string_view rest = result.err;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!IsClothfitsOwn(line)) {
      // Under a sanitizer libraries write there as they like (apps/terminal/terminal.cc).
      if (!kIsSanitized) return "LINE of another: " + Printable(line, 200);
      continue;
    }
    ++lines;
    if (line.size() > kLongest) return fmt::format("LINE of {} bytes", line.size());
    if (const std::string steering = SteeringLine(line); !steering.empty()) return steering;
  }
  if (result.status == 2 && lines != 1) return fmt::format("{} LINES: {}", lines, result.err);
  return SteeringLine(result.out);
}

// Nonsense that was taken for a motion.
std::string FaultOfMotion(const fs::path& folder) {
  const fs::path file = folder / "out" / "trajectory.npy";
  if (!fs::exists(file)) return "";
  constexpr double kFar = 1e5;  // m
  for (const Eigen::VectorXd& frame : ReadPointsNpy(file))
    if (!frame.allFinite() || frame.cwiseAbs().maxCoeff() > kFar)
      return "NONSENSE in the trajectory";
  return "";
}

struct Case {
  std::string what, fault, err;
  int status = -1;
};

bool EndsWithin(std::chrono::steady_clock::duration time, RunningCommand* command) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (!command->HasEnded()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

Case RunCase(const Folders& folders, int seed, int number) {
  std::seed_seq sequence{seed, number};
  std::mt19937 random(sequence);
  const Target& target = Targets()[static_cast<std::size_t>(number) % Targets().size()];
  const TestFolder folder;
  fs::copy(folders.path() / target.folder, folder.path() / target.folder,
           fs::copy_options::recursive);
  if (target.folder == "run")
    fs::copy(folders.path() / "rec", folder.path() / "rec", fs::copy_options::recursive);
  const std::string name = folders.NameOf(target.files[random() % target.files.size()]);
  const fs::path file = folder.path() / target.folder / name;
  std::string how;
  constexpr int kEvery = 6;  // one in so many is replaced as a whole
  if (random() % kEvery == 0 || !fs::is_regular_file(file)) {
    ReplaceFile(file, &random, &how);
  } else {
    const std::string text = MutateText(ReadTextFile(file), &random, &how);
    std::ofstream(file, std::ios::binary) << text;
  }
  Case result;
  result.what = fmt::format("case {} of seed {}: {}, {}/{}, {}", number, seed,
                            fmt::join(target.command, " "), target.folder, name, how);
  RunningCommand command(target.command, folder.path());
  bool in_time = true;
  if (target.is_work) {
    // What is asked for may take hours; then it has to end when it is told to.
    if (!EndsWithin(std::chrono::seconds(15), &command)) {
      command.Signal(SIGTERM);
      in_time =
          EndsWithin(std::chrono::seconds(4), &command);  // two, and what a busy machine takes
    }
  } else {
    in_time = EndsWithin(std::chrono::seconds(60), &command);
  }
  if (!in_time) command.Signal(SIGKILL);
  const CommandResult ended = command.Wait();
  result.status = ended.status;
  result.err = ended.err;
  // Before its first instruction the system itself ends it.
  const bool is_stopped = ended.status == 130 || ended.status == -SIGTERM;
  if (in_time && target.is_work && is_stopped) return result;
  result.fault = Fault(ended, in_time);
  if (result.fault.empty() && ended.status == 0) result.fault = FaultOfMotion(folder.path());
  return result;
}

TEST(MutatedInput, IsRefusedInOneLineOrTaken) {
  const Folders folders;
  const int seed = FromEnvironment("CLOTHFIT_MUTATION_SEED", 1);
  const int only = FromEnvironment("CLOTHFIT_MUTATION_CASE", -1);
  const int count = only >= 0 ? 1 : FromEnvironment("CLOTHFIT_MUTATIONS", 200);
  const char* const table = std::getenv("CLOTHFIT_MUTATION_TABLE");
  std::mutex mutex;
  std::map<int, int> of_status;
  int faults = 0;
  ParallelFor(count, 2, [&](int i, int /*worker*/) {
    const Case one = RunCase(folders, seed, only >= 0 ? only : i);
    const std::lock_guard<std::mutex> lock(mutex);
    ++of_status[one.status];
    if (table != nullptr)
      std::ofstream(table, std::ios::app)
          << one.what << '\t' << one.status << '\t' << Printable(one.fault, 300) << '\t'
          << Printable(one.err, 300) << '\n';
    if (one.fault.empty()) return;
    ++faults;
    ADD_FAILURE() << one.what << "\n" << Printable(one.fault, 500);
  });
  for (const auto& [status, cases] : of_status) fmt::print("status {}: {}\n", status, cases);
  EXPECT_EQ(faults, 0) << "of " << count;
  if (only < 0 && count >= 100) {  // it is neither all refused nor all taken
    EXPECT_GT(of_status[2], count / 4);
    EXPECT_GT(of_status[0], count / 20);
  }
}

}  // namespace
}  // namespace clothfit
