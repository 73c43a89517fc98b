// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit found, for people.
#pragma once

#include <string>

#include "fitting/fit/fit.h"
#include "fitting/report/page_verdict.h"

namespace clothfit {

// Several lines: how it ended, errors before and after, estimates, statements.
std::string DescribeFitResult(const FitResult& result);

// What it amounts to: a headline and sentences, one a line.
std::string DescribeVerdict(const PageVerdict& verdict);

}  // namespace clothfit
