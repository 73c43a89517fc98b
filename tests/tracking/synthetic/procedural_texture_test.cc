// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/procedural_texture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;
using testing::HasSubstr;

PlaneTexture Ramp(PlaneTexture::Beyond beyond) {
  return {Vector2d(1.0, 0.5), 0.01, beyond, [](const Vector2d& place) {
            return Vector3f(static_cast<float>(place.x()), static_cast<float>(place.y()), 1.0F);
          }};
}

TEST(PlaneTexture, GivesALinearPictureBack) {
  const PlaneTexture ramp = Ramp(PlaneTexture::Beyond::kBorder);
  for (const double footprint : {0.001, 0.01, 0.02, 0.03}) {
    const Vector3f colour = ramp.At({0.437, 0.211}, footprint);
    // A coarse texel takes parts of fine ones, each of one colour: a hundredth of a texel's step.
    EXPECT_NEAR(colour[0], 0.437, 1e-4) << footprint;
    EXPECT_NEAR(colour[1], 0.211, 1e-4) << footprint;
    EXPECT_EQ(colour[2], 1.0F);
  }
}

TEST(PlaneTexture, RepeatsOrGoesOn) {
  const PlaneTexture repeats = Ramp(PlaneTexture::Beyond::kRepeat);
  EXPECT_LT((repeats.At({0.3, 0.2}, 0.0) - repeats.At({-3.7, 2.7}, 0.0)).norm(), 1e-5);
  const PlaneTexture ends = Ramp(PlaneTexture::Beyond::kBorder);
  EXPECT_NEAR(ends.At({2.0, 0.2}, 0.0)[0], 0.995, 1e-5);  // the last texel's middle
}

TEST(PlaneTexture, FromFarAwayIsItsMean) {
  const Vector3f colour = Ramp(PlaneTexture::Beyond::kRepeat).At({0.1, 0.1}, 10.0);
  EXPECT_NEAR(colour[0], 0.5, 1e-4);  // single precision, added up
  EXPECT_NEAR(colour[1], 0.25, 1e-4);
}

double StandardDeviation(const PlaneTexture& texture, double footprint) {
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (double v = 0.01; v < 0.6; v += 0.0073) {
    for (double u = 0.01; u < 0.6; u += 0.0071, ++count) {
      const double green = static_cast<double>(texture.At({u, v}, footprint)[1]);
      sum += green;
      squares += green * green;
    }
  }
  return std::sqrt(squares / count - std::pow(sum / count, 2));
}

TEST(ClothTexture, RichHasContrastAtEveryScale) {
  const PlaneTexture rich = MakeClothTexture(ClothPattern::kRich, {0.6, 0.6}, 1);
  double before = 1.0;
  for (const double scale : {0.005, 0.02, 0.08}) {
    const double contrast = StandardDeviation(rich, scale);
    EXPECT_GT(contrast, 0.05) << scale;
    EXPECT_LT(contrast, 0.97 * before) << scale;  // each octave adds some of its own
    before = contrast;
  }
  const PlaneTexture other = MakeClothTexture(ClothPattern::kRich, {0.6, 0.6}, 2);
  EXPECT_NE(rich.At({0.3, 0.3}, 0.01), other.At({0.3, 0.3}, 0.01));
}

TEST(ClothTexture, RepetitiveRepeatsAndPlainIsPlain) {
  const PlaneTexture print = MakeClothTexture(ClothPattern::kRepetitive, {0.6, 0.6}, 1);
  EXPECT_GT(StandardDeviation(print, 0.003), 0.1);
  for (double u = 0.0; u < kPatternPeriod; u += 0.0013) {
    const Vector2d place(u, 0.6 * u + 0.01);
    const Vector2d next = place + kPatternPeriod * Vector2d(3.0, 5.0);
    EXPECT_LT((print.At(place, 0.002) - print.At(next, 0.002)).norm(), 1e-4);
  }
  EXPECT_NEAR(StandardDeviation(MakeClothTexture(ClothPattern::kPlain, {0.6, 0.6}, 1), 0.003), 0.0,
              1e-3);  // the root of what rounding leaves
}

TEST(ClothTexture, SuggestsTheNearestName) {
  for (const std::string& name : ClothPatternNames())
    EXPECT_EQ(ToString(ParseClothPattern("texture", name)), name);
  EXPECT_THAT(InputErrorOf([] { ParseClothPattern("texture", "ritch"); }),
              HasSubstr("did you mean 'rich'?"));
}

}  // namespace
}  // namespace clothfit
