// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that are kept while a diagnosis is under way.
#include "fitting/diagnosis/fitted/fit_runner.h"

#include <functional>
#include <limits>
#include <memory>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/answer/folder.h"
#include "fitting/diagnosis/fitted/kept_fit.h"
#include "tests/support/small_recording.h"
#include "tests/support/test_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

Recording FallingCloth() {
  SmallRecordingOptions options;
  options.particles = 4;
  options.frames = 6;
  return MakeSmallRecording(options);
}

FitConfig QuickConfig(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  config.max_iterations = 2;
  config.window = 0.0;
  config.coarse_resolution = 0;
  return config;
}

fs::path OnlyFile(const fs::path& folder) {
  EXPECT_EQ(NumKeptFits(folder), 1);
  return fs::directory_iterator(folder)->path();
}

TEST(KeptFit, IsNoneWhereItIsNestedTooDeep) {
  for (const char kind : {'\x81', '\x7f', '\x5f'})  // lists, pieces of text, pieces of bytes
    EXPECT_FALSE(FitFromBytes(std::string(1'000'000, kind) + '\0').has_value());
}

class FitRunnerTest : public testing::Test {
 protected:
  FitRunnerTest() { fs::create_directories(fits_); }

  // Runs it and counts its iterations.
  FitResult Run(const FitConfig& config) {
    FitCallbacks callbacks;
    iterations_ = 0;
    callbacks.progress = [this](const FitProgress&) { ++iterations_; };
    return FitRunner(&stop_, fits_).Run(MakeScene(recording_, config), config, nullptr, callbacks);
  }

  const TestFolder folder_;
  const fs::path fits_ = folder_.path() / "fits";
  Recording recording_ = FallingCloth();
  FitConfig config_ = QuickConfig(recording_);
  std::atomic<bool> stop_{false};
  int iterations_ = 0;
};

TEST_F(FitRunnerTest, WithNothingFreeOnlySimulates) {
  for (auto& [name, setting] : config_.parameters) setting.free = false;
  const FitResult fit = Run(config_);
  EXPECT_EQ(fit.status, FitStatus::kConverged);
  EXPECT_NEAR(fit.cost_after, fit.cost_before, 1e-9 * fit.cost_before);
  EXPECT_GT(fit.cost_after, 0.0);
}

TEST_F(FitRunnerTest, GivesTheSameResultWithoutFittingAgain) {
  const FitResult first = Run(config_);
  ASSERT_GT(iterations_, 0);
  const FitResult kept = Run(config_);
  EXPECT_EQ(iterations_, 0);
  EXPECT_EQ(kept.status, first.status);
  EXPECT_EQ(kept.theta, first.theta);
  EXPECT_EQ(kept.parameters, first.parameters);
  EXPECT_EQ(kept.cost_before, first.cost_before);
  EXPECT_EQ(kept.cost_after, first.cost_after);
  EXPECT_EQ(kept.seconds, first.seconds);
  EXPECT_EQ(kept.noise_factor, first.noise_factor);
  EXPECT_EQ(kept.statements, first.statements);
  EXPECT_EQ(kept.after.complete, first.after.complete);
  EXPECT_EQ(kept.after.marker_rms, first.after.marker_rms);
  EXPECT_EQ(kept.after.held_out_marker_rms, first.after.held_out_marker_rms);
  EXPECT_EQ(kept.after.track_rms, std::nullopt);
  EXPECT_EQ(kept.steps.newton_iterations, first.steps.newton_iterations);
  EXPECT_EQ(kept.steps.handle_work, first.steps.handle_work);
  ASSERT_EQ(kept.estimates.size(), first.estimates.size());
  for (std::size_t i = 0; i < kept.estimates.size(); ++i) {
    const ParameterEstimate &a = kept.estimates[i], &b = first.estimates[i];
    EXPECT_EQ(std::tie(a.name, a.unit, a.value, a.start, a.free, a.determined, a.at_bound),
              std::tie(b.name, b.unit, b.value, b.start, b.free, b.determined, b.at_bound));
    EXPECT_EQ(std::tie(a.lower95, a.upper95), std::tie(b.lower95, b.upper95)) << a.name;
  }
}

