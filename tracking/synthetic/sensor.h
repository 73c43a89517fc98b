// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a camera's sensor makes of the light that reaches it.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace clothfit {

struct Sensor {
  double exposure = 0.6;    // share of the light of a full scale that brightness 1 gives
  double gamma = 2.2;       // grey levels go as the light to the power of 1 / gamma
  double noise = 2.0;       // grey levels of 255, one sigma of each channel
  double shot_noise = 0.0;  // grey levels, sigma that a white pixel has besides; as the root of
                            // the grey level
};

// CV_8UC3 of a CV_32FC3 picture (1: white on the floor below the lamp), times `gain`. The noise is
// that of the seed and the stream.
cv::Mat Expose(const cv::Mat& brightness, const Sensor& sensor, double gain, std::uint64_t seed,
               std::uint64_t stream);

// A sensor whose pictures are the mean of `count` of this one's.
Sensor Averaged(const Sensor& sensor, int count);

// Gain of the light at a time (s): 1 at the time 0, afterwards slowly within about 1 +- amount.
double LightGain(double time, double amount);

}  // namespace clothfit
