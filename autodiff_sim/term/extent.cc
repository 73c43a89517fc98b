// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/term/extent.h"

#include <algorithm>
#include <cmath>

namespace clothfit {

double AtShare(const Parameter& parameter, double share, const Extent& extent) {
  const auto place = [&](int k) {
    return extent.low[k] + share * (extent.high[k] - extent.low[k]);
  };
  switch (parameter.meaning) {
    case Meaning::kPlaceX:
      return place(0);
    case Meaning::kPlaceY:
      return place(1);
    case Meaning::kPlaceZ:
    case Meaning::kAlongTilt:
      return place(2);
    case Meaning::kClothU:
      return share * extent.size.x();
    case Meaning::kClothV:
      return share * extent.size.y();
    case Meaning::kClothDistance:
      return share * extent.size.maxCoeff();
    case Meaning::kTime:
      return share * extent.duration;
    default:
      return share;
  }
}

double AwayFromOff(const Parameter& parameter, double sigmas) {
  const auto moved = [&](double by) {
    const bool is_log = parameter.scale == Scale::kLog;
    // From 0 there is no way by factors.
    const double from = is_log && parameter.off <= 0.0
                            ? std::sqrt(parameter.lower * parameter.upper)
                            : parameter.off;
    const double value =
        is_log ? from * std::pow(parameter.prior_factor, by) : from + by * parameter.prior_factor;
    return std::clamp(value, parameter.lower, parameter.upper);
  };
  const double more = moved(sigmas);
  return more > parameter.off ? more : moved(-sigmas);
}

std::map<std::string, double> MiddleShape(const TermInfo& term, const Extent& extent) {
  std::map<std::string, double> shape;
  for (const Parameter& p : term.parameters) {
    if (SwitchesOff(p)) continue;
    const double middle = p.probes.values[static_cast<std::size_t>(p.probes.count / 2)];
    const double value = p.meaning == Meaning::kTilt ? 0.0 : AtShare(p, middle, extent);
    shape[p.name] = std::clamp(value, p.lower, p.upper);
  }
  return shape;
}

}  // namespace clothfit
