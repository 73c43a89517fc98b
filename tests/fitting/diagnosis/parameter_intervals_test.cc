// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/parameter_intervals.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

constexpr double k90 = 2.353;  // Student's t of 3

NumericalShifts ShiftOf(const char* name, bool is_log, double rms) {
  FreeEntry entry{};
  entry.kind = FreeEntry::Kind::kParameter;
  entry.name = name;
  entry.is_log = is_log;
  return {{entry}, Eigen::VectorXd::Constant(1, rms), 3};
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
  NumericalShifts shifts = ShiftOf("wind.x", false, 1.0);
  double last = 0.0;
  for (const int draws : {3, 2, 1}) {
    shifts.draws = draws;
    std::vector<EffectParameter> parameters = {{"wind.x", "m/s", 1.0, 1.0, 1.0}};
    Widen(shifts, config, &parameters);
    EXPECT_GT(parameters[0].upper90 - parameters[0].lower90, last);
    last = parameters[0].upper90 - parameters[0].lower90;
  }
  shifts.draws = 0;  // none came to its end
  std::vector<EffectParameter> parameters = {{"wind.x", "m/s", 1.0, 0.5, 1.5}};
  Widen(shifts, config, &parameters);
  EXPECT_EQ(parameters[0].upper90, 1.5);
}

}  // namespace
}  // namespace clothfit
