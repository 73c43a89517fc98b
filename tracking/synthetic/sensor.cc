// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/sensor.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "autodiff_sim/base/normal_numbers.h"

namespace clothfit {
namespace {

constexpr double kWhite = 255.0;  // grey levels

// The grey level of an amount of light, 1 for the full scale; interpolated in a table, to 0.01 of a
// level where there is any light to speak of.
class GreyLevels {
 public:
  explicit GreyLevels(double gamma) {
    for (int i = 0; i <= kLast; ++i)
      table_.push_back(kWhite * std::pow(Root(i) * Root(i), 1.0 / gamma));
  }
  double operator()(double light) const {
    const double place = kPerOne * std::sqrt(std::clamp(light, 0.0, kMost));
    const int before = std::min(static_cast<int>(place), kLast - 1);
    const double rest = place - before;
    return (1.0 - rest) * table_[static_cast<std::size_t>(before)] +
           rest * table_[static_cast<std::size_t>(before) + 1];
  }

 private:
  // By the root of the light, as the levels grow steeply in the dark.
  static constexpr double kMost = 4.0;
  static constexpr int kPerOne = 512, kLast = 2 * kPerOne;
  static double Root(int i) { return static_cast<double>(i) / kPerOne; }

  std::vector<double> table_;
};

}  // namespace

cv::Mat Expose(const cv::Mat& brightness, const Sensor& sensor, double gain, std::uint64_t seed,
               std::uint64_t stream) {
  NormalNumbers numbers(seed, stream);
  const GreyLevels levels(sensor.gamma);
  cv::Mat picture(brightness.size(), CV_8UC3);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec3f& in = brightness.at<cv::Vec3f>(y, x);
      cv::Vec3b& out = picture.at<cv::Vec3b>(y, x);
      for (int k = 0; k < 3; ++k) {
        const double level = levels(sensor.exposure * gain * static_cast<double>(in[k]));
        const double variance =
            sensor.noise * sensor.noise + sensor.shot_noise * sensor.shot_noise * level / kWhite;
        out[k] = cv::saturate_cast<uchar>(level + std::sqrt(variance) * numbers.Next());
      }
    }
  }
  return picture;
}

Sensor Averaged(const Sensor& sensor, int count) {
  Sensor averaged = sensor;
  averaged.noise /= std::sqrt(count);
  averaged.shot_noise /= std::sqrt(count);
  return averaged;
}

double LightGain(double time, double amount) {
  // Two periods (s) without a common one, so that no two moments are quite alike.
  return 1.0 + amount * (0.7 * std::sin(2.0 * M_PI * time / 7.3) +
                         0.3 * std::sin(2.0 * M_PI * time / 2.9));
}

}  // namespace clothfit
