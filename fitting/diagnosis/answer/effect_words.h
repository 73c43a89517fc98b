// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Effects in plain words, with their amounts.
#pragma once

#include <string>
#include <vector>

#include "fitting/diagnosis/fitted/effect_parameter.h"

namespace clothfit {

// "air that moves evenly, felt through the air drag (wind)"; the name itself where it is no term's.
std::string PlainName(const std::string& effect);
std::string PlainNames(const std::vector<std::string>& effects);

// Of all effects, "wind: 0.56 m/s (0.51 to 0.93) along (0.1, 0.97, 0.21)" and the like, one after
// the other. Velocities, forces and moments are told as one number and a direction, tilts as one
// angle in degrees; amounts that are nothing beside the largest of their unit are left out. Both
// ends of an interval are of 90 %.
std::string AmountsInWords(const std::vector<std::string>& effects,
                           const std::vector<EffectParameter>& parameters);

}  // namespace clothfit
