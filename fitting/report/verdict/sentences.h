// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit's verdict says of each of its numbers, a sentence each.
#pragma once

#include <string>

#include "fitting/report/verdict/page_verdict.h"

namespace clothfit {

inline constexpr double kGoodNoise = 1.5;    // times the stated sigmas
inline constexpr double kGoodHeldOut = 1.5;  // times the fitted error

// Errors whose `after` is known. `ratio`: of the held-out to the fitted one.
std::string FittedSentence(const ErrorChange& error);
std::string HeldOutSentence(const ErrorChange& error, double ratio);

// `factor`: residuals over their stated sigmas.
std::string NoiseSentence(double factor);
// Of markers and tracks, whose noise is known.
std::string MisfitSentence(const Misfit& misfit);
std::string MeshSentence(const Misfit& misfit);

// Which of the free physical parameters the data determine.
std::string ParameterSentence(const VerdictFacts& facts);

}  // namespace clothfit
