// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Complete sets of options for synthetic recordings with images.
#pragma once

#include <string>
#include <vector>

#include "tracking/synthetic/recording.h"

namespace clothfit {

// Images only, of the cloth and the cameras of the first experiment below.
SyntheticOptions ImageOptions();

// experiment-1, experiment-2, experiment-3: the three of Hasler et al. 2007, remade. A
// cloth of 1.4 m lies on the ground before seven cameras; a hand lifts a corner of it (1, 2) or two
// hands those of an edge (3). It has a rich texture (1, 3), or a repetitive and shiny one (2).
std::vector<std::string> PresetNames();
// Throws InputError, naming `place`, where there is no such preset.
SyntheticOptions PresetOptions(const std::string& place, const std::string& name);

}  // namespace clothfit
