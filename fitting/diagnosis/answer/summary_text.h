// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis for people and for programs.
#pragma once

#include <filesystem>
#include <string>

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

// The answer as one paragraph.
std::string DescribeDiagnosis(const Diagnosis& diagnosis);

// The ranking, the models and where the time went, as Markdown.
std::string DiagnosisAsMarkdown(const Diagnosis& diagnosis);

// As docs/file-formats.md describes diagnosis.json.
std::string DiagnosisAsJson(const Diagnosis& diagnosis);

}  // namespace clothfit
