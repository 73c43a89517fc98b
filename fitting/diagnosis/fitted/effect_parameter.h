// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// An amount of an effect, and how certain it is.
#pragma once

#include <string>

namespace clothfit {

inline constexpr double k90 = 1.645;  // sigmas to either end of a 90 % interval

struct EffectParameter {
  std::string name, unit;  // "wind.x", "m/s"
  double value = 0.0;
  double lower90 = 0.0, upper90 = 0.0;
};

// Sets value and 90 % interval of a normal estimate.
void SetInterval(double value, double sigma, EffectParameter* parameter);

}  // namespace clothfit
