// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of parameters.
#include "autodiff_sim/terms/parameter_table.h"

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "autodiff_sim/term/list_check.h"
#include "autodiff_sim/terms/added_terms.h"
#include "autodiff_sim/terms/terms.h"

namespace clothfit {

namespace {

static_assert(CheckTerms(Terms{}));

constexpr Parameter kClothParameters[kNumClothParameters] = {
    {"areal_density", "kg/m^2", "mass of the cloth per area", 0.15, 0.15, 0.01, 2.0, Scale::kLog,
     1.5},
    {"shrink_warp", "1", "share by which rest lengths along the warp are below the (u, v) given",
     0.0, 0.0, -0.1, 0.1, Scale::kLinear, 0.01},
    {"shrink_weft", "1", "share by which rest lengths along the weft are below the (u, v) given",
     0.0, 0.0, -0.1, 0.1, Scale::kLinear, 0.01},
};

}  // namespace

std::vector<NamedParameter> MakeParameterTable(const std::vector<TermInfo>& terms) {
  std::vector<NamedParameter> table;
  for (const Parameter& p : kClothParameters)
    table.push_back({std::string("cloth.") + p.name, "cloth", p, Role::kOrdinary});
  for (const TermInfo& term : terms) {
    for (const Parameter& p : term.parameters)
      table.push_back({term.name + "." + p.name, term.name, p, term.role});
  }
  return table;
}

const std::vector<TermInfo>& AllTerms() {
  static const std::vector<TermInfo> terms = [] {
    std::vector<TermInfo> all = MakeTermInfos(Terms{});
    for (const AddedTerm& term : AddedTerms()) {
      for (const TermInfo& other : all)
        if (other.name == term.info.name)
          throw InputError("term " + other.name, "is there already");
      all.push_back(term.info);
    }
    return all;
  }();
  return terms;
}

const std::vector<NamedParameter>& MakeParameterTable() {
  static const std::vector<NamedParameter> table = MakeParameterTable(AllTerms());
  return table;
}

int FindParameter(const std::vector<NamedParameter>& table, const std::string& name) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

int RequireParameter(const std::vector<NamedParameter>& table, const std::string& name,
                     const std::string& place) {
  const int index = FindParameter(table, name);
  if (index >= 0) return index;
  throw InputError(place, "'" + name + "' is no parameter; " + Suggestion(name, NamesOf(table)));
}

Eigen::VectorXd InitialValues(const std::vector<NamedParameter>& table) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(table.size()));
  for (std::size_t i = 0; i < table.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = table[i].parameter.initial;
  return values;
}

}  // namespace clothfit
