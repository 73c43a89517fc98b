// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/parameter_intervals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fitting/diagnosis/evidence/rao_score.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/diagnosis/fitted/residual_correlation.h"
#include "fitting/diagnosis/gate/null_residuals.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

constexpr double k95 = 1.96;  // sigmas
constexpr double kOneSided90 = 1.2816;
constexpr int kIntervalDraws = 3;
// 95 % of Student's t by degrees of freedom, from 1 on.
constexpr std::array<double, kIntervalDraws> kStudent = {6.314, 2.920, 2.353};

double StudentOf(Eigen::Index draws) {
  const auto most = static_cast<Eigen::Index>(kStudent.size());
  return kStudent[static_cast<std::size_t>(std::min(draws, most) - 1)];
}

std::vector<FreeEntry>::const_iterator EntryOf(const DiscretisationShifts& shifts,
                                               const std::string& name) {
  return std::find_if(shifts.entries.begin(), shifts.entries.end(), [&](const FreeEntry& e) {
    return e.kind == FreeEntry::Kind::kParameter && e.name == name;
  });
}

}  // namespace

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

DiscretisationShifts MeasureDiscretisationShifts(const FittedScene& fitted, std::uint64_t seed) {
  DiscretisationShifts shifts;
  const std::optional<LinearisedFit> linear = Linearise(fitted);
  if (!linear) return shifts;
  Eigen::MatrixXd information = linear->rows.jacobian.transpose() * linear->rows.jacobian;
  AddPriors(linear->rows.entries, &information);
  const auto root = TrySemidefinite(information);
  if (!root) return shifts;
  shifts.entries = linear->rows.entries;
  const auto num_entries = static_cast<Eigen::Index>(shifts.entries.size());
  const std::vector<DiscretisationShift> draws =
      MeasureShifts(fitted, *linear, kIntervalDraws, seed);
  shifts.by.resize(num_entries, static_cast<Eigen::Index>(draws.size()));
  shifts.left_squared = linear->frames.num_rows();
  for (std::size_t k = 0; k < draws.size(); ++k) {
    shifts.by.col(static_cast<Eigen::Index>(k)) = draws[k].by;
    shifts.left_squared += draws[k].left_squared / static_cast<double>(draws.size());
  }
  const double factor = std::max(1.0, fitted.fit.noise_factor);
  shifts.noise = factor * factor * ResidualCorrelationTime(fitted) *
                 root->solve(Eigen::MatrixXd::Identity(num_entries, num_entries));
  return shifts;
}

bool MayBeNothing(const DiscretisationShifts& shifts, const FitConfig& values,
                  const std::vector<EffectParameter>& amounts) {
  if (shifts.by.cols() == 0 || amounts.empty()) return false;
  std::vector<int> which;
  std::vector<double> from_off;
  for (const EffectParameter& p : amounts) {
    const double off = ParameterNamed(p.name).off;
    const auto entry = EntryOf(shifts, p.name);
    const bool may_be_off = p.lower90 <= off && p.upper90 >= off;
    if (!may_be_off || entry == shifts.entries.end()) return false;
    which.push_back(static_cast<int>(entry - shifts.entries.begin()));
    const double value = values.parameters.at(p.name).value;
    from_off.push_back(entry->is_log ? std::log(value / off) : value - off);
  }
  if (amounts.size() == 1) return true;
  const Eigen::MatrixXd by = shifts.by(which, Eigen::all);
  const double wider = StudentOf(by.cols()) / k90;
  const Eigen::MatrixXd covariance =
      shifts.noise(which, which) +
      wider * wider / static_cast<double>(by.cols()) * (by * by.transpose());
  const Eigen::Map<const Eigen::VectorXd> away(from_off.data(),
                                               static_cast<Eigen::Index>(from_off.size()));
  const auto factor = TrySemidefinite(covariance);
  return !factor || NormalDeviate(away.dot(factor->solve(away)),
                                  static_cast<double>(which.size())) <= kOneSided90;
}

void Widen(const DiscretisationShifts& shifts, const FitConfig& config,
           std::vector<EffectParameter>* parameters) {
  if (shifts.by.cols() == 0) return;
  const double draws = static_cast<double>(shifts.by.cols());
  const Eigen::VectorXd rms = shifts.by.rowwise().norm() / std::sqrt(draws);
  const double quantile = StudentOf(shifts.by.cols());
  for (EffectParameter& p : *parameters) {
    const auto entry = EntryOf(shifts, p.name);
    if (entry == shifts.entries.end()) continue;
    const double half = quantile * rms[entry - shifts.entries.begin()];
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
