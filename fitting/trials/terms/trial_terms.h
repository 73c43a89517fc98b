// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Effects that clothfit's own list of terms lacks, for the generator of trials: what no diagnosis
// can name, and has to say so of.
#pragma once

#include <vector>

#include "autodiff_sim/step/simulation.h"
#include "fitting/trials/terms/unlisted_terms.h"

namespace clothfit {

// What these terms say of themselves, in the list's order.
std::vector<TermInfo> UnlistedTerms();

// A simulation with clothfit's own terms and these after them.
Simulation MakeTrialSimulation(ClothMesh mesh, const World& world,
                               const std::vector<SurfacePoint>& handles,
                               const SimulationOptions& options);

}  // namespace clothfit
