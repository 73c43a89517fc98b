// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer of a diagnosis in sentences.
#pragma once

#include <string>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

// The answer as one paragraph, the headline first.
std::string DescribeDiagnosis(const Diagnosis& diagnosis);

// What follows the headline: what would tell apart what the recording cannot, amounts, where it
// acts, how sure it is. A sentence, or a few that belong together, each.
std::vector<std::string> DetailsOf(const Diagnosis& diagnosis);

// For a terminal: the headline on a line of its own, then the rest.
std::string DiagnosisAsText(const Diagnosis& diagnosis);

}  // namespace clothfit
