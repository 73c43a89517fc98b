// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A user's own check of a fit's derivatives: the Jacobian of all residuals of a recording's first
// frames, against differences that know their own error.
#pragma once

#include <string>
#include <vector>

#include "autodiff_sim/base/gradient_check.h"
#include "fitting/rollout/free_parameters.h"

namespace clothfit {

struct GradientReport {
  std::vector<std::string> names;  // of the free vector's entries, one a column
  GradientCheckReport check;
  int num_residuals = 0;
  // No column disagrees and some agree. One that is undecided has too little signal to tell.
  bool Passes() const;
};

// At the config's start, over frames 0 to last_frame, with steps solved to 1e-11 mean edges or
// better. Throws std::runtime_error where the simulation fails there.
GradientReport CheckFitGradient(const Scene& scene, const FitConfig& config, int last_frame);

}  // namespace clothfit
