// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What --version prints.
#pragma once

#include <string>

namespace clothfit {

// "clothfit 0.1.0 (x86-64-v3)".
std::string VersionLine();

// With libraries, compiler and machine: what a report of a bug needs.
std::string VersionDetails();

}  // namespace clothfit
