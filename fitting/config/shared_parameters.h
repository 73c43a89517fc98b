// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which parameters several recordings of one cloth have in common.
#pragma once

#include <string>

#include "fitting/config/config.h"

namespace clothfit {

// As the config says of this parameter (full name), else by what it is. Shared is what is of the
// cloth (density, shrinkage) and what stays with the material or with what touches it: stiffness,
// damping, drag in the air, friction. What is of the world or of a moment (wind, a tilt of gravity,
// an unseen obstacle, a grip) is of each recording.
bool IsShared(const FitConfig& config, const std::string& parameter);

}  // namespace clothfit
