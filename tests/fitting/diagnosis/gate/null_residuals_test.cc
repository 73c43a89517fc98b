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

class Twins : public testing::Test {
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
    linear_ = Linearise(*fitted_);
    ASSERT_TRUE(linear_);
  }

  static inline std::optional<FittedScene> fitted_;
  static inline std::optional<LinearisedFit> linear_;
};

TEST_F(Twins, ShowTheSamePointsOfTheClothWhereTheFitHasThemWithNoise) {
  const std::optional<Recording> twin = TwinRecording(*fitted_, 3);
  ASSERT_TRUE(twin);
  const Recording& own = fitted_->scene.recording;
  ASSERT_EQ(twin->markers.size(), own.markers.size());
  ASSERT_EQ(twin->tracks.size(), own.tracks.size());
  EXPECT_EQ(twin->splits.held_out_frames->first, own.splits.held_out_frames->first);
  const auto uv_of = [](const Recording& recording, int frame, int id) {
    const auto found =
        std::find_if(recording.markers.begin(), recording.markers.end(),
                     [&](const Marker& m) { return m.frame == frame && m.id == id; });
    return found->uv;
  };
  for (const Marker& m : twin->markers) EXPECT_EQ(m.uv, uv_of(own, m.frame, m.id));
  // Two of other noise differ by it alone, each by the noise of one and of the other.
  const std::optional<Recording> other = TwinRecording(*fitted_, 4);
  double squares = 0.0;
  for (std::size_t i = 0; i < twin->markers.size(); ++i)
    squares += (twin->markers[i].position - other->markers[i].position).squaredNorm();
  const double rms = std::sqrt(squares / static_cast<double>(3 * twin->markers.size()));
  EXPECT_NEAR(rms, std::sqrt(2.0) * fitted_->scene.marker_sigma, 0.1 * fitted_->scene.marker_sigma);
  const std::optional<Recording> again = TwinRecording(*fitted_, 3);
  EXPECT_EQ(again->markers.back().position, twin->markers.back().position);
  EXPECT_EQ(again->tracks.back().pixel, twin->tracks.back().pixel);
  CheckRecording(*twin);
}

TEST_F(Twins, AreDrawnNearTheFit) {
  const std::vector<FittedScene> drawn = DrawNearFit(*fitted_, linear_->rows, 4, 1);
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

TEST_F(Twins, AreFittedElsewhereThanTheyWereMade) {
  const std::vector<DiscretisationShift> shifts = MeasureShifts(*fitted_, *linear_, 2, 1);
  ASSERT_EQ(shifts.size(), 2u);
  for (const DiscretisationShift& shift : shifts) {
    ASSERT_EQ(shift.by.size(), static_cast<Eigen::Index>(linear_->rows.entries.size()));
    EXPECT_TRUE(shift.by.allFinite());
    EXPECT_GT(shift.by.norm(), 0.0);
    EXPECT_GT(shift.left_squared, 0.0);
  }
  const std::vector<DiscretisationShift> again = MeasureShifts(*fitted_, *linear_, 2, 1);
  ASSERT_EQ(again.size(), shifts.size());
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    EXPECT_EQ(again[k].by, shifts[k].by);
    EXPECT_EQ(again[k].left_squared, shifts[k].left_squared);
  }
}

}  // namespace
}  // namespace clothfit
