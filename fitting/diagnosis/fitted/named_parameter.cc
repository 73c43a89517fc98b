// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/named_parameter.h"

#include <vector>

namespace clothfit {

Parameter ParameterNamed(const std::string& name) {
  static const std::vector<NamedParameter> table = MakeParameterTable();
  return table[static_cast<std::size_t>(RequireParameter(table, name))].parameter;
}

}  // namespace clothfit
