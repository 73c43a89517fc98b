// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of parameters.
#include "autodiff_sim/parameter_table.h"

#include "autodiff_sim/terms.h"

namespace clothfit {

std::vector<NamedParameter> MakeParameterTable(const std::vector<TermInfo>& terms) {
  constexpr Parameter kDensity = {
      "areal_density", "kg/m^2", "mass of the cloth per area", 0.15, 0.15, 0.01, 2.0,
      Scale::kLog,     1.5};
  std::vector<NamedParameter> table = {{"cloth.areal_density", "cloth", kDensity}};
  for (const TermInfo& term : terms) {
    for (const Parameter& p : term.parameters)
      table.push_back({term.name + "." + p.name, term.name, p});
  }
  return table;
}

std::vector<TermInfo> AllTerms() { return MakeTermInfos(Terms{}); }

std::vector<NamedParameter> MakeParameterTable() { return MakeParameterTable(AllTerms()); }

int FindParameter(const std::vector<NamedParameter>& table, const std::string& name) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Eigen::VectorXd InitialValues(const std::vector<NamedParameter>& table) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(table.size()));
  for (std::size_t i = 0; i < table.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = table[i].parameter.initial;
  return values;
}

}  // namespace clothfit
