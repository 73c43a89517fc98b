// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that know points without names only.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"
#include "fitting/residuals/synthesis_error.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/runs/fit_run.h"
#include "tests/support/test_folder.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

constexpr double kWind = 0.8;     // m/s along y
constexpr double kSigma = 0.002;  // m

// A cloth that swings from two corners in wind.
class CloudFitTest : public testing::Test {
 protected:
  CloudFitTest() {
    SyntheticOptions options;
    options.resolution = {7, 7};
    options.frame_count = 24;
    options.frame_rate = 24.0;
    options.steps_per_frame = 5;  // as the fit's, of at most 1/120 s
    options.markers = {0, 0};
    options.cloud_points = 300;
    options.cloud_sigma = kSigma;
    options.buckling = false;  // clouds are tested, on cloth that is nearer to linear
    options.parameters = {{"wind.y", kWind}};
    WriteFiles(FilesOf(MakeSyntheticRecording(options)), folder_);
    config_ = DefaultConfig(ReadRecording(folder_.path()));
    config_.buckling = options.buckling;
    for (auto& [name, setting] : config_.parameters) setting.free = false;
    for (const char* name : {"wind.x", "wind.y", "wind.z", "bending.stiffness"})
      config_.parameters.at(name).free = true;
  }

  Scene MakeOwnScene() const { return MakeScene(ReadRecording(folder_.path()), config_); }

  TestFolder folder_;
  FitConfig config_;
};

TEST_F(CloudFitTest, FindsTheWind) {
  const Scene scene = MakeOwnScene();
  CheckFittable(scene, config_);
  ASSERT_TRUE(scene.clouds);
  EXPECT_EQ(scene.clouds->observations.size(), 24u);  // held-out ones too
  EXPECT_EQ(scene.last_fitted_frame, 15);
  const FitResult fit = RunFit(scene, config_);
  EXPECT_EQ(fit.status, FitStatus::kConverged);
  for (const ParameterEstimate& estimate : fit.estimates) {
    if (!estimate.free || estimate.name == "bending.stiffness") continue;
    const double truth = estimate.name == "wind.y" ? kWind : 0.0;
    // Three sigmas and half of one, where 95 % are two: three unknowns are compared.
    const double margin = 0.4 * (estimate.upper95 - estimate.lower95);
    EXPECT_GT(truth, estimate.lower95 - margin) << estimate.name;
    EXPECT_LT(truth, estimate.upper95 + margin) << estimate.name;
    if (truth != 0.0) {
      EXPECT_GT(estimate.lower95, 0.5 * truth) << estimate.name;
    }
  }
  // The noise across the surface is one coordinate's; along it nothing is seen.
  EXPECT_NEAR(*fit.after.cloud_rms, kSigma, 0.25 * kSigma);
  // What is foreseen is off by the intervals, too.
  EXPECT_LT(*fit.after.held_out_cloud_rms, 2.0 * kSigma);
  EXPECT_GT(*fit.before.held_out_cloud_rms, 5.0 * *fit.after.held_out_cloud_rms);
}

// The whole way from the parameters through the simulation to the distances.
TEST_F(CloudFitTest, HasTheGradientOfItsCost) {
  config_.loss = LossKind::kHuber;
  config_.loss_scale = 1.0;
  const Scene scene = MakeOwnScene();
  const FreeParameters free(config_, scene, MakeParameterTable());
  Eigen::VectorXd theta = free.start();
  theta.array() += 0.1;
  const auto cost = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd residuals;
    EXPECT_TRUE(EvaluateResiduals(scene, config_, free, at, 15, &residuals, nullptr));
    return 0.5 * residuals.squaredNorm();
  };
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  ASSERT_TRUE(EvaluateResiduals(scene, config_, free, theta, 15, &residuals, &jacobian));
  const Eigen::VectorXd gradient = jacobian.transpose() * residuals;
  for (int i = 0; i < free.size(); ++i) {
    constexpr double kStep = 1e-4;
    const Eigen::VectorXd e = kStep * Eigen::VectorXd::Unit(free.size(), i);
    const double wide = (cost(theta + e) - cost(theta - e)) / (2.0 * kStep);
    const double narrow = (cost(theta + 0.5 * e) - cost(theta - 0.5 * e)) / kStep;
    // Closest points of a few change from one triangle to another within the step.
    const double slope = (4.0 * narrow - wide) / 3.0;
    EXPECT_NEAR(gradient[i], slope, 1e-3 * std::abs(slope) + 1e-4 * gradient.norm())
        << free.entries()[i].name;
  }
}

TEST_F(CloudFitTest, ComesToTheSameNumbersWithAnyNumberOfThreads) {
  const auto rows = [&] {
    const Scene scene = MakeOwnScene();
    const FreeParameters free(config_, scene, MakeParameterTable());
    std::pair<Eigen::VectorXd, Eigen::MatrixXd> found;
    EXPECT_TRUE(
        EvaluateResiduals(scene, config_, free, free.start(), 5, &found.first, &found.second));
    return found;
  };
  const auto by_all = rows();
  const InsideParallelWork one_thread;
  const auto by_one = rows();
  EXPECT_EQ(by_all.first, by_one.first);
  EXPECT_EQ(by_all.second, by_one.second);
  EXPECT_GT(by_all.first.size(), 6 * 300);
}

TEST_F(CloudFitTest, TakesAsManyPointsAsAreWanted) {
  config_.cloud_points = 50;
  const Scene scene = MakeOwnScene();
  for (const CloudObservation& cloud : scene.clouds->observations) {
    EXPECT_LE(cloud.points.size(), 50u);
    EXPECT_GT(cloud.points.size(), 25u);
    EXPECT_GT(cloud.spacing, 0.03);  // of 0.16 m^2
  }
  const ObservationResiduals residuals(scene, config_);
  const auto of_first = static_cast<int>(scene.clouds->observations[0].points.size());
  EXPECT_EQ(residuals.NumObserved(0, 0), of_first);
  EXPECT_EQ(residuals.Count(0, 0), of_first + scene.mesh.num_particles());
  EXPECT_EQ(residuals.Count(16), 0);                                               // held out
  EXPECT_GT(SynthesisError(scene, config_).MeanAttractor(0, scene.initial), 0.5);  // mm
  config_.use_clouds = false;
  EXPECT_THAT(InputErrorOf([&] { CheckFittable(MakeOwnScene(), config_); }),
              testing::HasSubstr("nothing to fit"));
}

}  // namespace
}  // namespace clothfit
