// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits by windows that grow.
#include <atomic>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/files/evaluation_journal.h"
#include "fitting/fit/forecast_fit.h"
#include "fitting/fit/search.h"
#include "fitting/rollout/nudging.h"
#include "fitting/rollout/shooting_windows.h"
#include "fitting/studies/recovery_study.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

Recording SmallRecording(int frames = 30) {
  SyntheticOptions options = DemoRecording();
  options.resolution = {5, 5};
  options.frame_count = frames;
  return MakeSyntheticRecording(options).recording;
}

// So heavily damped that it hardly moves: a start that fits of all frames at once do not get away
// from.
FitConfig FarAway(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (const char* name : {"stretch.damping", "shear.damping", "bending.damping"})
    config.parameters.at(name).value = 0.5 * config.parameters.at(name).upper;
  return config;
}

struct Laid {
  explicit Laid(const FitConfig& given, const Recording& recording)
      : config(given),
        scene(MakeScene(recording, config)),
        scenes({{"", &scene, &config}}),
        free(scenes[0].free),
        observations(scenes[0].observations),
        windows(scenes, nullptr) {}
  bool Lay(const Eigen::VectorXd& theta, int frames) { return windows.Lay(theta, {frames}); }
  FitConfig config;
  Scene scene;
  JointScenes scenes;
  const FreeParameters& free;
  const ObservationResiduals& observations;
  ShootingWindows windows;
};

TEST(ShootingWindows, HoldEachFrameOnce) {
  const Recording recording = SmallRecording();
  Laid laid(DefaultConfig(recording), recording);
  for (const int frames : {4, 7, 100}) {
    ASSERT_TRUE(laid.Lay(laid.free.start(), frames));
    EXPECT_EQ(laid.windows.size(), (laid.scene.last_fitted_frame + frames - 1) / frames);
    Eigen::VectorXd residuals;
    ASSERT_TRUE(laid.windows.Evaluate(laid.free.start(), &residuals, nullptr));
    EXPECT_EQ(residuals.size(), laid.windows.NumResiduals());
    EXPECT_TRUE(residuals.allFinite());
  }
  // One window that begins at the first frame is the simulation of all frames.
  Eigen::VectorXd all, one;
  ASSERT_TRUE(laid.windows.Evaluate(laid.free.start(), &one, nullptr));
  ASSERT_TRUE(EvaluateResiduals(laid.scene, laid.config, laid.free, laid.free.start(),
                                laid.scene.last_fitted_frame, &all, nullptr));
  const double prior = laid.free.PriorResiduals(laid.free.start()).squaredNorm();
  EXPECT_NEAR(one.squaredNorm(), all.squaredNorm() - prior, 1e-9 * all.squaredNorm());
}

TEST(ShootingWindows, GiveAllResidualsInTheOrderOfTheObservations) {
  const Recording recording = SmallRecording();
  Laid laid(DefaultConfig(recording), recording);
  ASSERT_TRUE(laid.Lay(laid.free.start(), 6));
  Eigen::VectorXd compressed;
  ASSERT_TRUE(laid.windows.Evaluate(laid.free.start(), &compressed, nullptr));
  const Eigen::VectorXd all = laid.windows.Residuals(laid.free.start());
  ASSERT_EQ(all.size(), laid.observations.Count(0, laid.scene.last_fitted_frame));
  EXPECT_NEAR(all.squaredNorm(), compressed.squaredNorm(), 1e-9 * all.squaredNorm());
  // Those of the first window are of the open loop's first frames.
  Eigen::VectorXd open_loop;
  ASSERT_TRUE(EvaluateResiduals(laid.scene, laid.config, laid.free, laid.free.start(), 6,
                                &open_loop, nullptr));
  const Eigen::Index first = laid.observations.Count(0, 6);
  EXPECT_LT((all.head(first) - open_loop.head(first)).lpNorm<Eigen::Infinity>(), 1e-12);
}

