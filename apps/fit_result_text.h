// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit found, for people.
#pragma once

#include <string>

#include "fitting/fit/fit.h"

namespace clothfit {

// Several lines: how it ended, errors before and after, estimates, statements.
std::string DescribeFitResult(const FitResult& result);

}  // namespace clothfit
