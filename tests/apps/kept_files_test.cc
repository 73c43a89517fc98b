// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// No command replaces, removes or writes through what is not clothfit's own.
#include <chrono>
#include <csignal>
#include <iterator>
#include <thread>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include "tests/apps/command.h"
#include "tests/support/motive_file.h"
#include "tests/support/small_recording.h"
#include "tracking/recording/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

constexpr const char* kMine = "somebody's only copy\n";

class KeptFiles : public testing::Test {
 protected:
  fs::path path() const { return folder_.path(); }
  CommandResult Run(const Words& words) const { return RunCommand(words, path()); }
  CommandResult Run(Words words, const Words& more) const {
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }
  std::string Read(const std::string& file) const { return ReadTextFile(path() / file); }
  bool Has(const std::string& file) const { return fs::exists(path() / file); }
  void WriteMine(const Words& files) const {
    for (const std::string& file : files) folder_.Write(file, kMine);
  }
  void ExpectMine(const Words& files) const {
    for (const std::string& file : files) {
      ASSERT_TRUE(Has(file)) << file;
      EXPECT_EQ(Read(file), kMine) << file;
    }
  }

  TestFolder folder_;
};

class KeptFilesOfImports : public KeptFiles {
 protected:
  KeptFilesOfImports() {
    std::vector<Eigen::Vector2d> uv;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) uv.emplace_back(0.1 * column, 0.09 * row);
    }
    folder_.Write("take.csv", MotiveCsv(BentSheetTake(uv, 1e-4), "Millimeters", 1e-3));
    folder_.Write("cam.yml",
                  "%YAML:1.0\n---\nK: [50, 0, 32, 0, 50, 24, 0, 0, 1]\nR: [0, 0, 0]\n"
                  "T: [0, 0, 2]\nimageSize: [64, 48]\n");
  }
};

TEST_F(KeptFilesOfImports, CamerasStayWhereMarkersFollow) {
  ASSERT_EQ(Run({"import", "opencv", "cam.yml", "-o", "rec"}).status, 0);
  const std::string cameras = Read("rec/cameras.yaml");
  const Words markers = {"import", "markers", "take.csv", "-o", "rec", "--handles", "a=m0"};
  const CommandResult added = Run(markers);
  ASSERT_EQ(added.status, 0) << added.err;
  EXPECT_EQ(Read("rec/cameras.yaml"), cameras);
  EXPECT_EQ(ReadRecording(path() / "rec").cameras.size(), 1u);
  EXPECT_THAT(BadInputLine(Run(markers)), HasSubstr("recording.yaml: exists already; --force"));

  // Other markers replace those before, and nothing else.
  WriteMine({"rec/tracks.txt", "rec/handles/mine.csv"});
  ASSERT_EQ(
      Run({"import", "markers", "take.csv", "-o", "rec", "--handles", "b=m1", "--force"}).status,
      0);
  EXPECT_FALSE(Has("rec/handles/a.csv"));
  EXPECT_TRUE(Has("rec/handles/b.csv"));
  EXPECT_EQ(Read("rec/cameras.yaml"), cameras);
  ExpectMine({"rec/tracks.txt", "rec/handles/mine.csv"});
}

TEST_F(KeptFilesOfImports, TheInputIsNeverTheOutput) {
  for (const char* name : {"markers.csv", "initial.csv", "recording.yaml", "take.csv"}) {
    SCOPED_TRACE(name);
    const std::string input = std::string("dm/") + name;
    folder_.Write(input, Read("take.csv"));
    for (const Words& more : {Words(), Words{"--force"}})
      BadInputLine(Run({"import", "markers", input, "-o", "dm"}, more));
    EXPECT_EQ(Read(input), Read("take.csv"));
    EXPECT_EQ(std::distance(fs::directory_iterator(path() / "dm"), fs::directory_iterator()), 1);
    fs::remove_all(path() / "dm");
  }
}

TEST_F(KeptFilesOfImports, CamerasMadeByHandStay) {
  WriteMine({"rec/cameras.yaml"});
  EXPECT_THAT(BadInputLine(Run({"import", "opencv", "cam.yml", "-o", "rec", "--force"})),
              HasSubstr("cameras.yaml: exists already and is not replaced"));
  ExpectMine({"rec/cameras.yaml"});
}