// Fits to forecasts end with windows of half a second, and their cost is that of all residuals.
TEST(Forecasts, AreFittedAndTellTheirMisfit) {
  const Recording recording = SmallRecording(150);
  Laid laid(FarAway(recording), recording);
  const std::vector<int> lengths = WindowLengths(laid.scene, laid.config);
  const int count = NumForecastLengths(laid.scene, laid.config);
  ASSERT_GE(count, 1);
  ASSERT_GT(static_cast<int>(lengths.size()), count);
  const double lead = kLeadTime * recording.frame_rate;  // frames
  EXPECT_LE(lengths[static_cast<std::size_t>(count - 1)], lead);
  EXPECT_GT(lengths[static_cast<std::size_t>(count)], lead);
  const FitResult fit = FitForecasts(laid.scene, laid.config);
  ASSERT_NE(fit.status, FitStatus::kFailed);
  ASSERT_TRUE(laid.Lay(laid.free.start(), lengths[static_cast<std::size_t>(count - 1)]));
  const double before = laid.windows.Residuals(laid.free.start()).squaredNorm();
  ASSERT_TRUE(fit.misfit);
  EXPECT_EQ(fit.misfit->observed, laid.observations.Count(0, laid.scene.last_fitted_frame));
  EXPECT_LT(fit.cost_after, 0.25 * before);
  const double of_residuals =
      0.5 * fit.misfit->chi_square * (fit.misfit->observed - laid.free.size());
  EXPECT_NEAR(fit.cost_after - of_residuals,
              0.5 * laid.free.PriorResiduals(fit.theta).squaredNorm(), 1e-3 * fit.cost_after);
}

// J'r against central differences of half the sum of squares.
TEST(ShootingWindows, AreDifferentiated) {
  const Recording recording = SmallRecording();
  FitConfig config = DefaultConfig(recording);
  config.tolerance = 1e-11;
  config.initial_order = 1;
  Laid laid(config, recording);
  const Eigen::VectorXd at = laid.free.start();
  ASSERT_TRUE(laid.Lay(at, 6));
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
  ASSERT_TRUE(laid.windows.Evaluate(at, &residuals, &jacobian));
  const Eigen::VectorXd gradient = jacobian.transpose() * residuals;
  const auto cost = [&](const Eigen::VectorXd& theta) {
    Eigen::VectorXd r;
    EXPECT_TRUE(laid.windows.Evaluate(theta, &r, nullptr));
    return 0.5 * r.squaredNorm();
  };
  for (int i = 0; i < laid.free.size(); ++i) {
    constexpr double kStep = 1e-6;  // cloth that begins flat buckles from a strain of 5e-4 on
    Eigen::VectorXd step = Eigen::VectorXd::Zero(at.size());
    step[i] = kStep;
    const double difference = (cost(at + step) - cost(at - step)) / (2.0 * kStep);
    EXPECT_NEAR(gradient[i], difference, 1e-4 * gradient.cwiseAbs().maxCoeff())
        << laid.free.entries()[i].name;
  }
}

TEST(ShootingWindows, DoNotDependOnTheNumberOfThreads) {
  const Recording recording = SmallRecording();
  const FitConfig config = DefaultConfig(recording);
  const auto jacobian = [&] {
    Laid laid(config, recording);
    Eigen::VectorXd residuals;
    RowMajorMatrix columns;
    EXPECT_TRUE(laid.Lay(laid.free.start(), 5));
    EXPECT_TRUE(laid.windows.Evaluate(laid.free.start(), &residuals, &columns));
    return columns;
  };
  const RowMajorMatrix many = jacobian();
  const InsideParallelWork one_thread;
  EXPECT_EQ(many, jacobian());
}

