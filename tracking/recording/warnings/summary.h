// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a user would want to know about a recording before fitting it.
#pragma once

#include <string>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

// A compact table for people, several lines, each ended by a newline: a label of kLabelWidth
// characters and what there is of it.
inline constexpr std::size_t kLabelWidth = 12;
std::string DescribeRecording(const Recording& recording);

// Things that are allowed but worth knowing, one line each, the most important first.
std::vector<std::string> Warnings(const Recording& recording);

}  // namespace clothfit
