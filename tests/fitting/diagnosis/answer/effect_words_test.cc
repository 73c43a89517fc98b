// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/effect_words.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/answer/amount_words.h"

namespace clothfit {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TEST(EffectWords, SayWhatATermIs) {
  EXPECT_EQ(PlainName("wind"), "air that moves evenly, felt through the air drag (wind)");
  EXPECT_EQ(PlainName("camera cam0: clock"), "clock of camera cam0");
  EXPECT_EQ(PlainNames({"camera cam0: clock", "hem"}),
            "clock of camera cam0; mass along the sides of the cloth (hem)");
}

TEST(EffectWords, HaveATitleForSentences) {
  EXPECT_EQ(TitleOf("wind"), "wind");
  EXPECT_EQ(TitleOf("bending_friction"), "bending friction");
  EXPECT_EQ(TitleOf("obstacle_sphere"), "unseen ball");
  EXPECT_EQ(TitleOf("bending.damping"), "bending damping");
  EXPECT_EQ(TitleOf("markers: place"), "place of the markers");
  EXPECT_EQ(TitleOf("markers 3 and 4 swapped from frame 10 on"),
            "markers 3 and 4 swapped from frame 10 on");
  int checked = 0;
  for (const TermInfo& term : AllTerms()) {
    EXPECT_EQ(TitleOf(term.name).find_first_of("_.:"), std::string::npos) << term.name;
    ++checked;
  }
  EXPECT_GT(checked, 30);
}

TEST(EffectWords, TellInBriefHowMuchOrWhere) {
  const std::vector<EffectParameter> all = {{"wind.x", "m/s", 0.04, 0.03, 0.05},
                                            {"wind.y", "m/s", 0.55, 0.54, 0.56},
                                            {"wind.z", "m/s", 0.03, 0.02, 0.04},
                                            {"heavy_patch.share", "1", 0.3, 0.2, 0.4},
                                            {"heavy_patch.u", "m", 0.1, 0.05, 0.15},
                                            {"obstacle_sphere.stiffness", "Pa/m", 5e4, 4e4, 6e4},
                                            {"obstacle_sphere.x", "m", -0.519, -0.529, -0.509},
                                            {"obstacle_sphere.y", "m", 0.1, 0.05, 0.15},
                                            {"obstacle_sphere.z", "m", 0.7034, 0.6834, 0.7234}};
  EXPECT_EQ(InBrief("wind", all), "wind of 0.552 m/s (0.542 to 0.562) along +y");
  EXPECT_EQ(InBrief("heavy_patch", all),
            "heavy patch of 0.3 (0.2 to 0.4) mass at its middle beside the cloth's own, over that");
  EXPECT_EQ(InBrief("obstacle_sphere", all), "unseen ball, its middle at (-0.52, 0.10, 0.70) m");
  EXPECT_EQ(InBrief("hem", all), "hem");  // nothing is known of it
  EXPECT_EQ(InBrief("bending.damping", {{"bending.damping", "N m s", 0.001, 0.0005, 0.002}}),
            "bending damping of 0.001 N m s (0.0005 to 0.002)");
}

TEST(EffectWords, TellInBriefHowFarAFaultIs) {
  EXPECT_EQ(InBrief("camera cam0: clock", {{"camera cam0: clock", "s", -0.02, -0.03, -0.01}}),
            "clock of camera cam0 off by 0.02 s (0.01 to 0.03)");
  EXPECT_EQ(InBrief("camera cam1: pose",
                    {{"camera cam1: pose shift x", "m", 0.03, kUnknown, kUnknown},
                     {"camera cam1: pose shift y", "m", 0.04, kUnknown, kUnknown},
                     {"camera cam1: pose turn z", "rad", M_PI / 180.0, kUnknown, kUnknown}}),
            "pose of camera cam1 off by 0.05 m and 1 degrees");
}

// Whatever is not known, no direction is (0, 0, 0).
TEST(EffectWords, TellNoDirectionOfNothing) {
  const std::vector<EffectParameter> nothing = {{"wind.x", "m/s", 0.0, -0.1, 0.1},
                                                {"wind.y", "m/s", 0.0, -0.1, 0.1},
                                                {"wind.z", "m/s", 0.0, -0.1, 0.1}};
  for (const std::string& words : {AmountsInWords({"wind"}, nothing), InBrief("wind", nothing)})
    EXPECT_EQ(words.find("along"), std::string::npos) << words;
}

TEST(EffectWords, TellAVectorByItsSizeAndDirection) {
  EXPECT_EQ(AmountsInWords({"wind"}, {{"wind.x", "m/s", 0.3, 0.2, 0.4},
                                      {"wind.y", "m/s", 0.4, 0.3, 0.5},
                                      {"wind.z", "m/s", 0.0, -0.1, 0.1}}),
            "Wind: 0.5 m/s (0.4 to 0.6) along (0.60, 0.80, 0.00).");
  EXPECT_EQ(AmountsInWords({"wind"}, {{"wind.x", "m/s", 0.0, kUnknown, kUnknown},
                                      {"wind.y", "m/s", 0.0, kUnknown, kUnknown},
                                      {"wind.z", "m/s", 0.0, kUnknown, kUnknown}}),
            "Wind: 0 m/s.");
}

TEST(EffectWords, TellATiltInDegrees) {
  const double degree = M_PI / 180.0;
  EXPECT_EQ(
      AmountsInWords({"gravity_tilt"},
                     {{"gravity_tilt.angle_1", "rad", 3.0 * degree, 2.0 * degree, 4.0 * degree},
                      {"gravity_tilt.angle_2", "rad", 4.0 * degree, 3.0 * degree, 5.0 * degree}}),
      "Gravity tilt: 5 degrees (4 to 6).");
}

TEST(EffectWords, LeaveOutWhatIsNothingBesideTheLargest) {
  EXPECT_EQ(AmountsInWords({"hem"}, {{"hem.low_u", "kg/m", 0.0004, 0.0, 0.0008},
                                     {"hem.low_v", "kg/m", 0.05, 0.04, 0.06}}),
            "Hem: 0.05 kg/m (0.04 to 0.06) along the side of least v.");
}

TEST(EffectWords, TellAPlaceInTheWorldByItsThreeNumbers) {
  EXPECT_EQ(
      AmountsInWords({"obstacle_sphere"}, {{"obstacle_sphere.stiffness", "Pa/m", 5e4, 4e4, 6e4},
                                           {"obstacle_sphere.x", "m", -0.519, -0.529, -0.509},
                                           {"obstacle_sphere.y", "m", 0.1, 0.05, 0.15},
                                           {"obstacle_sphere.z", "m", 0.7034, 0.6834, 0.7234},
                                           {"obstacle_sphere.radius", "m", 0.022, 0.02, 0.024}}),
      "Unseen ball: 5e+04 Pa/m (4e+04 to 6e+04) pressure per depth, its middle at (-0.519, "
      "0.100, 0.703) m within (0.01, 0.05, 0.02) m, radius 0.022 m (0.02 to 0.024).");
}

TEST(EffectWords, TellWhichWayAPlaceMayBeAnywhere) {
  const std::string words =
      AmountsInWords({"obstacle_capsule"}, {{"obstacle_capsule.stiffness", "Pa/m", 5e4, 4e4, 6e4},
                                            {"obstacle_capsule.x1", "m", -0.519, -0.529, -0.509},
                                            {"obstacle_capsule.y1", "m", 0.1, kUnknown, kUnknown},
                                            {"obstacle_capsule.z1", "m", 0.703, 0.683, 0.723}});
  EXPECT_NE(
      words.find("one end of its axis at (-0.519, 0.100, 0.703) m within (0.01, any, 0.02) m"),
      std::string::npos)
      << words;
}

TEST(EffectWords, TellThePlaneThatIsTiltedByOneAngle) {
  const double degree = M_PI / 180.0;
  EXPECT_EQ(
      AmountsInWords({"obstacle_plane"},
                     {{"obstacle_plane.stiffness", "Pa/m", 5e4, 4e4, 6e4},
                      {"obstacle_plane.height", "m", 0.2, 0.1, 0.3},
                      {"obstacle_plane.angle_1", "rad", 3.0 * degree, kUnknown, kUnknown},
                      {"obstacle_plane.angle_2", "rad", 4.0 * degree, kUnknown, kUnknown}}),
      "Unseen plane: 5e+04 Pa/m (4e+04 to 6e+04) pressure per depth, height 0.2 m (0.1 to 0.3), "
      "turned by 5 degrees.");
}

TEST(EffectWords, RepeatNothingThatWasTold) {
  const std::vector<EffectParameter> hem = {{"hem.low_v", "kg/m", 0.05, 0.04, 0.06}};
  EXPECT_EQ(AmountsInWords({"hem"}, hem,
                           "Hem of 0.05 kg/m (0.04 to 0.06) along the side of "
                           "least v."),
            "");
  EXPECT_NE(AmountsInWords({"hem"}, hem, "Hem of 10.05 kg/m."), "");
  const std::vector<EffectParameter> pose = {{"camera cam1: pose shift x", "m", 0.03, 0.02, 0.04}};
  EXPECT_EQ(AmountsInWords({"camera cam1: pose"}, pose,
                           "Pose of camera cam1 off by " + Alone(pose.front()) + "."),
            "Pose of camera cam1: shift x 0.03 m (0.02 to 0.04).");
}

TEST(EffectWords, TellPlacesAfterAmountsAndFaultsAsTheyAre) {
  EXPECT_EQ(
      AmountsInWords({"camera cam0: clock", "bending_friction"},
                     {{"camera cam0: clock", "s", 0.02, 0.01, 0.03},
                      {"bending_friction.moment", "N", 0.002, 0.001, 0.003},
                      {"bending_friction.onset", "1/m", 10.0, 5.0, 20.0}}),
      "Clock of camera cam0: 0.02 s (0.01 to 0.03). Bending friction: 0.002 N (0.001 to 0.003) "
      "largest moment per width, onset 10 1/m (5 to 20).");
}

}  // namespace
}  // namespace clothfit