TEST(Windows, NeedPointsAndNoOtherPull) {
  const Recording recording = SmallRecording();
  FitConfig config = DefaultConfig(recording);
  EXPECT_TRUE(FitsWindows(MakeScene(recording, config), config));
  config.attract = true;
  EXPECT_FALSE(FitsWindows(MakeScene(recording, config), config));
  config = DefaultConfig(recording);
  config.window = 0.0;
  EXPECT_FALSE(FitsWindows(MakeScene(recording, config), config));
  config = DefaultConfig(recording);
  config.beta = 0.0;
  EXPECT_FALSE(FitsWindows(MakeScene(recording, config), config));
}

// Of a cloth of 5 x 5 particles, on all of them and on a coarser grid.
class WindowsOf : public testing::TestWithParam<int> {
 protected:
  FitConfig FarAwayConfig() const {
    FitConfig config = FarAway(recording_);
    config.window = 0.1;
    config.window_resolution = GetParam();
    return config;
  }
  const Recording recording_ = SmallRecording();
};

INSTANTIATE_TEST_SUITE_P(Particles, WindowsOf, testing::Values(0, 3),
                         testing::PrintToStringParamName());

TEST_P(WindowsOf, ComeFromAfar) {
  const FitConfig config = FarAwayConfig();
  const Scene scene = MakeScene(recording_, config);
  const FitResult fit = FitByStrategy(scene, config);
  ASSERT_TRUE(fit.misfit);
  EXPECT_EQ(fit.misfit->observed, 3 * 25 * (scene.last_fitted_frame + 1));
  EXPECT_TRUE(fit.misfit->IsNoise()) << fit.misfit->chi_square;
}

TEST_P(WindowsOf, StopWithTheBestSoFarAndGoOnToTheSameBits) {
  const FitConfig config = FarAwayConfig();
  const Scene scene = MakeScene(recording_, config);
  const TestFolder folder;
  std::atomic<bool> stop = false;
  FitCheckpoint last;
  FitCallbacks callbacks;
  callbacks.stop = &stop;
  callbacks.checkpoint = [&](const FitCheckpoint& checkpoint) { last = checkpoint; };
  std::set<std::string> stages;
  callbacks.progress = [&](const FitProgress& progress) {
    stages.insert(progress.stage);
    if (progress.stage.find("windows of 0.2") != std::string::npos && progress.iteration >= 1)
      stop = true;
  };
  EvaluationJournal first(folder.path() / "journal");
  callbacks.journal = &first;
  const FitResult stopped = FitByStrategy(scene, config, callbacks);
  EXPECT_EQ(stopped.status, FitStatus::kInterrupted);
  EXPECT_EQ(last.theta, stopped.theta);
  EXPECT_EQ(last.next_window, 1);
  EXPECT_EQ(last.coarse, GetParam() == 3);
  EXPECT_THAT(stages, testing::Each(testing::StartsWith(GetParam() == 3 ? "3 x 3 particles, windows"
                                                                        : "windows")));
  stop = false;
  callbacks.progress = {};
  EvaluationJournal second(folder.path() / "journal");
  callbacks.journal = &second;
  const FitResult resumed = FitByStrategy(scene, config, callbacks);
  EXPECT_GT(second.num_recalled(), 4);
  const FitResult at_once = FitByStrategy(scene, config);
  EXPECT_EQ(resumed.theta, at_once.theta);
  EXPECT_EQ(resumed.cost_after, at_once.cost_after);
  EXPECT_EQ(resumed.iterations, at_once.iterations);
  EXPECT_EQ(resumed.simulated_frames, at_once.simulated_frames);
  EXPECT_NEAR(resumed.differentiated_frames, at_once.differentiated_frames,
              1e-9 * at_once.differentiated_frames);  // sums of shares, in another order
}

TEST(Windows, CallNothingConvergedThatNothingMoves) {
  const Recording recording = SmallRecording();
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = name == "ground.friction";
  config.initial_order = -1;
  const FitResult fit = FitByStrategy(MakeScene(recording, config), config);
  EXPECT_EQ(fit.status, FitStatus::kNotConverged);
  EXPECT_THAT(fit.statements, testing::Contains(testing::HasSubstr("moves what was observed")));
}

}  // namespace
}  // namespace clothfit
