// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that other commands left, checked to be there and of this version.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace clothfit {

// The file itself. Throws InputError where it is missing; `expected`: of what it is a part.
std::filesystem::path RequireFile(const std::filesystem::path& file, const std::string& expected);

// A JSON object that says which version of clothfit wrote it. Throws InputError where it is no such
// object, or of another version; `remedy`: what to do then.
nlohmann::ordered_json ReadRecordFile(const std::filesystem::path& file, const std::string& remedy);

}  // namespace clothfit
