// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions and amounts that were chosen by measuring how far they move the cloth
// (`clothfit trials --effects`). A term without a row gets those of default_effects.h.
#pragma once

#include <vector>

#include "fitting/trials/effects.h"

namespace clothfit {

std::vector<PlantableEffect> ChosenEffects();
std::vector<PlantableEffect> ChosenUnlistedEffects();

}  // namespace clothfit
