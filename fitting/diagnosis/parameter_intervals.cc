// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/parameter_intervals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fitting/diagnosis/null_residuals.h"
#include "fitting/diagnosis/residual_correlation.h"

namespace clothfit {
namespace {

constexpr double k90 = 1.645, k95 = 1.96;  // sigmas
constexpr int kDraws = 3;
// 95 % of Student's t by degrees of freedom, from 1 on.
constexpr std::array<double, kDraws> kStudent = {6.314, 2.920, 2.353};

}  // namespace

void SetInterval(double value, double sigma, EffectParameter* parameter) {
  parameter->value = value;
  parameter->lower90 = value - k90 * sigma;
  parameter->upper90 = value + k90 * sigma;
}

std::vector<EffectParameter> EstimatesOf(const FittedScene& fitted,
                                         const std::vector<std::string>& names) {
  std::vector<EffectParameter> parameters;
  if (names.empty()) return parameters;
  // The fit takes residuals for independent.
  const double wider = k90 / k95 * std::sqrt(ResidualCorrelationTime(fitted));
  for (const ParameterEstimate& estimate : fitted.fit.estimates) {
    if (std::find(names.begin(), names.end(), estimate.name) == names.end()) continue;
    const ParameterSetting& bounds = fitted.config.parameters.at(estimate.name);
    parameters.push_back(
        {estimate.name, estimate.unit, estimate.value,
         std::max(bounds.lower, estimate.value + wider * (estimate.lower95 - estimate.value)),
         std::min(bounds.upper, estimate.value + wider * (estimate.upper95 - estimate.value))});
  }
  return parameters;
}

NumericalShifts MeasureNumericalShifts(const FittedScene& fitted, std::uint64_t seed) {
  NumericalShifts shifts;
  const std::optional<LinearisedFit> linear = Linearise(fitted);
  if (!linear) return shifts;
  shifts.entries = linear->rows.entries;
  shifts.rms = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(shifts.entries.size()));
  const std::vector<NumericalShift> draws = MeasureShifts(fitted, *linear, kDraws, seed);
  shifts.left_squared = linear->frames.num_rows();
  for (const NumericalShift& draw : draws) {
    shifts.rms += draw.by.cwiseAbs2() / static_cast<double>(draws.size());
    shifts.left_squared += draw.left_squared / static_cast<double>(draws.size());
  }
  shifts.rms = shifts.rms.cwiseSqrt();
  shifts.draws = static_cast<int>(draws.size());
  return shifts;
}

void Widen(const NumericalShifts& shifts, const FitConfig& config,
           std::vector<EffectParameter>* parameters) {
  if (shifts.draws == 0) return;
  const int most = static_cast<int>(kStudent.size());
  const double quantile = kStudent[static_cast<std::size_t>(std::min(shifts.draws, most) - 1)];
  for (EffectParameter& p : *parameters) {
    const auto entry =
        std::find_if(shifts.entries.begin(), shifts.entries.end(), [&](const FreeEntry& e) {
          return e.kind == FreeEntry::Kind::kParameter && e.name == p.name;
        });
    if (entry == shifts.entries.end()) continue;
    const double half = quantile * shifts.rms[entry - shifts.entries.begin()];
    const ParameterSetting& bounds = config.parameters.at(p.name);
    const bool is_log = entry->is_log && p.lower90 > 0.0;
    const auto moved = [&](double end, double sign) {
      if (is_log) return p.value * std::exp(sign * std::hypot(std::log(end / p.value), half));
      return p.value + sign * std::hypot(end - p.value, half);
    };
    const double lower = moved(p.lower90, -1.0), upper = moved(p.upper90, 1.0);
    p.lower90 = std::max(bounds.lower, lower);
    p.upper90 = std::min(bounds.upper, upper);
  }
}

}  // namespace clothfit
