// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A diagnosis for programs.
#pragma once

#include <string>

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

// As docs/file-formats.md describes diagnosis.json.
std::string DiagnosisAsJson(const Diagnosis& diagnosis);

}  // namespace clothfit
