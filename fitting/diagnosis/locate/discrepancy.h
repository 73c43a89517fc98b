// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where, when and how strongly a force is missing.
#pragma once

#include <string>

#include <Eigen/Core>

namespace clothfit {

struct Discrepancy {
  bool is_significant = false;  // against the re-simulated null
  double p_value = 1.0;
  int first_frame = 0, last_frame = 0;  // inclusive
  Eigen::Vector2d low_uv, high_uv;      // m, corners of the region on the cloth
  Eigen::Vector3d direction;            // world, unit; mean over region and time
  double peak = 0.0, peak_sigma = 0.0;  // N/m^2, where and when it is largest
  double even = 0.0, even_sigma = 0.0;  // N/m^2, of the even force on the region that explains most
  std::string words;
};

}  // namespace clothfit
