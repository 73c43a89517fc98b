// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the value of an option has to be, in the words of clothfit's errors.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace clothfit {

// Each refuses another value in words that come after the option's name: "99; expected a whole
// number from 1 to 10". They add nothing to the help.
CLI::Validator WholeNumber(int least, int most);
CLI::Validator NumberAboveZero();
CLI::Validator OneOf(const std::vector<std::string>& names);

}  // namespace clothfit
