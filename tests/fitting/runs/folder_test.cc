// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <csignal>
#include <limits>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "autodiff_sim/mesh/obj_file.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/runs/fit_run.h"
#include "fitting/runs/run_folder.h"
#include "tests/support/small_recording.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using Existing = RunFolder::Existing;
using testing::HasSubstr;

std::string OpenErrorOf(const fs::path& path, Existing existing) {
  return InputErrorOf([&] { RunFolder(path, existing); });
}

TEST(RunFolder, TakesANewOrEmptyFolder) {
  const TestFolder folder;
  const RunFolder run(folder.path() / "a" / "b", Existing::kRefuse);
  EXPECT_THAT(ReadTextFile(run.path() / "log.txt"), HasSubstr("clothfit "));
  fs::create_directory(folder.path() / "empty");
  EXPECT_NO_THROW(RunFolder(folder.path() / "empty", Existing::kReplace));
  EXPECT_EQ(RunFolder::Open(run.path()).path(), run.path());
}

TEST(RunFolder, TellsWhyItCannotBeOpened) {
  const TestFolder folder;
  const auto problem = [&](const char* name) {
    return InputErrorOf([&] { RunFolder::Open(folder.path() / name); });
  };
  fs::create_symlink("loop", folder.path() / "loop");
  EXPECT_THAT(problem("loop"), HasSubstr("loop: cannot be read: Too many levels of symbolic"));
  EXPECT_THAT(problem("none"), HasSubstr("none: no such folder"));
}

TEST(RunFolder, RefusesWhatIsThere) {
  const TestFolder folder;
  const RunFolder run(folder.path() / "run", Existing::kRefuse);
  EXPECT_THAT(OpenErrorOf(run.path(), Existing::kRefuse), HasSubstr("--force replaces it"));
  EXPECT_THAT(OpenErrorOf(run.path(), Existing::kReplace), HasSubstr("another clothfit"));
  const fs::path file = folder.Write("other/log.txt", "not of clothfit");
  EXPECT_THAT(OpenErrorOf(file.parent_path(), Existing::kRefuse), HasSubstr("is not empty"));
  EXPECT_THAT(OpenErrorOf(file.parent_path(), Existing::kReplace), HasSubstr("is not the folder"));
  EXPECT_THAT(OpenErrorOf(file.parent_path(), Existing::kResume), HasSubstr("is not the folder"));
  EXPECT_THAT(OpenErrorOf(file, Existing::kReplace), HasSubstr("is a file; expected a folder"));
  EXPECT_THAT(OpenErrorOf(file / "x", Existing::kRefuse), HasSubstr("cannot be made"));
  EXPECT_EQ(ReadTextFile(file), "not of clothfit");
}

TEST(RunFolder, ReplacesOnlyItsOwnFiles) {
  const TestFolder folder;
  RunFolder(folder.path() / "run", Existing::kRefuse).WriteConfig(DefaultConfig({}));
  folder.Write("run/mine.txt", "keep");
  const RunFolder again(folder.path() / "run", Existing::kReplace);
  EXPECT_FALSE(fs::exists(again.ConfigFile()));
  EXPECT_EQ(ReadTextFile(folder.path() / "run" / "mine.txt"), "keep");
}

TEST(RunFolder, ResumesWhatIsNotFinished) {
  const TestFolder folder;
  const fs::path place = folder.path() / "run";
  EXPECT_THAT(OpenErrorOf(place, Existing::kResume), HasSubstr("no run to resume"));
  EXPECT_FALSE(fs::exists(place));
  RunFolder(place, Existing::kRefuse);
  EXPECT_NO_THROW(RunFolder(place, Existing::kResume));  // ended before its first checkpoint
  folder.Write("run/summary.json", "{\"status\": \"interrupted\"}");
  EXPECT_NO_THROW(RunFolder(place, Existing::kResume));
  folder.Write("run/summary.json", "{\"status\": \"converged\"}");
  EXPECT_THAT(OpenErrorOf(place, Existing::kResume), HasSubstr("the run is finished"));
  RunFolder::Open(place).OpenCheckpoint();
  EXPECT_NO_THROW(RunFolder(place, Existing::kResume));
  RunFolder::Open(place).RemoveCheckpoint();
  EXPECT_FALSE(RunFolder::Open(place).HasCheckpoint());
}

