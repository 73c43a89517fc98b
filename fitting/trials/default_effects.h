// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions and amounts for a term of which nothing is known but what it says of itself, so that
// trials plant it as soon as it is there. Whether they are fair `clothfit trials --effects` tells;
// where not, chosen_effects.cc takes a row.
#pragma once

#include <vector>

#include "fitting/trials/effects.h"

namespace clothfit {

// In two motions in which such a term can act: one parameter that switches it on, 0.3, 1 and 3
// sigmas of its prior from off, and its shapes in the middle of their probes. None for a term that
// needs obstacles, which no trial has.
std::vector<PlantableEffect> DefaultEffects(const TermInfo& term);

}  // namespace clothfit