TEST_F(FitRunnerTest, RunsOnceWhatManyThreadsAskFor) {
  const Scene scene = MakeScene(recording_, config_);
  std::atomic<int> alone = 0, together = 0;
  FitCallbacks callbacks;
  callbacks.progress = [&](const FitProgress&) { ++alone; };
  const FitResult fit = FitRunner().Run(scene, config_, nullptr, callbacks);
  callbacks.progress = [&](const FitProgress&) { ++together; };
  const FitRunner runner(&stop_, fits_);
  ParallelFor(4, 4, [&](int, int) {
    EXPECT_EQ(runner.Run(scene, config_, nullptr, callbacks).theta, fit.theta);
  });
  EXPECT_EQ(together, alone);
  EXPECT_EQ(NumKeptFits(fits_), 1);
}

TEST_F(FitRunnerTest, KeepsNothingWithoutAFolder) {
  FitRunner().Run(MakeScene(recording_, config_), config_);
  EXPECT_EQ(NumKeptFits(fits_), 0);
  EXPECT_EQ(NumKeptFits(folder_.path() / "nowhere"), 0);
}

TEST_F(FitRunnerTest, FitsAgainWhatIsDamaged) {
  const FitResult first = Run(config_);
  const fs::path file = OnlyFile(fits_);
  const auto size = fs::file_size(file);
  fs::resize_file(file, size / 2);
  EXPECT_EQ(Run(config_).theta, first.theta);
  EXPECT_GT(iterations_, 0);
  EXPECT_EQ(fs::file_size(file), size);
}

TEST_F(FitRunnerTest, KeepsNoneThatWasInterrupted) {
  stop_ = true;
  EXPECT_EQ(Run(config_).status, FitStatus::kInterrupted);
  EXPECT_EQ(NumKeptFits(fits_), 0);
}

// A cloth above one obstacle of each shape, the mesh's a triangle whose last corner is `height` m
// up.
Recording AboveObstacles(const TestFolder& folder, double height) {
  Recording recording = FallingCloth();
  recording.ground_height = -1.0;
  recording.cameras.emplace_back();
  recording.files.emplace_back();
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 " + std::to_string(height) + "\nf 1 2 3\n";
  recording.obstacles.resize(4);
  recording.obstacles[0].shape = BallShape{0.1};
  recording.obstacles[1].shape = BarShape{0.1, 0.3};
  recording.obstacles[2].shape = BoxShape{{0.1, 0.2, 0.3}};
  recording.obstacles[3].shape = MeshShape{folder.Write("wall.obj", mesh)};
  return recording;
}

class FitKeyTest : public testing::Test {
 protected:
  std::string KeyOf(const Recording& recording) const {
    return FitKey(MakeScene(recording, config_), config_, nullptr);
  }
  void ExpectAnother(const std::string& key, const std::string& what) {
    EXPECT_EQ(key.size(), 64U) << what;
    EXPECT_TRUE(seen_.insert(key).second) << what;
  }
  void ChangeRecording(const std::string& what, const std::function<void(Recording*)>& change) {
    Recording changed = recording_;
    change(&changed);
    ExpectAnother(KeyOf(changed), what);
  }
  void ChangeScene(const std::string& what, const std::function<void(Scene*)>& change) {
    Scene changed = scene_;
    change(&changed);
    ExpectAnother(FitKey(changed, config_, nullptr), what);
  }
  void ChangeConfig(const std::string& what, const std::function<void(FitConfig*)>& change) {
    FitConfig changed = config_;
    change(&changed);
    ExpectAnother(FitKey(scene_, changed, nullptr), what);
  }

  const TestFolder folder_;
  const Recording recording_ = AboveObstacles(folder_, 0.5);
  const FitConfig config_ = QuickConfig(recording_);
  const Scene scene_ = MakeScene(recording_, config_);
  std::set<std::string> seen_ = {FitKey(scene_, config_, nullptr)};
};

