// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/other_starts.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

std::vector<FitConfig> OtherStarts(const FitConfig& config) {
  constexpr double kLively = 0.1, kStiff = 20.0, kStretchy = 0.1;
  const auto scale = [](const std::string& name, double factor, FitConfig* of) {
    ParameterSetting& setting = of->parameters.at(name);
    if (setting.free)
      setting.value = std::clamp(factor * setting.value, setting.lower, setting.upper);
  };
  FitConfig lively = config;
  for (const NamedParameter& named : MakeParameterTable()) {
    const bool is_of_fabric = named.role == Role::kOrdinary && named.parameter.is_free;
    if (is_of_fabric && std::string_view(named.parameter.name) == "damping")
      scale(named.name, kLively, &lively);
  }
  FitConfig stiff = lively, stretchy = lively;
  scale("bending.stiffness", kStiff, &stiff);
  scale("stretch.stiffness", kStretchy, &stretchy);
  std::vector<FitConfig> others;
  for (const FitConfig& other : {lively, stiff, stretchy}) {
    const bool is_new = std::none_of(others.begin(), others.end(), [&](const FitConfig& before) {
      return ConfigDifferences(before, other).empty();
    });
    if (is_new && !ConfigDifferences(config, other).empty()) others.push_back(other);
  }
  return others;
}

}  // namespace clothfit
