// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Text files and what is written in them: numbers, names and the nearest right name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clothfit {

// The finite number that the whole text spells (blanks around it are allowed), or nothing. Reads
// decimals and exponents whatever the locale.
std::optional<double> ParseNumber(std::string_view text);
std::optional<int> ParseInteger(std::string_view text);

// The shortest decimal that reads back as the same double.
std::string FormatNumber(double value);

std::string_view TrimBlanks(std::string_view text);

// Number of characters to insert, delete, replace or swap with their neighbour to turn a into b
// (optimal string alignment).
int EditDistance(std::string_view a, std::string_view b);

// "did you mean 'size'?" when one of the names is near, otherwise "expected one of size, ...".
std::string Suggestion(std::string_view wrong, const std::vector<std::string>& right_names);

// "a, b, c".
std::string JoinNames(const std::vector<std::string>& names);

// Throw InputError when the file cannot be read or written.
std::string ReadTextFile(const std::filesystem::path& file);
void WriteTextFile(const std::filesystem::path& file, const std::string& text);

}  // namespace clothfit
