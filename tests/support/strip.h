// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A strip of cloth that turns, so small that a whole diagnosis of it takes seconds.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fitting/config/config.h"
#include "fitting/diagnosis/fitted/options.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

// A mesh so long that it is taken as it is, and as narrow as can be. effects: parameters that are
// not off.
SyntheticOptions Strip(const std::map<std::string, double>& effects);

// Seen by three cameras alone, of which the second stands so far (m) from where it is said to be.
Recording SeenAskew(const std::map<std::string, double>& effects, const Eigen::Vector3d& shift);

// Few iterations, and two parameters of the material free.
FitConfig Told(const Recording& recording);

// Of all physics, that of these terms alone is looked for.
DiagnosisOptions OnlyAmong(const std::vector<std::string>& terms);

}  // namespace clothfit
