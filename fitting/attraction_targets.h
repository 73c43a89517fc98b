// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What pulls at the cloth while it is simulated towards its observations (Hasler et al. 2007,
// sec. 4).
#pragma once

#include "autodiff_sim/step_inputs.h"
#include "fitting/scene.h"

namespace clothfit {

// Adds the fitted markers of a frame and the rays of its fitted tracks; they pull as strongly as
// attraction_point.* and attraction_ray.* say.
void AddAttractionTargets(const Scene& scene, int frame, StepInputs* inputs);

}  // namespace clothfit