TEST(RunFolder, IsKnownWithoutAManifest) {
  const TestFolder folder;
  folder.Write("run/log.txt", "clothfit 0.1.0\n");
  folder.Write("run/config.yaml", "of before");
  folder.Write("run/mine.txt", "keep");
  EXPECT_EQ(RunFolder::Open(folder.path() / "run").path(), folder.path() / "run");
  EXPECT_NO_THROW(RunFolder(folder.path() / "run", Existing::kReplace));
  EXPECT_FALSE(fs::exists(folder.path() / "run" / "config.yaml"));
  EXPECT_EQ(ReadTextFile(folder.path() / "run" / "mine.txt"), "keep");
  folder.Write("diagnosis/log.txt", "clothfit diagnose\n");
  EXPECT_THAT(InputErrorOf([&] { RunFolder::Open(folder.path() / "diagnosis"); }),
              HasSubstr("is not the folder of a run; expected one that 'clothfit fit' made, found "
                        "a diagnosis"));
}

TEST(RunFolder, KnowsARecordingWhoeverWroteIt) {
  const TestFolder folder;
  folder.Write("rec/recording.yaml", "format: 1\n");
  const std::string place = (folder.path() / "rec").string();
  EXPECT_EQ(InputErrorOf([&] { RunFolder::Open(place); }),
            place + ": is a recording; 'clothfit report " + place + "' shows it, 'clothfit fit " +
                place + " -o RUN' makes a run of it");
}

// A scene with a marker in every frame and a track that is held out with its camera.
struct RunOfScene : testing::Test {
  RunOfScene() {
    SmallRecordingOptions options;
    options.particles = 4;
    options.frames = 5;
    Recording recording = MakeSmallRecording(options);
    Camera camera;
    camera.name = "side";
    camera.width = camera.height = 100;
    camera.camera_from_world_translation = {0.0, 0.0, 3.0};
    recording.cameras = {camera};
    recording.tracks = {{2, 0, 8, {0.1, 0.1}, {0.0, 0.0}}};
    recording.splits.held_out_cameras = {"side"};
    config = DefaultConfig(recording);
    scene = MakeScene(recording, config);
  }
  std::vector<Eigen::VectorXd> Still(int frames) const {
    return std::vector<Eigen::VectorXd>(static_cast<size_t>(frames), scene.initial);
  }
  TestFolder folder;
  RunFolder run{folder.path() / "run", Existing::kRefuse};
  FitConfig config;
  Scene scene;
};

TEST_F(RunOfScene, WritesAMeshThatReadsBack) {
  run.WriteTrajectory(scene, Still(5));
  const ObjCloth cloth = ReadObj((run.path() / "mesh.obj").string());
  ASSERT_EQ(cloth.mesh.num_particles(), scene.mesh.num_particles());
  EXPECT_EQ(cloth.mesh.triangles.size(), scene.mesh.triangles.size());
  double area = 0.0;
  for (const auto& [a, b, c] : cloth.mesh.triangles) {
    const Eigen::Vector2d p = cloth.mesh.uv[b] - cloth.mesh.uv[a];
    const Eigen::Vector2d q = cloth.mesh.uv[c] - cloth.mesh.uv[a];
    area += 0.5 * (p.x() * q.y() - p.y() * q.x());
  }
  EXPECT_NEAR(area, 0.16, 1e-12);
}

