// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where else a fit may begin.
#pragma once

#include <vector>

#include "fitting/config/config.h"

namespace clothfit {

// Other material parameters to begin with: one with a tenth of the damping, and that one with
// twenty times the stiffness in bending, or with a tenth of that in stretch. What is not free stays
// as it is, and starts that come out equal, or equal to the config's own, are left out.
std::vector<FitConfig> OtherStarts(const FitConfig& config);

}  // namespace clothfit
