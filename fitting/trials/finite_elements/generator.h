// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings by finite elements: see fem_cloth.h.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fitting/diagnosis/classify/acting_force.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

// Simulates every scenario whose handles are corners of the cloth. The mesh is drawn
// from the options' seed.
// `terms` are those whose force goes into `force`, if that is not null, when the simulation is
// done. Parameters of unlisted terms stand in `unlisted`. Simulating throws std::runtime_error
// where the finite elements diverge.
SyntheticGenerator FiniteElementGenerator(const std::map<std::string, double>& unlisted,
                                          const std::vector<std::string>& terms,
                                          ActingForce* force);

}  // namespace clothfit
