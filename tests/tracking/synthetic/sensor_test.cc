// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/sensor.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace clothfit {
namespace {

constexpr int kSide = 100;  // px
constexpr double kCount = 3.0 * kSide * kSide;

cv::Mat Grey(float brightness) {
  return cv::Mat(kSide, kSide, CV_32FC3, cv::Scalar::all(static_cast<double>(brightness)));
}

struct Moments {
  double mean, deviation;
};

Moments MomentsOf(const cv::Mat& picture) {
  cv::Mat mean, deviation;
  cv::meanStdDev(picture.reshape(1), mean, deviation);
  return {mean.at<double>(0), deviation.at<double>(0)};
}

TEST(Sensor, WithoutNoiseIsThePowerLaw) {
  Sensor sensor;
  sensor.noise = 0.0;
  for (const float brightness : {0.01F, 0.2F, 0.7F, 1.2F}) {
    const double light = sensor.exposure * static_cast<double>(brightness);
    const Moments moments = MomentsOf(Expose(Grey(brightness), sensor, 1.0, 1, 0));
    EXPECT_NEAR(moments.mean, 255.0 * std::pow(light, 1.0 / sensor.gamma), 0.51);  // rounding
    EXPECT_EQ(moments.deviation, 0.0);
  }
  EXPECT_EQ(MomentsOf(Expose(Grey(9.0F), sensor, 1.0, 1, 0)).mean, 255.0);
}

TEST(Sensor, HasTheNoiseAskedFor) {
  Sensor sensor;
  sensor.noise = 3.0;
  const Moments plain = MomentsOf(Expose(Grey(0.4F), sensor, 1.0, 1, 0));
  // Rounding to whole levels adds 1 / 12 to the variance; five standard errors, sigma / sqrt(2 n).
  const double expected = std::sqrt(9.0 + 1.0 / 12.0);
  EXPECT_NEAR(plain.deviation, expected, 5.0 * expected / std::sqrt(2.0 * kCount));
  sensor.shot_noise = 4.0;
  const Moments shot = MomentsOf(Expose(Grey(0.4F), sensor, 1.0, 1, 0));
  const double more = std::sqrt(9.0 + 1.0 / 12.0 + 16.0 * shot.mean / 255.0);
  EXPECT_NEAR(shot.deviation, more, 5.0 * more / std::sqrt(2.0 * kCount));
  const Moments calm = MomentsOf(Expose(Grey(0.4F), Averaged(sensor, 16), 1.0, 1, 0));
  const double less = std::sqrt((9.0 + 16.0 * shot.mean / 255.0) / 16.0 + 1.0 / 12.0);
  EXPECT_NEAR(calm.deviation, less, 5.0 * less / std::sqrt(2.0 * kCount));
}

TEST(Sensor, NoiseIsThatOfItsSeedAndStream) {
  const cv::Mat first = Expose(Grey(0.4F), {}, 1.0, 1, 7);
  EXPECT_EQ(cv::norm(first, Expose(Grey(0.4F), {}, 1.0, 1, 7), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(first, Expose(Grey(0.4F), {}, 1.0, 1, 8), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(first, Expose(Grey(0.4F), {}, 1.0, 2, 7), cv::NORM_INF), 0.0);
}

TEST(LightGain, DriftsSlowlyWithinItsAmount) {
  EXPECT_EQ(LightGain(0.0, 0.05), 1.0);
  double low = 1.0, high = 1.0;
  for (double time = 0.0; time < 30.0; time += 1.0 / 30.0) {
    const double gain = LightGain(time, 0.05);
    low = std::min(low, gain);
    high = std::max(high, gain);
    EXPECT_LT(std::abs(LightGain(time + 1.0 / 30.0, 0.05) - gain), 0.003);
  }
  EXPECT_GE(low, 0.95);
  EXPECT_LE(high, 1.05);
  EXPECT_GT(high - low, 0.07);
}

}  // namespace
}  // namespace clothfit
