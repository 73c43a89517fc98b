// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/correlation_time.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// Autoregressive series of the first order, 40 of 2000 samples.
std::vector<std::vector<double>> Series(double memory) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> series(40);
  for (std::vector<double>& values : series) {
    double value = normal(random) / std::sqrt(1.0 - memory * memory);
    for (int i = 0; i < 2000; ++i) {
      values.push_back(value);
      value = memory * value + normal(random);
    }
  }
  return series;
}

TEST(CorrelationTime, IsOneOfNoise) { EXPECT_NEAR(CorrelationTime(Series(0.0)), 1.0, 0.01); }

TEST(CorrelationTime, IsThatOfAnAutoregressiveSeries) {
  for (const double memory : {0.3, 0.6, 0.8}) {
    double expected = 1.0;  // (1 + memory) / (1 - memory) without the tail that is left out
    for (double rest = memory; rest >= 0.05; rest *= memory) expected += 2.0 * rest;
    EXPECT_NEAR(CorrelationTime(Series(memory)), expected, 0.1 * expected) << memory;
  }
}

TEST(CorrelationTime, ASwingToAndFroCountsAsNoLessThanOne) {
  EXPECT_EQ(CorrelationTime({{1.0, -1.0, 1.0, -1.0, 1.0, -1.0}}), 1.0);
  EXPECT_EQ(CorrelationTime({}), 1.0);
  EXPECT_EQ(CorrelationTime({{0.0, 0.0, 0.0}}), 1.0);
}

}  // namespace
}  // namespace clothfit