TEST_F(RunOfScene, WritesAResidualForEveryObservation) {
  run.WriteTrajectory(scene, Still(4));  // as if the simulation ended after frame 3
  int markers = 0, tracks = 0, missing = 0;
  const auto visit = [&](const CsvRow& row) {
    const int frame = row.Integer(1);
    EXPECT_EQ(row.Integer(5), frame == 4 || row.Text(0) == "track");
    EXPECT_EQ(row.Integer(4), 1 - row.Integer(5));
    if (row.Text(0) == "track") {
      ++tracks;
      EXPECT_EQ(row.Text(2), "side");
      // fx = 1 px, at a depth of 1 + 3 m
      EXPECT_LT((row.Vector2(11) - Eigen::Vector2d(0.1 / 4.0, 0.1 / 4.0)).norm(), 1e-12);
      EXPECT_TRUE(row.IsMissing(8, 3));
      return;
    }
    ++markers;
    EXPECT_TRUE(row.IsMissing(11, 2));
    const bool is_missing = row.IsMissing(8, 3);
    EXPECT_EQ(is_missing, frame == 4);
    missing += is_missing;
    if (is_missing) return;
    const Eigen::Vector3d predicted(row.Number(6), row.Number(7), 1.0);
    const MarkerObservation& marker = scene.markers[static_cast<size_t>(markers - 1)];
    EXPECT_LT((predicted - marker.position - row.Vector3(8)).norm(), 1e-12);
  };
  ReadCsv(run.path() / "residuals.csv",
          {"kind", "frame", "camera", "id", "fitted", "held_out", "u", "v", "dx", "dy", "dz",
           "dx_px", "dy_px"},
          visit);
  EXPECT_EQ(markers, 5 * 16);
  EXPECT_EQ(tracks, 1);
  EXPECT_EQ(missing, 16);
}

TEST_F(RunOfScene, ReadsTheParametersThatItWrote) {
  config.initial_order = 0;
  const FreeParameters free(config, scene, MakeParameterTable());
  FitResult result;
  for (int i = 0; i < free.size(); ++i) {
    ParameterEstimate estimate;
    estimate.name = free.entries()[static_cast<size_t>(i)].name;
    estimate.unit = free.entries()[static_cast<size_t>(i)].unit;
    estimate.free = true;
    estimate.value = free.UnitValue(i, free.start()[i] + 0.01 * i);
    estimate.upper95 = std::numeric_limits<double>::infinity();
    result.estimates.push_back(estimate);
  }
  run.WriteParameters(result);
  const Eigen::VectorXd theta = run.ReadParameters(free);
  ASSERT_GT(free.size(), 8);  // with entries of the initial state
  for (int i = 0; i < free.size(); ++i) {
    EXPECT_NEAR(theta[i], free.start()[i] + 0.01 * i, 1e-13);
  }
  result.estimates.pop_back();
  run.WriteParameters(result);
  EXPECT_THAT(InputErrorOf([&] { run.ReadParameters(free); }),
              HasSubstr("required key is missing"));
}

TEST_F(RunOfScene, SummarisesWithNullForWhatIsNotKnown) {
  FitResult result;
  result.status = FitStatus::kConverged;
  result.cost_after = std::numeric_limits<double>::infinity();
  result.after.marker_rms = 0.125;
  result.statements = {"say \"this\""};
  result.estimates = {{"a.b", "m", 2.0, 1.0, true, 1.5, std::nan(""), false, true}};
  run.WriteSummary(scene, config, result);
  const nlohmann::json json = nlohmann::json::parse(ReadTextFile(run.path() / "summary.json"));
  EXPECT_EQ(json.at("fit").at("marker_rms_m"), 0.125);
  EXPECT_TRUE(json.at("held_out").at("marker_rms_m").is_null());
  EXPECT_TRUE(json.at("before").at("fit").at("track_rms_px").is_null());
  EXPECT_TRUE(json.at("cost").at("after").is_null());
  EXPECT_EQ(json.at("frames").at("fitted"), 4);
  EXPECT_EQ(json.at("lack_of_support"), "");
  EXPECT_EQ(json.at("statements")[0], "say \"this\"");
  EXPECT_EQ(json.at("parameters").at("a.b").at("interval")[0], 1.5);
  EXPECT_TRUE(json.at("parameters").at("a.b").at("interval")[1].is_null());
}

// A limit on the size of files stands for a full disk: it needs no disk of its own.
TEST_F(RunOfScene, AFullDiskEndsAFitInOneLine) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  rlimit small = limit;
  small.rlim_cur = 4096;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = InputErrorOf([&] { FitIntoRun(scene, config, run, {}, false); });
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_THAT(error, HasSubstr("cannot be written: File too large"));
}

}  // namespace
}  // namespace clothfit
