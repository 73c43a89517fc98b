// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/fit_quality.h"

#include "fitting/residuals/observation_residuals.h"

namespace clothfit {
namespace {

constexpr double kWorthAnotherStart = 1.2;  // sigmas beyond which it may be in a wrong valley

// Does a fit leave more than so many sigmas, or nothing of use?
bool IsFurtherOff(double sigmas, const Scene& scene, const FitConfig& config,
                  const FitResult& fit) {
  const ObservationResiduals observations(scene, config);
  const int rows = observations.NumObserved(0, scene.last_fitted_frame);
  return fit.status == FitStatus::kFailed || fit.cost_after > 0.5 * sigmas * sigmas * rows;
}

}  // namespace

bool IsFarOff(const Scene& scene, const FitConfig& config, const FitResult& fit) {
  return IsFurtherOff(kFarOff, scene, config, fit);
}

bool IsOff(const Scene& scene, const FitConfig& config, const FitResult& fit) {
  return IsFurtherOff(kWorthAnotherStart, scene, config, fit);
}

}  // namespace clothfit
