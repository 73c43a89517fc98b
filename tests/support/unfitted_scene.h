// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "fitting/diagnosis/fitted/rows.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// The recording's cloth with these parameters and the config's others, nothing free, as if it had
// been fitted.
FittedScene UnfittedScene(const Recording& recording,
                          const std::map<std::string, double>& values = {});

}  // namespace clothfit
