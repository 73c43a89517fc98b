// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that are kept while a diagnosis is under way.
#include "fitting/diagnosis/fitted/fit_runner.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/answer/folder.h"
#include "fitting/files/whole_file.h"
#include "tests/support/small_recording.h"
#include "tests/support/test_folder.h"

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

TEST(FitKey, IsAnotherForWhateverChangesAFit) {
  const Recording recording = FallingCloth();
  const FitConfig config = QuickConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const std::string key = FitKey(scene, config, nullptr);
  EXPECT_EQ(FitKey(MakeScene(recording, config), config, nullptr), key);

  FitConfig other = config;
  other.parameters.at("bending.stiffness").value *= 1.0 + 1e-15;
  EXPECT_NE(FitKey(scene, other, nullptr), key);
  FitCheckpoint from;
  EXPECT_NE(FitKey(scene, config, &from), key);

  Recording changed = recording;
  changed.markers[3].position.x() += 1e-12;
  EXPECT_NE(FitKey(MakeScene(changed, config), config, nullptr), key);
  changed = recording;
  changed.markers[3].uv.x() += 1e-9;
  EXPECT_NE(FitKey(MakeScene(changed, config), config, nullptr), key);
  changed = recording;
  changed.gravity.z() -= 1e-9;
  EXPECT_NE(FitKey(MakeScene(changed, config), config, nullptr), key);
  changed = recording;
  changed.cameras.push_back({});
  EXPECT_NE(FitKey(MakeScene(changed, config), config, nullptr), key);
  changed = recording;
  ASSERT_TRUE(changed.handles[0].path);
  changed.handles[0].path->at(2)->y() += 1e-9;
  EXPECT_NE(FitKey(MakeScene(changed, config), config, nullptr), key);
  changed = recording;
  changed.splits.held_out_frames = Splits::FrameRange{3, 5};
  EXPECT_NE(FitKey(MakeScene(changed, config), config, nullptr), key);
}

TEST(DiagnosisFolder, GoesOnWithWhatIsNotFinishedOnly) {
  using Existing = DiagnosisFolder::Existing;
  const TestFolder folder;
  const fs::path place = folder.path() / "run";
  const DiagnosisFolder begun(place, Existing::kResume);
  WriteWholeFile(begun.KeptFits() / "a.cbor", "kept");
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kInterrupted;
  begun.Write(diagnosis);
  const auto error_of = [&](Existing existing) -> std::string {
    try {
      DiagnosisFolder again(place, existing);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of(Existing::kRefuse), HasSubstr("--resume goes on with it"));
  EXPECT_EQ(error_of(Existing::kResume), "");
  EXPECT_EQ(NumKeptFits(begun.KeptFits()), 1);
  EXPECT_EQ(error_of(Existing::kReplace), "");
  EXPECT_EQ(NumKeptFits(begun.KeptFits()), 0);
  diagnosis.verdict = Verdict::kNothingMissing;
  begun.Write(diagnosis);
  EXPECT_FALSE(fs::exists(begun.KeptFits()));
  EXPECT_THAT(error_of(Existing::kResume), HasSubstr("there is nothing to resume"));
  EXPECT_THAT(error_of(Existing::kRefuse), HasSubstr("already holds a diagnosis"));
}

}  // namespace
}  // namespace clothfit
