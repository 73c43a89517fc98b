// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit found, for people.
#pragma once

#include <string>
#include <vector>

#include "fitting/fit/fit.h"
#include "fitting/report/verdict/page_verdict.h"

namespace clothfit {

// Several lines: how it ended, errors before and after, estimates, statements but for what the
// verdict says.
std::string DescribeFitResult(const FitResult& result);

// The same of a fit of several recordings; names: of FitResult::recordings.
std::string DescribeJointResult(const FitResult& result, const std::vector<std::string>& names);

// What it amounts to: a headline and sentences, one a line.
std::string DescribeVerdict(const PageVerdict& verdict);

}  // namespace clothfit