TEST_F(FitKeyTest, IsTheSameForTheSameWhereverItLies) {
  Recording moved = recording_;
  moved.path = "/elsewhere";
  EXPECT_EQ(seen_.count(KeyOf(moved)), 1U);
}

TEST_F(FitKeyTest, IsAnotherForWhateverIsRecorded) {
  ChangeRecording("marker", [](Recording* r) { r->markers[3].position.x() += 1e-12; });
  ChangeRecording("marker on cloth", [](Recording* r) { r->markers[3].uv.x() += 1e-9; });
  ChangeRecording("marker's sigma", [](Recording* r) { *r->noise.marker += 1e-9; });
  ChangeRecording("frame rate", [](Recording* r) { r->frame_rate += 1e-9; });
  ChangeRecording("gravity", [](Recording* r) { r->gravity.z() -= 1e-9; });
  ChangeRecording("ground", [](Recording* r) { *r->ground_height += 1e-9; });
  ChangeRecording("no ground", [](Recording* r) { r->ground_height.reset(); });
  ChangeRecording("size", [](Recording* r) { r->cloth.size.x() += 1e-9; });
  ChangeRecording("density", [](Recording* r) { *r->cloth.areal_density += 1e-9; });
  ChangeRecording("placement", [](Recording* r) {
    std::get<FlatPlacement>(r->cloth.initial).origin.x() += 1e-9;
  });
  ChangeRecording("split", [](Recording* r) { r->splits.held_out_frames->first -= 1; });
  ChangeRecording("held-out camera",
                  [](Recording* r) { r->splits.held_out_cameras.emplace_back("other"); });
}

TEST_F(FitKeyTest, IsAnotherForWhateverHoldsTheClothOrSeesIt) {
  ChangeRecording("path", [](Recording* r) { r->handles[0].path->at(2)->y() += 1e-9; });
  ChangeRecording("path's sigma", [](Recording* r) { *r->handles[0].path_sigma *= 2.0; });
  ChangeRecording("unknown path", [](Recording* r) { r->handles[0].path.reset(); });
  ChangeRecording("release", [](Recording* r) { r->handles[0].released_after = 2; });
  ChangeRecording("lens", [](Recording* r) { r->cameras[0].distortion[4] += 1e-9; });
  ChangeRecording("picture", [](Recording* r) { r->cameras[0].width += 1; });
  ChangeRecording("camera", [](Recording* r) { r->cameras.push_back({}); });
  ChangeRecording("mask faults", [](Recording* r) { r->files[0].mask_faults.fat = 0.5; });
}

TEST_F(FitKeyTest, IsAnotherForWhateverIsInTheWay) {
  const auto shape_of = [](Recording * r, int i) -> auto& { return r->obstacles[i].shape; };
  ChangeRecording("ball", [&](Recording* r) { shape_of(r, 0) = BallShape{0.1 + 1e-9}; });
  ChangeRecording("bar", [&](Recording* r) { shape_of(r, 1) = BarShape{0.1, 0.3 + 1e-9}; });
  ChangeRecording("box", [&](Recording* r) { shape_of(r, 2) = BoxShape{{0.1, 0.2, 0.4}}; });
  ChangeRecording("table", [&](Recording* r) { shape_of(r, 2) = BoxShape{{0.1, 0.2, 0.3}, 0.5}; });
  ChangeRecording("place", [](Recording* r) { r->obstacles[2].path[0].position.x() += 1e-9; });
  ChangeRecording("fewer", [](Recording* r) { r->obstacles.pop_back(); });
  ExpectAnother(KeyOf(AboveObstacles(folder_, 0.6)), "mesh");
}

