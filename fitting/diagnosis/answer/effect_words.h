// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Effects in plain words, with their amounts.
#pragma once

#include <string>
#include <vector>

#include "fitting/config/titles.h"
#include "fitting/diagnosis/fitted/effect_parameter.h"

namespace clothfit {

// "wind of 0.56 m/s (0.51 to 0.93) along +y", "unseen ball, its middle at (0.10, 0.20, 0.30) m",
// "clock of camera cam0 off by 0.02 s": the title with what it is about, in a few words.
// `parameters` may hold others' too. Intervals are of 90 %.
std::string InBrief(const std::string& effect, const std::vector<EffectParameter>& parameters);

// "air that moves evenly, felt through the air drag (wind)"; the title where it is no term's.
std::string PlainName(const std::string& effect);
std::string PlainNames(const std::vector<std::string>& effects);

// Of all effects, "Wind: 0.56 m/s (0.51 to 0.93) along +y." and the like, one after the other, with
// places and shapes. Velocities, forces and moments are told as one number and a direction, tilts
// as one angle in degrees; amounts that are nothing beside the largest of their unit are left out.
// Both ends of an interval are of 90 %. What stands in `told`, as InBrief has it, is not repeated.
std::string AmountsInWords(const std::vector<std::string>& effects,
                           const std::vector<EffectParameter>& parameters,
                           const std::string& told = "");

}  // namespace clothfit
