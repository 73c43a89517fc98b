// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/parameter_intervals.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

constexpr double k90 = 2.353;  // Student's t of 3

FreeEntry Entry(const char* name, bool is_log = false) {
  FreeEntry entry{};
  entry.kind = FreeEntry::Kind::kParameter;
  entry.name = name;
  entry.is_log = is_log;
  return entry;
}

// In each of so many simulations.
DiscretisationShifts ShiftOf(const char* name, bool is_log, double by, int draws = 3) {
  return {
      {Entry(name, is_log)}, Eigen::MatrixXd::Constant(1, draws, by), Eigen::MatrixXd::Zero(1, 1)};
}

FitConfig Bounded(const char* name, double lower, double upper) {
  FitConfig config;
  config.parameters[name].lower = lower;
  config.parameters[name].upper = upper;
  return config;
}

TEST(ParameterIntervals, AreWidenedInSquares) {
  std::vector<EffectParameter> parameters = {{"wind.x", "m/s", 1.0, 0.7, 1.3}};
  Widen(ShiftOf("wind.x", false, 0.4 / k90), Bounded("wind.x", -10.0, 10.0), &parameters);
  EXPECT_NEAR(parameters[0].lower90, 0.5, 1e-12);
  EXPECT_NEAR(parameters[0].upper90, 1.5, 1e-12);
  EXPECT_EQ(parameters[0].value, 1.0);
}

TEST(ParameterIntervals, AreWidenedByFactorsWhereTheFitMovesLogarithms) {
  std::vector<EffectParameter> parameters = {{"crease.width", "m", 0.02, 0.02, 0.02}};
  Widen(ShiftOf("crease.width", true, std::log(2.0) / k90), Bounded("crease.width", 0.0, 1.0),
        &parameters);
  EXPECT_NEAR(parameters[0].lower90, 0.01, 1e-12);
  EXPECT_NEAR(parameters[0].upper90, 0.04, 1e-12);
}

TEST(ParameterIntervals, EndAtTheBounds) {
  std::vector<EffectParameter> parameters = {{"hem.low_u", "kg/m", 0.01, 0.005, 0.015}};
  Widen(ShiftOf("hem.low_u", false, 1.0), Bounded("hem.low_u", 0.0, 0.1), &parameters);
  EXPECT_EQ(parameters[0].lower90, 0.0);
  EXPECT_EQ(parameters[0].upper90, 0.1);
}

TEST(ParameterIntervals, StayWhereNothingIsKnownOfAParameter) {
  std::vector<EffectParameter> parameters = {{"clock", "s", 0.01, 0.008, 0.012}};
  Widen(ShiftOf("wind.x", false, 1.0), Bounded("wind.x", -10.0, 10.0), &parameters);
  EXPECT_EQ(parameters[0].lower90, 0.008);
  EXPECT_EQ(parameters[0].upper90, 0.012);
}

TEST(ParameterIntervals, AreWiderTheFewerSimulationsAreKnown) {
  const FitConfig config = Bounded("wind.x", -100.0, 100.0);
  double last = 0.0;
  for (const int draws : {3, 2, 1}) {
    std::vector<EffectParameter> parameters = {{"wind.x", "m/s", 1.0, 1.0, 1.0}};
    Widen(ShiftOf("wind.x", false, 1.0, draws), config, &parameters);
    EXPECT_GT(parameters[0].upper90 - parameters[0].lower90, last);
    last = parameters[0].upper90 - parameters[0].lower90;
  }
  std::vector<EffectParameter> parameters = {{"wind.x", "m/s", 1.0, 0.5, 1.5}};
  Widen(ShiftOf("wind.x", false, 1.0, 0), config, &parameters);  // none came to its end
  EXPECT_EQ(parameters[0].upper90, 1.5);
}

FitConfig With(std::map<std::string, double> values) {
  FitConfig config;
  for (const auto& [name, value] : values) config.parameters[name].value = value;
  return config;
}

