// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Normally distributed numbers that are the same with every standard library: std::mt19937_64 is
// specified to the bit, std::normal_distribution is not.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include <Eigen/Core>

namespace clothfit {

// Numbers of mean 0 and variance 1 by Box and Muller 1958. Streams of one seed are unrelated.
class NormalNumbers {
 public:
  NormalNumbers(std::uint64_t seed, std::uint64_t stream)
      : engine_(seed * 0x9E3779B97F4A7C15ULL + stream) {}

  double Next() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(Uniform())), angle = 2.0 * M_PI * Uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }

  // The next numbers in the vector's order, which those of a call's arguments do not have.
  template <int kSize>
  Eigen::Matrix<double, kSize, 1> NextVector() {
    Eigen::Matrix<double, kSize, 1> vector;
    for (int k = 0; k < kSize; ++k) vector[k] = Next();
    return vector;
  }

  // Any of 0 to count - 1, all alike.
  std::size_t Index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  // In (0, 1], from the 53 highest bits.
  double Uniform() { return (static_cast<double>(engine_() >> 11) + 1.0) * 0x1p-53; }

  std::mt19937_64 engine_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace clothfit
