// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis as a page of Markdown.
#pragma once

#include <string>

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

// The answer in sentences and what to do next; for specialists the tables that it was read from.
std::string DiagnosisAsMarkdown(const Diagnosis& diagnosis);

}  // namespace clothfit
