// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/effect_words.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TEST(EffectWords, SayWhatATermIs) {
  EXPECT_EQ(PlainName("wind"), "air that moves evenly, felt through the air drag (wind)");
  EXPECT_EQ(PlainName("camera cam0: clock"), "camera cam0: clock");
  EXPECT_EQ(PlainNames({"camera cam0: clock", "hem"}),
            "camera cam0: clock; mass along the sides of the cloth (hem)");
}

TEST(EffectWords, TellAVectorByItsSizeAndDirection) {
  EXPECT_EQ(AmountsInWords({"wind"}, {{"wind.x", "m/s", 0.3, 0.2, 0.4},
                                      {"wind.y", "m/s", 0.4, 0.3, 0.5},
                                      {"wind.z", "m/s", 0.0, -0.1, 0.1}}),
            "wind: 0.5 m/s (0.4 to 0.6) along (0.6, 0.8, 0).");
  EXPECT_EQ(AmountsInWords({"wind"}, {{"wind.x", "m/s", 0.0, kUnknown, kUnknown},
                                      {"wind.y", "m/s", 0.0, kUnknown, kUnknown},
                                      {"wind.z", "m/s", 0.0, kUnknown, kUnknown}}),
            "wind: 0 m/s.");
}

TEST(EffectWords, TellATiltInDegrees) {
  const double degree = M_PI / 180.0;
  EXPECT_EQ(
      AmountsInWords({"gravity_tilt"},
                     {{"gravity_tilt.angle_1", "rad", 3.0 * degree, 2.0 * degree, 4.0 * degree},
                      {"gravity_tilt.angle_2", "rad", 4.0 * degree, 3.0 * degree, 5.0 * degree}}),
      "gravity_tilt: 5 degrees (4 to 6).");
}

TEST(EffectWords, LeaveOutWhatIsNothingBesideTheLargest) {
  EXPECT_EQ(AmountsInWords({"hem"}, {{"hem.low_u", "kg/m", 0.0004, 0.0, 0.0008},
                                     {"hem.low_v", "kg/m", 0.05, 0.04, 0.06}}),
            "hem: 0.05 kg/m (0.04 to 0.06) along the side of least v.");
}

TEST(EffectWords, TellAPlaceInTheWorldByItsThreeNumbers) {
  EXPECT_EQ(
      AmountsInWords({"obstacle_sphere"}, {{"obstacle_sphere.stiffness", "Pa/m", 5e4, 4e4, 6e4},
                                           {"obstacle_sphere.x", "m", -0.519, -0.529, -0.509},
                                           {"obstacle_sphere.y", "m", 0.1, 0.05, 0.15},
                                           {"obstacle_sphere.z", "m", 0.7034, 0.6834, 0.7234},
                                           {"obstacle_sphere.radius", "m", 0.022, 0.02, 0.024}}),
      "obstacle_sphere: 5e+04 Pa/m (4e+04 to 6e+04) pressure per depth, its middle at (-0.519, "
      "0.100, 0.703) m within (0.01, 0.05, 0.02) m, radius 0.022 m (0.02 to 0.024).");
}

TEST(EffectWords, TellPlacesAfterAmountsAndFaultsAsTheyAre) {
  EXPECT_EQ(AmountsInWords({"camera cam0: clock", "bending_friction"},
                           {{"camera cam0: clock", "s", 0.02, 0.01, 0.03},
                            {"bending_friction.moment", "N", 0.002, 0.001, 0.003},
                            {"bending_friction.onset", "1/m", 10.0, 5.0, 20.0}}),
            "camera cam0: clock 0.02 s (0.01 to 0.03). bending_friction: 0.002 N (0.001 to 0.003) "
            "largest moment per width, onset 10 1/m (5 to 20).");
}

}  // namespace
}  // namespace clothfit
