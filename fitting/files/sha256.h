// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The SHA-256 digest, FIPS 180-4: what was written down beforehand can be checked afterwards.
#pragma once

#include <string>
#include <string_view>

namespace clothfit {

// 64 hexadecimal digits in lower case.
std::string Sha256(std::string_view message);

}  // namespace clothfit
