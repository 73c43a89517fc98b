// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether anything in the scene holds the cloth, or moves it.
#pragma once

#include <string>

#include "tracking/recording/recording.h"

namespace clothfit {

// What is missing, in words that begin a line: without a handle a cloth only falls, freely where
// neither ground nor an obstacle can catch it. Empty where there is a handle, or an obstacle that
// may catch it. An obstacle that moves, or whose bounding sphere is below that of the cloth or in
// it, may; so may any where it, or the cloth, is a mesh. No file is read.
std::string DescribeLackOfSupport(const Recording& recording);

}  // namespace clothfit
