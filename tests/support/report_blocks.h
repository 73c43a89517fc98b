// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A report's page read back as a browser reads it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace clothfit {

std::string FromBase64(std::string_view text);

// What PackRows packed; `width`: bytes an integer.
std::vector<std::uint32_t> UnpackRows(std::string_view packed, std::size_t count, std::size_t row,
                                      std::size_t width);

// The text of the page's script element with this id; empty where there is none.
std::string ScriptOfPage(const std::string& html, const std::string& id);

nlohmann::json DataOfPage(const std::string& html);

// The numbers of a block of type u16.
std::vector<double> NumbersOfBlock(const std::string& html, const nlohmann::json& block);

}  // namespace clothfit
