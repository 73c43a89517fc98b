// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What CLI11 found wrong with an option or its values, in the words that clothfit uses everywhere.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace clothfit {

// "--max-effects: 99; expected a whole number from 1 to 10": the option as it was typed, what was
// found and what was expected. `words`: the command line.
std::string DescribeOptionError(const CLI::App& command, const CLI::ParseError& error,
                                const std::vector<std::string>& words);

// Has all commands refuse "inf", "nan" and "1e999" for numbers, which are those options whose type
// the help calls by one of the names of numbers. To be called once all options are there.
void RefuseWhatIsNotFinite(CLI::App* app);

// Throws InputError where a flag is given a value, as in --force=3, which CLI11 takes for anything.
void RefuseValuesOfFlags(const CLI::App& command, const std::vector<std::string>& words);

}  // namespace clothfit