TEST_F(FitKeyTest, IsAnotherForWhateverIsSimulated) {
  ChangeScene("rest shape", [](Scene* s) { s->mesh.uv[3].x() += 1e-12; });
  ChangeScene("triangles", [](Scene* s) { s->mesh.triangles.pop_back(); });
  ChangeScene("start", [](Scene* s) { s->initial[5] += 1e-12; });
  ChangeScene("steps", [](Scene* s) { s->steps_per_frame += 1; });
  ChangeScene("fitted frames", [](Scene* s) { s->is_fitted[1] = !s->is_fitted[1]; });
  const auto with_mask = [](int last) {
    auto silhouettes = std::make_shared<Silhouettes>();
    silhouettes->observations.resize(1);
    silhouettes->observations[0].mask = BitMask(8, 2);
    silhouettes->observations[0].mask.SetSpan(1, last, last);
    return silhouettes;
  };
  ChangeScene("mask", [&](Scene* s) { s->silhouettes = with_mask(3); });
  ChangeScene("as large a mask", [&](Scene* s) { s->silhouettes = with_mask(4); });
}

TEST_F(FitKeyTest, IsAnotherForWhateverIsToldTheFit) {
  const auto bending = [](FitConfig * c) -> auto& { return c->parameters.at("bending.stiffness"); };
  ChangeConfig("value", [&](FitConfig* c) { bending(c).value *= 1.0 + 1e-15; });
  ChangeConfig("free", [&](FitConfig* c) { bending(c).free = false; });
  ChangeConfig("bound", [&](FitConfig* c) { bending(c).lower *= 0.5; });
  ChangeConfig("prior", [&](FitConfig* c) { bending(c).prior_sigma *= 2.0; });
  ChangeConfig("loss", [](FitConfig* c) { c->loss = LossKind::kCauchy; });
  ChangeConfig("frames", [](FitConfig* c) { c->frames = {0, 3}; });
  ChangeConfig("attract", [](FitConfig* c) { c->attract = true; });
  ChangeConfig("optimiser", [](FitConfig* c) { c->optimiser = "pattern"; });
  ChangeConfig("iterations", [](FitConfig* c) { c->max_iterations += 1; });
  FitCheckpoint from;
  ExpectAnother(FitKey(scene_, config_, &from), "from elsewhere");
  from.theta = Eigen::VectorXd::Zero(2);
  ExpectAnother(FitKey(scene_, config_, &from), "from another theta");
}

TEST(DiagnosisFolder, GoesOnWithWhatIsNotFinishedOnly) {
  using Existing = DiagnosisFolder::Existing;
  const TestFolder folder;
  const fs::path place = folder.path() / "run", fits = place / "fits";
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kInterrupted;
  {
    const DiagnosisFolder begun(place, Existing::kResume);
    for (const char* kind : {"", "forecasts-", "forecasts-1-"})
      WriteWholeFile(begun.KeptFits() / (kind + std::string(64, 'a') + ".cbor"), "kept");
    begun.Write(diagnosis);
  }
  const auto error_of = [&](Existing existing) -> std::string {
    try {
      DiagnosisFolder again(place, existing);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of(Existing::kRefuse), HasSubstr("--resume goes on with it"));
  const std::string part = "run/fits/.forecasts-" + std::string(64, 'b') + ".cbor.a1b2c3.part";
  folder.Write(part, "half of a fit, whose writer was killed");
  folder.Write("run/fits/.mine.txt.a1b2c3.part", "mine");
  EXPECT_EQ(error_of(Existing::kResume), "");
  EXPECT_EQ(NumKeptFits(fits), 3);
  EXPECT_FALSE(fs::exists(folder.path() / part));
  EXPECT_TRUE(fs::remove(fits / ".mine.txt.a1b2c3.part"));
  folder.Write("run/fits/mine.txt", "mine");
  EXPECT_EQ(error_of(Existing::kReplace), "");
  EXPECT_EQ(NumKeptFits(fits), 0);
  diagnosis.verdict = Verdict::kNothingMissing;
  DiagnosisFolder(place, Existing::kResume).Write(diagnosis);
  EXPECT_THAT(error_of(Existing::kResume), HasSubstr("there is nothing to resume"));
  EXPECT_THAT(error_of(Existing::kRefuse), HasSubstr("already holds a diagnosis"));
  EXPECT_EQ(ReadTextFile(fits / "mine.txt"), "mine");
  fs::remove(fits / "mine.txt");
  DiagnosisFolder(place, Existing::kReplace).Write(diagnosis);
  EXPECT_FALSE(fs::exists(fits));
}

}  // namespace
}  // namespace clothfit