Words Synthesize(const std::string& frames) {
  return {"synthesize",     "-o",        "rec", "--scenario",   "corner-lift",
          "--images",       "--cameras", "1",   "--frames",     frames,
          "--resolution",   "4",         "4",   "--refinement", "1",
          "--picture-size", "64",        "48"};
}

TEST_F(KeptFiles, ForeignPicturesStayInASynthesizedRecording) {
  const CommandResult made = Run(Synthesize("3"));
  ASSERT_EQ(made.status, 0) << made.err;
  ASSERT_TRUE(Has("rec/images/cam0/000002.png"));
  const Words mine = {"rec/masks/cam0/mine.png", "rec/images/cam0/mine.png", "rec/videos/mine.mkv",
                      "rec/truth/masks/mine.png", "rec/background/mine.png"};
  WriteMine(mine);
  const CommandResult again = Run(Synthesize("2"), {"--force"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_FALSE(Has("rec/images/cam0/000002.png"));
  ExpectMine(mine);
}

TEST_F(KeptFiles, ARecordingMadeByHandIsNotSynthesizedOver) {
  const Words mine = {"rec/recording.yaml", "rec/cameras.yaml", "rec/images/cam0/000000.png"};
  WriteMine(mine);
  EXPECT_THAT(BadInputLine(Run(Synthesize("3"), {"--force"})),
              HasSubstr("rec: is not the folder of a recording that clothfit wrote"));
  ExpectMine(mine);
}

TEST_F(KeptFiles, TrackingWritesThroughNoLinkAndOverNothing) {
  ASSERT_EQ(Run(Synthesize("3")).status, 0);
  const Words track = {"track", "rec", "-o", "seen", "--no-tracks", "--no-markers", "--quiet"};
  WriteMine({"thesis.txt", "seen/masks/cam0/000000.png"});
  fs::create_symlink(path() / "thesis.txt", path() / "seen" / "filters.csv");
  BadInputLine(Run(track));
  BadInputLine(Run(track, {"--force"}));
  ExpectMine({"thesis.txt", "seen/masks/cam0/000000.png"});
  EXPECT_FALSE(Has("seen/recording.yaml"));

  fs::remove_all(path() / "seen");
  ASSERT_EQ(Run(track).status, 0);
  ASSERT_TRUE(Has("seen/masks/cam0/000000.png"));
  fs::remove(path() / "seen" / "filters.csv");
  fs::create_symlink(path() / "thesis.txt", path() / "seen" / "filters.csv");
  EXPECT_THAT(BadInputLine(Run(track, {"--force"})), HasSubstr("filters.csv: is no regular file"));
  fs::remove(path() / "seen" / "filters.csv");
  WriteMine({"seen/masks/cam0/mine.png"});
  ASSERT_EQ(Run(track, {"--force"}).status, 0);
  ExpectMine({"thesis.txt", "seen/masks/cam0/mine.png"});
}

// With a run of a small recording.
class KeptFilesOfRuns : public KeptFiles {
 protected:
  KeptFilesOfRuns() {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 10;
    WriteRecording(MakeSmallRecording(options), path() / "rec");
  }
  static Words Fit(const std::string& run) {
    return {"fit", "rec", "-o", run, "--max-iterations", "0", "--window", "0", "--quiet"};
  }
};

TEST_F(KeptFilesOfRuns, ADiagnosisAndARunDoNotReplaceEachOther) {
  ASSERT_EQ(Run(Fit("run")).status, 0);
  const std::string log = Read("run/log.txt"), config = Read("run/config.yaml");
  const Words diagnose = {"diagnose", "rec", "-o", "run", "--finest", "4", "--max-models", "1"};
  for (const char* how : {"--force", "--resume"})
    EXPECT_THAT(BadInputLine(Run(diagnose, {how})), HasSubstr("it holds a run"));
  EXPECT_EQ(Read("run/log.txt"), log);
  EXPECT_EQ(Read("run/config.yaml"), config);

  // Diagnoses of this version and of 0.1.0.
  folder_.Write("new/.clothfit.json",
                R"({"format": "clothfit-folder/1", "kind": "diagnosis", "files": {"diagnose": )"
                R"(["log.txt", "config.yaml"]}})");
  for (const char* name : {"new", "old"}) {
    SCOPED_TRACE(name);
    const fs::path folder = name;
    folder_.Write((folder / "log.txt").string(), "clothfit diagnose\n");
    folder_.Write((folder / "config.yaml").string(), config);
    for (const char* how : {"--force", "--resume"})
      EXPECT_THAT(BadInputLine(Run(Fit(name), {how})), HasSubstr("it holds a diagnosis"));
    EXPECT_EQ(Read(folder / "config.yaml"), config);
    folder_.Write("points.csv", "frame,u,v\n0,0,0\n");
    for (const Words& use : {Words{"predict", name, "--at", "points.csv", "-o", "out.csv"},
                             Words{"draw", name, "-o", "out.png"},
                             Words{"export", name, "--format", "npy", "-o", "out.npy"}}) {
      EXPECT_THAT(BadInputLine(Run(use)), HasSubstr("found a diagnosis"));
    }
  }
}

TEST_F(KeptFilesOfRuns, RunsOfVersion010AreStillReplacedAndUsed) {
  ASSERT_EQ(Run(Fit("run")).status, 0);
  fs::remove(path() / "run" / ".clothfit.json");  // which that version did not write
  fs::rename(path() / "run" / "checkpoint.bin", path() / "run" / "checkpoint.json");
  folder_.Write("points.csv", "frame,u,v\n0,0,0\n");
  EXPECT_EQ(Run({"predict", "run", "--at", "points.csv", "-o", "out.csv"}).status, 0);
  WriteMine({"run/mine.txt"});
  EXPECT_EQ(Run(Fit("run"), {"--force"}).status, 0);
  ExpectMine({"run/mine.txt"});
}

TEST_F(KeptFilesOfRuns, ASingleFileReplacesRegularFilesOnly) {
  ASSERT_EQ(Run(Fit("run")).status, 0);
  folder_.Write("points.csv", "frame,u,v\n0,0,0\n");
  WriteMine({"thesis.txt"});
  const auto commands = [](const std::string& output) -> std::vector<Words> {
    return {{"predict", "run", "--at", "points.csv", "-o", output + ".csv", "--force"},
            {"draw", "run", "-o", output + ".png", "--force"},
            {"report", "run", "-o", output + ".html", "--force"},
            {"export", "run", "--format", "gltf", "-o", output + ".glb", "--force"}};
  };
  for (const char* ending : {".csv", ".png", ".html", ".glb"}) {
    ASSERT_EQ(mkfifo((path() / ("pipe" + std::string(ending))).c_str(), 0600), 0);
    fs::create_symlink(path() / "thesis.txt", path() / ("link" + std::string(ending)));
    fs::create_symlink("/dev/null", path() / ("null" + std::string(ending)));
    fs::create_directory(path() / ("folder" + std::string(ending)));
  }
  for (const char* name : {"pipe", "link", "null"}) {
    for (const Words& words : commands(name)) {
      EXPECT_THAT(BadInputLine(Run(words)), HasSubstr("which is never replaced")) << words[0];
    }
  }
  for (const Words& words : commands("folder"))
    EXPECT_THAT(BadInputLine(Run(words)), HasSubstr("is a folder; expected a file")) << words[0];
  ExpectMine({"thesis.txt"});
  EXPECT_TRUE(fs::is_fifo(path() / "pipe.csv"));
  EXPECT_TRUE(fs::is_symlink(path() / "null.html"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const fs::path device = path() / "device.csv";
  if (mknod(device.c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0) {
    EXPECT_THAT(BadInputLine(Run(commands("device").front())), HasSubstr("is never replaced"));
    EXPECT_TRUE(fs::is_character_file(device));
  }

  WriteMine({"out.csv.part", "out.png.part", "out.html.part", "out.glb.part"});
  WriteMine({"out.csv", "out.png", "out.html", "out.glb"});
  for (const Words& words : commands("out")) EXPECT_EQ(Run(words).status, 0) << words[0];
  for (const char* file : {"out.csv", "out.png", "out.html", "out.glb"})
    EXPECT_NE(Read(file), kMine) << file;
  ExpectMine({"out.csv.part", "out.png.part", "out.html.part", "out.glb.part"});
}

TEST_F(KeptFilesOfRuns, AnExportedSequenceIsReplacedAlone) {
  ASSERT_EQ(Run(Fit("run")).status, 0);
  const Words obj = {"export", "run", "--format", "obj", "-o", "out"};
  WriteMine({"out/mine.obj"});
  EXPECT_THAT(BadInputLine(Run(obj)), HasSubstr("out: is not empty"));
  EXPECT_THAT(BadInputLine(Run(obj, {"--force"})), HasSubstr("is not the folder of an export"));
  fs::remove_all(path() / "out");
  ASSERT_EQ(Run(obj).status, 0);
  WriteMine({"out/mine.obj"});
  ASSERT_EQ(Run({"export", "run", "--format", "ply", "-o", "out", "--force"}).status, 0);
  EXPECT_FALSE(Has("out/000000.obj"));
  EXPECT_TRUE(Has("out/000000.ply"));
  ExpectMine({"out/mine.obj"});
}

TEST_F(KeptFilesOfRuns, ABatchKeepsWhatOthersPutIntoItsFolders) {
  folder_.Write("list.yaml", "config: common.yaml\nfits:\n  - recording: rec\n");
  folder_.Write("common.yaml", "strategy: {max_iterations: 0, window: 0}\n");
  const Words batch = {"batch", "list.yaml", "-o", "out", "--quiet", "--threads", "1"};
  WriteMine({"p/batch.csv"});
  for (const Words& more : {Words(), Words{"--force"}, Words{"--resume"}})
    EXPECT_THAT(BadInputLine(Run({"batch", "list.yaml", "-o", "p"}, more)), StartsWith("clothfit"));
  ExpectMine({"p/batch.csv"});
  EXPECT_THAT(BadInputLine(Run({"batch", "list.yaml", "-o", "list.yaml"})),
              HasSubstr("list.yaml: is a file; expected a folder"));
  EXPECT_THAT(BadInputLine(Run({"batch", "list.yaml", "-o", "rec", "--force"})),
              HasSubstr("it holds a recording"));

  ASSERT_EQ(Run(batch).status, 0);
  const Words mine = {"out/jobs/mine.json", "out/jobs/notes/a.txt", "out/runs/mine.txt",
                      "out/runs/rec/mine.txt", "out/mine.csv"};
  WriteMine(mine);
  const CommandResult again = Run(batch, {"--force"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(Has("out/runs/rec/summary.json"));
  ExpectMine(mine);
}

TEST_F(KeptFilesOfRuns, AComparisonTakesNoForeignFolder) {
  WriteMine({"p/runs.csv"});
  for (const Words& more : {Words(), Words{"--force"}})
    BadInputLine(Run({"compare", "rec", "-o", "p", "--max-simulations", "1"}, more));
  ExpectMine({"p/runs.csv"});
  EXPECT_THAT(BadInputLine(Run({"compare", "rec", "-o", "p/runs.csv", "--starts", "1"})),
              HasSubstr("is a file; expected a folder"));
}

TEST_F(KeptFilesOfRuns, TwoFitsDoNotShareAFolder) {
  RunningCommand first({"fit", "rec", "-o", "run"}, path());
  while (!Has("run/config.yaml") && !first.HasEnded())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  first.Signal(SIGSTOP);  // it lives until this test has looked
  ASSERT_FALSE(first.HasEnded());
  for (const char* how : {"--force", "--resume"}) {
    EXPECT_THAT(BadInputLine(Run(Fit("run"), {how})),
                HasSubstr("run: another clothfit is writing it"));
  }
  EXPECT_THAT(BadInputLine(Run(Fit("run"))), HasSubstr("already holds a run"));
  first.Signal(SIGKILL);
  first.Wait();
  EXPECT_EQ(Run(Fit("run"), {"--force"}).status, 0);
}

TEST_F(KeptFilesOfRuns, ARecordingsNameDoesNotLeadOutOfTheRuns) {
  Recording recording = ReadRecording(path() / "rec");
  for (const char* name : {"..", "."}) {
    recording.name = name;
    const std::string folder = std::string("named") + name;
    WriteRecording(recording, path() / folder);
    ASSERT_EQ(Run({"fit", folder, "--max-iterations", "0", "--window", "0", "--quiet"}).status, 0);
  }
  EXPECT_FALSE(Has("config.yaml"));
  EXPECT_FALSE(Has("runs/config.yaml"));
  EXPECT_TRUE(Has("runs/__/config.yaml"));
  EXPECT_TRUE(Has("runs/_/config.yaml"));
}

}  // namespace
}  // namespace clothfit
