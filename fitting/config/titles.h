// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What sentences call force terms, parameters and faults of the observation.
#pragma once

#include <string>
#include <vector>

namespace clothfit {

// "wind", "unseen ball", "bending damping" of a parameter, "clock of camera cam0" of a fault.
std::string TitleOf(const std::string& effect);
std::vector<std::string> TitlesOf(const std::vector<std::string>& effects);

}  // namespace clothfit
