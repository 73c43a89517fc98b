// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace clothfit {

// Whether OpenCV's FileStorage can parse the text (YAML, XML or JSON) without running out of stack,
// as its parsers call themselves at every level. No more than 100 levels of indentation, brackets
// or elements; and no more than 10 000 brackets or elements in all, for those who hide the closing
// ones in quotes or comments. The parsers bear that many.
bool IsShallow(std::string_view text);

// Whether every tag of XML ends, with its quotes: OpenCV 4.6 reads on beyond the text where one
// does not. True of what is no XML.
bool HasWholeTags(std::string_view text);

}  // namespace clothfit
