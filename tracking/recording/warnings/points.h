// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Measured points that a cloth could hardly have: the part of Warnings that looks at positions.
#pragma once

#include <string>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

inline constexpr double kUnlikelyStretch = 1.1;  // more than cloth is likely to stretch

// Appends one line for each kind of oddity: points farther apart than the cloth allows, markers
// that jump or change their (u, v), a stretched start, cloth below the ground.
void WarnOfPoints(const Recording& recording, std::vector<std::string>* warnings);

}  // namespace clothfit
