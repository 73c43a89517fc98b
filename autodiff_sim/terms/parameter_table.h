// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// All parameters of a simulation under their full names, term.parameter, in one order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "autodiff_sim/term/force_batch.h"

namespace clothfit {

struct NamedParameter {
  std::string name;  // term.parameter
  std::string term;
  Parameter parameter;
  Role role = Role::kOrdinary;  // the term's
};

// The parameters of these terms, in the terms' order, after the cloth's own.
std::vector<NamedParameter> MakeParameterTable(const std::vector<TermInfo>& terms);

// The table of clothfit's own terms; it is made once.
const std::vector<NamedParameter>& MakeParameterTable();
// What clothfit's own terms say of themselves, in the list's order.
const std::vector<TermInfo>& AllTerms();

// The full name of a term's parameter, for what is about this very term.
template <class Term>
std::string FullName(int index = 0) {
  return std::string(Term::kName) + "." + Term::kParameters[static_cast<std::size_t>(index)].name;
}

// Values of all parameters of these terms by their full names; those of a term in its own order:
// ValuesOf<Gravity, Shear>({1.0}, {20.0, 0.1}).
template <class... Terms, std::size_t... kCounts>
std::map<std::string, double> ValuesOf(const double (&... values)[kCounts]) {
  static_assert(((kCounts == Terms::kParameters.size()) && ...), "a value of each parameter");
  std::map<std::string, double> all;
  const auto add = [&all](const double* value, std::size_t count, std::string (*name)(int)) {
    for (std::size_t i = 0; i < count; ++i) all[name(static_cast<int>(i))] = value[i];
  };
  (add(values, kCounts, &FullName<Terms>), ...);
  return all;
}

// Index of the parameter with this full name; -1 where there is none.
int FindParameter(const std::vector<NamedParameter>& table, const std::string& name);
// The same of one that must be there. Throws InputError with the place, the name and the nearest
// right one where it is not.
int RequireParameter(const std::vector<NamedParameter>& table, const std::string& name,
                     const std::string& place = "parameters");

// Every parameter's initial value.
Eigen::VectorXd InitialValues(const std::vector<NamedParameter>& table);

}  // namespace clothfit
