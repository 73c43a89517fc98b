// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/normal_numbers.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(NormalNumbers, HaveTheMomentsOfTheNormalDistribution) {
  NormalNumbers numbers(7, 0);
  constexpr int kCount = 40000;
  double sum = 0.0, square = 0.0, fourth = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double x = numbers.Next();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  // Five standard errors: sqrt(1 / n), sqrt(2 / n) and sqrt(96 / n).
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 * std::sqrt(1.0 / kCount));
  EXPECT_NEAR(square / kCount, 1.0, 5.0 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(fourth / kCount, 3.0, 5.0 * std::sqrt(96.0 / kCount));
}

// The engine is specified to the bit, and so are these.
TEST(NormalNumbers, AreTheSameWithEveryStandardLibrary) {
  NormalNumbers numbers(7, 0);
  EXPECT_NEAR(numbers.Next(), 0.30789024590108227, 1e-14);
  EXPECT_NEAR(numbers.Next(), -2.510501088389311, 1e-14);
  EXPECT_EQ(numbers.Index(1000), 817U);
  const Eigen::Vector3d vector = numbers.NextVector<3>();
  NormalNumbers again(7, 0);
  for (int i = 0; i < 2; ++i) again.Next();
  again.Index(1000);
  for (const double x : vector) EXPECT_EQ(again.Next(), x);
}

TEST(NormalNumbers, IndicesReachEachOfSoMany) {
  NormalNumbers numbers(7, 0);
  std::array<int, 5> times = {};
  for (int i = 0; i < 500; ++i) ++times.at(numbers.Index(5));
  // Five standard errors: sqrt(500 * 0.2 * 0.8).
  for (const int count : times) EXPECT_NEAR(count, 100, 45);
}

TEST(NormalNumbers, StreamsOfOneSeedDiffer) {
  EXPECT_NE(NormalNumbers(1, 0).Next(), NormalNumbers(1, 1).Next());
  EXPECT_NE(NormalNumbers(1, 0).Next(), NormalNumbers(2, 0).Next());
}

}  // namespace
}  // namespace clothfit
