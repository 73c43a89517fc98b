// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Text from files, fit to be shown.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace clothfit {

// The text as one line that steers no terminal: line breaks as blanks; other control characters,
// marks that turn the direction of writing, and what is no UTF-8 as \x1b or \u202e. Of one with
// more than `most` bytes the beginning and the end.
std::string Printable(std::string_view text, std::size_t most = 1500);

// 'text', short enough for a message.
std::string Quoted(std::string_view text);

}  // namespace clothfit
