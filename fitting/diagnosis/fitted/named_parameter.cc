// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/named_parameter.h"

#include <stdexcept>
#include <vector>

namespace clothfit {

Parameter ParameterNamed(const std::string& name) {
  static const std::vector<NamedParameter> table = MakeParameterTable();
  const int index = FindParameter(table, name);
  if (index < 0) throw std::out_of_range("no parameter " + name);
  return table[static_cast<std::size_t>(index)].parameter;
}

}  // namespace clothfit
