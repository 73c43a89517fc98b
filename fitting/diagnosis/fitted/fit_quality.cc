// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/fit_quality.h"

#include "fitting/residuals/observation_residuals.h"

namespace clothfit {
namespace {

constexpr double kWorthAnotherStart = 1.2;  // sigmas beyond which it may be in a local minimum

// Does a fit leave more than so many sigmas, or nothing of use?
bool LeavesMoreThan(double sigmas, const Scene& scene, const FitConfig& config,
                    const FitResult& fit) {
  const ObservationResiduals observations(scene, config);
  const int rows = observations.NumObserved(0, scene.last_fitted_frame);
  return fit.status == FitStatus::kFailed || fit.cost_after > 0.5 * sigmas * sigmas * rows;
}

}  // namespace

bool HasLargeResidual(const Scene& scene, const FitConfig& config, const FitResult& fit) {
  return LeavesMoreThan(kLargeResidual, scene, config, fit);
}

bool MayBeLocalMinimum(const Scene& scene, const FitConfig& config, const FitResult& fit) {
  return LeavesMoreThan(kWorthAnotherStart, scene, config, fit);
}

}  // namespace clothfit
