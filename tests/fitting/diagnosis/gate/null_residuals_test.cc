// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/gate/null_residuals.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

TEST(DrawnNulls, HoldDiscretisationErrorsOfEitherSign) {
  constexpr double kAmount = 20.0;
  const std::vector<NullResidual> nulls =
      DrawNulls(Eigen::MatrixXd::Identity(3, 3), 100, {{1, kAmount}}, {}, 400, 1);
  ASSERT_EQ(nulls.size(), 400u);
  int positive = 0;
  double sum = 0.0, squares = 0.0;
  for (const NullResidual& null : nulls) {
    positive += null.products[1] > 0.0 ? 1 : 0;
    sum += std::abs(null.products[1]);
    squares += null.squared;
  }
  EXPECT_GT(positive, 160);
  EXPECT_LT(positive, 240);
  EXPECT_NEAR(sum / 400.0, kAmount, 1.5);
  // Noise of 100 rows, and the amount with a tenth of it again for its spread of 0.3.
  EXPECT_NEAR(squares / 400.0, 100.0 + 1.09 * kAmount * kAmount, 60.0);
}

class NearFit : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    SyntheticOptions options;
    options.size = {0.5, 0.5};
    options.resolution = {5, 5};
    options.markers = {4, 4};
    options.marker_sigma = 0.001;
    options.frame_rate = 24.0;
    options.frame_count = 18;
    options.num_cameras = 2;
    const Recording recording =
        WithHeldOutFrames(MakeSyntheticRecording(options).recording, 1.0 / 3.0);
    FitConfig config = DefaultConfig(recording);
    for (auto& [name, setting] : config.parameters) setting.free = false;
    config.parameters.at("stretch.stiffness").free = true;
    config.parameters.at("air_drag.normal").free = true;
    fitted_ = FitAfresh({recording, config}, Start::kPlain, 6, FitRunner());
    ASSERT_TRUE(fitted_);
    const RowFrames frames(fitted_->scene, ObservationResiduals(fitted_->scene, fitted_->config),
                           kMostRows);
    rows_ = EvaluateRows(*fitted_, BaselinePass(*fitted_), frames, {});
    ASSERT_TRUE(rows_);
  }

  static inline std::optional<FittedScene> fitted_;
  static inline std::optional<Rows> rows_;
};

TEST_F(NearFit, IsDrawn) {
  const std::vector<FittedScene> drawn = DrawNearFit(*fitted_, *rows_, 4, 1);
  ASSERT_EQ(drawn.size(), 4u);
  const double value = fitted_->values.parameters.at("air_drag.normal").value;
  double furthest = 0.0;
  for (const FittedScene& scene : drawn) {
    const double own = scene.values.parameters.at("air_drag.normal").value;
    furthest = std::max(furthest, std::abs(own - value));
    EXPECT_NEAR(own, value, 0.5 * value);
  }
  EXPECT_GT(furthest, 0.0);
}

}  // namespace
}  // namespace clothfit
