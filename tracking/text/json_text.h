// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// JSON, and CBOR as its bytes, before they are parsed. nlohmann's parser of CBOR and all its
// writers call themselves at every level; what a stranger nests may leave them no stack.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"

namespace clothfit {

// Of one file: 300 000 jobs of a study. Parsed, it takes some twenty times as many.
inline constexpr std::size_t kMostJsonBytes = std::size_t{1} << 26;
// Lists and objects in each other; clothfit's own files have less than 20.
inline constexpr int kMostJsonLevels = 100;

// As ReadInputFile, of one for nlohmann's parse. Throws InputError beyond either limit; whether it
// is JSON at all the parser tells.
std::string ReadJsonText(const std::filesystem::path& file);

// What `take` makes of the parsed file. Throws InputError, "FILE: PROBLEM: " and nlohmann's words,
// where it is no JSON or `take` finds a key missing or of another type.
template <class Json = nlohmann::json, class Take>
auto ReadJson(const std::filesystem::path& file, const std::string& problem, Take take) {
  try {
    return take(Json::parse(ReadJsonText(file)));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string(), problem + ": " + error.what());
  }
}

// Null for a number that is not known, infinite or none, which JSON has no word for.
nlohmann::ordered_json OrNull(const std::optional<double>& value);

// Whether it has no more levels than that, and no string or bytes of no stated length: those may
// hold others of their kind, level by level, and clothfit writes none. As of JSON, the parser tells
// whether it is CBOR.
bool IsShallowCbor(std::string_view bytes);

}  // namespace clothfit
