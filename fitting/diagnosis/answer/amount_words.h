// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Amounts of effects, with their 90 % intervals, in words.
#pragma once

#include <string>
#include <vector>

#include "fitting/diagnosis/fitted/effect_parameter.h"

namespace clothfit {

// "0.56 m/s (0.51 to 0.93)"; angles in degrees.
std::string Alone(const EffectParameter& p);

// Of numbers that are one: its size, whose errors are theirs along it.
EffectParameter SizeOf(const std::vector<EffectParameter>& parts);

// A term's, as one number with a direction where it has one, or one by one with what each is, but
// for those that are nothing beside the largest of their unit.
std::string AmountsOfTerm(const std::vector<EffectParameter>& amounts);

// What only shapes a term's force: its places, sizes and times.
std::string ShapesOfTerm(const std::vector<EffectParameter>& shapes);

// "its middle at (0.10, 0.20, 0.30) m": the first place in the world among these; empty where there
// is none.
std::string FirstPlace(const std::vector<EffectParameter>& shapes);

}  // namespace clothfit
