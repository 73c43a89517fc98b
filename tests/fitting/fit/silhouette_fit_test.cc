// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that know silhouettes only.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"
#include "fitting/residuals/hard_silhouette.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/runs/fit_run.h"
#include "tests/support/silhouette_scene.h"

namespace clothfit {
namespace {

constexpr int kPictureFrames = 15;

class SilhouetteFitTest : public testing::Test {
 protected:
  SilhouetteFitTest()
      : known_(MakeSilhouetteScene()),
        scene_(known_.scene),
        config_(known_.config),
        truth_(known_.truth) {}

  SilhouetteScene known_;
  const Scene& scene_;
  const FitConfig& config_;
  const std::vector<std::pair<std::string, double>>& truth_;
};

TEST_F(SilhouetteFitTest, FindsTheSurface) {
  FitConfig config = config_;
  config.max_iterations = 200;  // the way is rugged: rounding decides how many it takes
  const FitResult fit = RunFit(scene_, config);
  EXPECT_EQ(fit.status, FitStatus::kConverged);
  const FreeParameters free(config, scene_, MakeParameterTable());
  const double before = known_.SurfaceError(free.start());
  const double after = known_.SurfaceError(fit.theta);
  EXPECT_GT(before, 0.01);
  EXPECT_LT(after, 0.0002);  // a pixel is 4 mm
  ASSERT_TRUE(fit.after.silhouette_error.has_value());
  EXPECT_LT(*fit.after.silhouette_error, 0.25 * *fit.before.silhouette_error);
}

// The whole way from the parameters through the simulation to the outlines.
TEST_F(SilhouetteFitTest, HasTheGradientOfItsCost) {
  const FreeParameters free(config_, scene_, MakeParameterTable());
  const Eigen::VectorXd theta = free.start();
  const auto cost = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd residuals;
    EXPECT_TRUE(
        EvaluateResiduals(scene_, config_, free, at, kPictureFrames - 1, &residuals, nullptr));
    return 0.5 * residuals.squaredNorm();
  };
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  ASSERT_TRUE(
      EvaluateResiduals(scene_, config_, free, theta, kPictureFrames - 1, &residuals, &jacobian));
  const Eigen::VectorXd gradient = jacobian.transpose() * residuals;
  for (int i = 0; i < free.size(); ++i) {
    // A few of the nearest points jump within a step, be it wide or narrow: the median of several.
    std::vector<double> slopes;
    for (const double step : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
      const Eigen::VectorXd e = step * Eigen::VectorXd::Unit(free.size(), i);
      slopes.push_back((cost(theta + e) - cost(theta - e)) / (2.0 * step));
    }
    std::sort(slopes.begin(), slopes.end());
    const double slope = slopes[2];
    EXPECT_NEAR(gradient[i], slope, 0.01 * std::abs(slope) + 1e-3 * gradient.norm())
        << free.entries()[i].name;
  }
}

// Where the soft error is least along each free parameter, the hard error is least too, as well as
// pixels can tell.
TEST_F(SilhouetteFitTest, SoftAndHardErrorAgreeOnTheirMinima) {
  FitConfig at_truth = config_;
  for (const auto& [name, value] : truth_) at_truth.parameters.at(name).value = value;
  const FreeParameters free(at_truth, scene_, MakeParameterTable());
  const HardSilhouette hard(scene_);
  int checked = 0;
  for (const auto& [name, value] : truth_) {
    int entry = -1;
    for (int i = 0; i < free.size(); ++i) entry = free.entries()[i].name == name ? i : entry;
    ASSERT_GE(entry, 0) << name;
    double least_soft = std::numeric_limits<double>::infinity(), least_hard = least_soft;
    double best_soft = 0.0, at_best_soft = 0.0;
    for (int step = -6; step <= 6; ++step) {
      const Eigen::VectorXd theta =
          free.start() + 0.15 * step * Eigen::VectorXd::Unit(free.size(), entry);
      Eigen::VectorXd residuals;
      ASSERT_TRUE(EvaluateResiduals(scene_, at_truth, free, theta, kPictureFrames - 1, &residuals,
                                    nullptr));
      double pixels = 0.0;
      SimulateFrames(scene_, at_truth, free, theta, kPictureFrames - 1,
                     [&](int frame, const State& state) {
                       pixels += static_cast<double>(hard.FittedDifference(frame, state.x));
                     });
      least_hard = std::min(least_hard, pixels);
      const double soft = residuals.squaredNorm() - free.PriorResiduals(theta).squaredNorm();
      if (soft >= least_soft) continue;
      least_soft = soft;
      best_soft = 0.15 * step;
      at_best_soft = pixels;
    }
    EXPECT_EQ(least_hard, 0.0);
    EXPECT_LE(std::abs(best_soft), 0.31) << name;
    EXPECT_LT(at_best_soft, 10.0 * 3 * kPictureFrames) << name;  // px a picture
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

// A camera that cannot see what its mask shows leaves the fit without any direction to go.
TEST_F(SilhouetteFitTest, RefusesACameraThatCannotSeeTheStart) {
  EXPECT_NO_THROW(CheckFittable(scene_, config_));
  const auto problem_with = [&](const Eigen::Vector3d& centre) {
    Scene moved = scene_;
    Camera& camera = moved.recording.cameras[1];
    camera.name = "left";
    camera.camera_from_world_translation = -camera.camera_from_world_rotation * centre;
    try {
      CheckFittable(moved, config_);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const Eigen::Vector3d on_cloth = scene_.initial.segment<3>(3 * 24);
  EXPECT_THAT(problem_with({50.0, 0.0, 0.0}), testing::HasSubstr("does not see the cloth"));
  EXPECT_THAT(problem_with(on_cloth), testing::HasSubstr("mm from the cloth"));
  EXPECT_THAT(problem_with(on_cloth), testing::HasSubstr("camera 'left'"));
}

}  // namespace
}  // namespace clothfit
