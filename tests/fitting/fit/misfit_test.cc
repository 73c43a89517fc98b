// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Chi-square and correlation of residuals that are known to hang together, or not to.
#include "fitting/fit/misfit.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/normal_numbers.h"

namespace clothfit {
namespace {

constexpr int kFrames = 60, kSide = 8;

// Residuals of markers on a square grid; `value` gives each, of unit variance.
template <class Value>
std::vector<SeenResidual> Seen(const Value& value) {
  std::vector<SeenResidual> seen;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (int id = 0; id < kSide * kSide; ++id) {
      const Eigen::Vector2d uv(0.1 * (id % kSide), 0.1 * (id / kSide));
      for (int c = 0; c < 3; ++c) seen.push_back({frame, 3 * id + c, c, uv, value(frame, id, c)});
    }
  }
  return seen;
}

std::vector<SeenResidual> Noise(double sigma) {
  NormalNumbers random(7, 0);
  return Seen([&](int, int, int) { return sigma * random.Next(); });
}

TEST(Misfit, OfNoiseIsOneWithinItsLimit) {
  const Misfit misfit = MeasureMisfit(Noise(1.0), 10);
  EXPECT_EQ(misfit.observed, 3 * kFrames * kSide * kSide);
  EXPECT_NEAR(misfit.chi_square, 1.0, 0.04);
  EXPECT_NEAR(misfit.limit, ChiSquareLimit(misfit.observed), 0.02);
  EXPECT_NEAR(misfit.correlation, 1.0, 0.15);
  EXPECT_TRUE(misfit.IsNoise());
}

TEST(Misfit, IsSeenWhereResidualsAreATenthTooLarge) {
  Misfit misfit = MeasureMisfit(Noise(1.1), 10);
  EXPECT_FALSE(misfit.IsNoise());
  EXPECT_FALSE(misfit.IsNoiseAndMesh());
  misfit.without_discretisation = 1.0;
  EXPECT_TRUE(misfit.IsNoiseAndMesh());
  EXPECT_FALSE(misfit.IsNoise());
}

// Five frames with the same value hang together as 5 of 1 sample do.
TEST(Misfit, CountsWhatHangsTogetherInTime) {
  NormalNumbers random(3, 0);
  std::vector<double> held(3 * kSide * kSide);
  const Misfit misfit = MeasureMisfit(Seen([&](int frame, int id, int c) {
                                        double& value = held[3 * id + c];
                                        if (frame % 5 == 0) value = random.Next();
                                        return value;
                                      }),
                                      0);
  EXPECT_NEAR(misfit.correlation, 5.0, 0.8);
  EXPECT_GT(misfit.limit, ChiSquareLimit(misfit.observed));
}

// Each frame has three values: all markers' coordinates are one.
TEST(Misfit, CountsWhatHangsTogetherOverTheCloth) {
  NormalNumbers random(5, 0);
  double now[3] = {};
  const Misfit misfit = MeasureMisfit(Seen([&](int, int id, int c) {
                                        if (id == 0) now[c] = random.Next();
                                        return now[c];
                                      }),
                                      0);
  EXPECT_NEAR(misfit.correlation, kSide * kSide, 0.2 * kSide * kSide);
  EXPECT_NEAR(misfit.limit, ChiSquareLimit(3.0 * kFrames), 0.1);
}

TEST(Misfit, OfNothingIsNone) {
  const Misfit misfit = MeasureMisfit(Seen([](int, int, int) { return 0.0; }), 3);
  EXPECT_EQ(misfit.chi_square, 0.0);
  EXPECT_TRUE(misfit.IsNoise());
  EXPECT_EQ(MeasureMisfit({}, 3).observed, 0);
}

}  // namespace
}  // namespace clothfit
