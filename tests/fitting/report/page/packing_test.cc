// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers on their way into a page and back.
#include "fitting/report/page/packing.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/report_blocks.h"

namespace clothfit {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  const std::string bytes("\x00\xff\xfb\x80\n", 5);
  EXPECT_EQ(FromBase64(Base64(bytes)), bytes);
}

TEST(Quantise, IsOffByHalfAStepAtMost) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-3.0, 5.0);
  std::vector<double> values;
  for (int i = 0; i < 3000; ++i) values.push_back(uniform(random) * (i % 3 == 2 ? 1e-3 : 1.0));
  const Quantised quantised = Quantise(values, 3);
  ASSERT_EQ(quantised.values.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double range = quantised.upper[i % 3] - quantised.lower[i % 3];
    // a little above half a step, for rounding
    EXPECT_LE(std::abs(Unquantise(quantised, i) - values[i]), range / 131068.0 * (1.0 + 1e-9));
  }
}

TEST(Quantise, KeepsTheEndsAndWhatIsNotKnown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Quantised quantised = Quantise({2.0, nan, -1.0, INFINITY}, 1);
  EXPECT_EQ(Unquantise(quantised, 0), 2.0);
  EXPECT_TRUE(std::isnan(Unquantise(quantised, 1)));
  EXPECT_EQ(Unquantise(quantised, 2), -1.0);
  EXPECT_TRUE(std::isnan(Unquantise(quantised, 3)));
  const Quantised same = Quantise({0.5, 0.5}, 1);
  EXPECT_EQ(Unquantise(same, 1), 0.5);
  const Quantised unknown = Quantise({nan, nan}, 2);
  EXPECT_EQ(unknown.lower, (std::vector<double>{0.0, 0.0}));
  EXPECT_TRUE(Quantise({}, 3).values.empty());
}

TEST(PackRows, RoundTrips) {
  const std::vector<std::uint16_t> small = {0, 65535, 7, 1, 0, 65534, 3, 2, 1};
  const auto unpacked = UnpackRows(PackRows(small, 3), small.size(), 3, 2);
  EXPECT_EQ(std::vector<std::uint16_t>(unpacked.begin(), unpacked.end()), small);
  const std::vector<std::int32_t> large = {-1, 2147483647, -2147483647, 5, 0, 70000};
  const auto again = UnpackRows(PackRows(large, 2), large.size(), 2, 4);
  EXPECT_EQ(std::vector<std::int32_t>(again.begin(), again.end()), large);
  EXPECT_TRUE(UnpackRows(PackRows(std::vector<std::uint16_t>(), 3), 0, 3, 2).empty());
}

TEST(PackRows, MakesSmoothMotionSmall) {
  std::vector<std::uint16_t> values;
  for (int frame = 0; frame < 100; ++frame) {
    for (int i = 0; i < 300; ++i) {
      values.push_back(static_cast<std::uint16_t>(30000.0 + 20000.0 * std::sin(0.03 * frame + i)));
    }
  }
  EXPECT_LT(PackRows(values, 300).size(), 1.3 * static_cast<double>(values.size()));
}

}  // namespace
}  // namespace clothfit
