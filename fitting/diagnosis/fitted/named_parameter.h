// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Parameters of clothfit's own terms by their full names.
#pragma once

#include <string>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

// What "wind.x" says of itself. Throws InputError where there is no such parameter.
Parameter ParameterNamed(const std::string& name);

}  // namespace clothfit
