// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/terms/trial_terms.h"

#include <utility>

#include "autodiff_sim/term/list_check.h"
#include "autodiff_sim/terms/terms.h"

namespace clothfit {
namespace {

template <class... A, class... B>
constexpr TypeList<A..., B...> Joined(TypeList<A...>, TypeList<B...>) {
  return {};
}

static_assert(CheckTerms(Joined(Terms{}, TrialTerms{})));

}  // namespace

std::vector<TermInfo> UnlistedTerms() { return MakeTermInfos(TrialTerms{}); }

Simulation MakeTrialSimulation(ClothMesh mesh, const World& world,
                               const std::vector<SurfacePoint>& handles,
                               const SimulationOptions& options) {
  return Simulation::WithTerms(Joined(Terms{}, TrialTerms{}), std::move(mesh), world, handles,
                               options);
}

}  // namespace clothfit
