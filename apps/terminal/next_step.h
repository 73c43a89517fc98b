// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The last line of a command that went well: what to do with its result.
#pragma once

#include <string>

namespace clothfit {

// Prints "next: TEXT" to the standard output.
void PrintNext(const std::string& text);

}  // namespace clothfit
