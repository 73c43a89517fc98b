// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/sensor.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "tracking/normal_numbers.h"

namespace clothfit {
namespace {

constexpr double kWhite = 255.0;  // grey levels

}  // namespace

cv::Mat Expose(const cv::Mat& brightness, const Sensor& sensor, double gain, std::uint64_t seed,
               std::uint64_t stream) {
  NormalNumbers numbers(seed, stream);
  cv::Mat picture(brightness.size(), CV_8UC3);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec3f& in = brightness.at<cv::Vec3f>(y, x);
      cv::Vec3b& out = picture.at<cv::Vec3b>(y, x);
      for (int k = 0; k < 3; ++k) {
        const double light = sensor.exposure * gain * std::max(0.0, static_cast<double>(in[k]));
        const double level = kWhite * std::pow(light, 1.0 / sensor.gamma);
        const double variance =
            sensor.noise * sensor.noise + sensor.shot_noise * sensor.shot_noise * level / kWhite;
        out[k] = cv::saturate_cast<uchar>(level + std::sqrt(variance) * numbers.Next());
      }
    }
  }
  return picture;
}

cv::Mat ExposeMean(const cv::Mat& brightness, const Sensor& sensor, int count, std::uint64_t seed,
                   std::uint64_t stream) {
  cv::Mat sum = cv::Mat::zeros(brightness.size(), CV_32FC3);
  for (int i = 0; i < count; ++i) {
    cv::Mat one;
    Expose(brightness, sensor, 1.0, seed, stream + static_cast<std::uint64_t>(i))
        .convertTo(one, CV_32FC3);
    sum += one;
  }
  cv::Mat mean;
  sum.convertTo(mean, CV_8UC3, 1.0 / count);
  return mean;
}

double LightGain(double time, double amount) {
  // Two periods (s) without a common one, so that no two moments are quite alike.
  constexpr double kTwoPi = 6.283185307179586;
  return 1.0 + amount * (0.7 * std::sin(kTwoPi * time / 7.3) + 0.3 * std::sin(kTwoPi * time / 2.9));
}

}  // namespace clothfit
