// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/effect_parameter.h"

namespace clothfit {

void SetInterval(double value, double sigma, EffectParameter* parameter) {
  parameter->value = value;
  parameter->lower90 = value - k90 * sigma;
  parameter->upper90 = value + k90 * sigma;
}

}  // namespace clothfit
