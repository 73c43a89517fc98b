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

#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/base/names.h"

namespace clothfit {

// The finite number that the whole text spells (blanks around it are allowed), or nothing. Reads
// decimals and exponents whatever the locale.
std::optional<double> ParseNumber(std::string_view text);
std::optional<int> ParseInteger(std::string_view text);

// The shortest decimal that reads back as the same double.
std::string FormatNumber(double value);

// "2.8 mm" of 0.00284 "m", "0.33 px": what is told to people, the same wherever it stands.
std::string QuantityInWords(double value, const std::string& unit);

// With a capital letter; with that and a full stop.
std::string Capitalised(std::string words);
std::string AsSentence(std::string words);

std::string_view TrimBlanks(std::string_view text);

inline bool StartsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

// As ReadInputFile.
inline std::string ReadTextFile(const std::filesystem::path& file) { return ReadInputFile(file); }

}  // namespace clothfit
