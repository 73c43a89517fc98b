// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How the words of a command line are understood, and answered where they cannot be.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace clothfit {

// The words after the program's name as CLI11 takes them: beginnings of commands that fit only one
// are completed, and "help COMMAND" becomes "COMMAND --help". Throws InputError where a beginning
// fits several commands, or none, or where a flag is given a value.
std::vector<std::string> CompleteCommands(const CLI::App& app, std::vector<std::string> words);

// One line about a command line that CLI11 refused. `words`: the same as CompleteCommands made
// them.
std::string DescribeParseError(const CLI::App& app, const CLI::ParseError& error,
                               const std::vector<std::string>& words);

}  // namespace clothfit