EffectParameter Known(const char* name, double lower, double upper) {
  return {name, "", 0.5 * (lower + upper), lower, upper};
}

TEST(MayBeNothing, OfOneAmountWhereItsIntervalHoldsWhatIsOff) {
  const DiscretisationShifts grip = ShiftOf("grip.compliance", false, 1.0);
  const FitConfig values = With({{"grip.compliance", 0.003}});
  EXPECT_TRUE(MayBeNothing(grip, values, {Known("grip.compliance", 0.0, 0.004)}));
  EXPECT_FALSE(MayBeNothing(grip, values, {Known("grip.compliance", 0.001, 0.004)}));
  const DiscretisationShifts ratio = ShiftOf("shear_orthotropy.ratio", true, 1.0);
  const FitConfig twice = With({{"shear_orthotropy.ratio", 2.0}});
  EXPECT_TRUE(MayBeNothing(ratio, twice, {Known("shear_orthotropy.ratio", 0.9, 4.0)}));
  EXPECT_FALSE(MayBeNothing(ratio, twice, {Known("shear_orthotropy.ratio", 1.1, 4.0)}));
}

TEST(MayBeNothing, OfSeveralAmountsTogether) {
  DiscretisationShifts shifts;
  shifts.entries = {Entry("wind.x"), Entry("wind.y")};
  // Both are pushed by half a metre per second, but never their difference.
  shifts.by = Eigen::MatrixXd::Constant(2, 3, 0.5);
  shifts.noise = 1e-4 * Eigen::MatrixXd::Identity(2, 2);
  const std::vector<EffectParameter> wide = {Known("wind.x", -0.9, 1.5),
                                             Known("wind.y", -0.9, 1.5)};
  EXPECT_TRUE(MayBeNothing(shifts, With({{"wind.x", 0.3}, {"wind.y", 0.3}}), wide));
  EXPECT_FALSE(MayBeNothing(shifts, With({{"wind.x", 0.3}, {"wind.y", 0.1}}), wide));
  const std::vector<EffectParameter> one_is_known = {wide[0], Known("wind.y", 0.1, 0.5)};
  EXPECT_FALSE(MayBeNothing(shifts, With({{"wind.x", 0.3}, {"wind.y", 0.3}}), one_is_known));
}

TEST(MayBeNothing, OfSeveralAmountsWithinNoise) {
  DiscretisationShifts shifts;
  shifts.entries = {Entry("wind.x"), Entry("wind.y")};
  shifts.by = Eigen::MatrixXd::Zero(2, 3);
  shifts.noise = 0.01 * Eigen::MatrixXd::Identity(2, 2);
  const std::vector<EffectParameter> wide = {Known("wind.x", -1.0, 1.0),
                                             Known("wind.y", -1.0, 1.0)};
  const double radius = 0.1 * std::sqrt(4.605);  // 90 % of chi squared of 2
  EXPECT_TRUE(MayBeNothing(shifts, With({{"wind.x", 0.99 * radius}, {"wind.y", 0.0}}), wide));
  EXPECT_FALSE(MayBeNothing(shifts, With({{"wind.x", 0.0}, {"wind.y", 1.01 * radius}}), wide));
}

TEST(MayBeNothing, NotWhereNothingIsKnown) {
  const FitConfig values = With({{"grip.compliance", 0.0}});
  const std::vector<EffectParameter> grip = {Known("grip.compliance", 0.0, 1.0)};
  EXPECT_FALSE(MayBeNothing(ShiftOf("grip.compliance", false, 1.0, 0), values, grip));
  EXPECT_FALSE(MayBeNothing(ShiftOf("wind.x", false, 1.0), values, grip));
  EXPECT_FALSE(MayBeNothing(ShiftOf("grip.compliance", false, 1.0), values, {}));
}

}  // namespace
}  // namespace clothfit
