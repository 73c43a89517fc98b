// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/parameter_intervals.h"

#include <algorithm>
#include <limits>

namespace clothfit {

std::vector<EffectParameter> EstimatesOf(const FitResult& fit, const FitConfig& config,
                                         const std::vector<std::string>& names) {
  constexpr double k95 = 1.96;  // sigmas
  const double narrower = k90 / k95;
  std::vector<EffectParameter> parameters;
  for (const ParameterEstimate& estimate : fit.estimates) {
    if (std::find(names.begin(), names.end(), estimate.name) == names.end()) continue;
    const ParameterSetting& bounds = config.parameters.at(estimate.name);
    const auto end = [&](double of95) {
      if (!estimate.free) return std::numeric_limits<double>::quiet_NaN();
      return std::clamp(estimate.value + narrower * (of95 - estimate.value), bounds.lower,
                        bounds.upper);
    };
    parameters.push_back({estimate.name, estimate.unit, estimate.value, end(estimate.lower95),
                          end(estimate.upper95)});
  }
  return parameters;
}

void ForgetIntervals(std::vector<EffectParameter>* parameters) {
  for (EffectParameter& p : *parameters)
    p.lower90 = p.upper90 = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace clothfit
