// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/gradient_report.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/window_cost.h"

namespace clothfit {
namespace {

// Differences are as good as the steps are solved.
constexpr double kTolerance = 1e-11;  // of a step, see SimulationOptions

// In the free vector's own scale. On a log scale 1 is a factor of e; elsewhere the prior tells.
double TypicalSize(const FreeEntry& entry) {
  constexpr double kLength = 0.01;  // m, of a control point, which has no prior of its own
  if (entry.is_log) return 1.0;
  return std::isfinite(entry.prior_sigma) && entry.prior_sigma > 0.0
             ? std::min(entry.prior_sigma, 1.0)
             : kLength;
}

}  // namespace

bool GradientReport::Passes() const {
  return check.Count(GradientVerdict::kDisagrees) == 0 && check.Count(GradientVerdict::kAgrees) > 0;
}

GradientReport CheckFitGradient(const Scene& scene, const FitConfig& fit_config, int last_frame) {
  FitConfig config = fit_config;
  config.tolerance = std::min(config.tolerance, kTolerance);
  const FreeParameters free(config, scene, MakeParameterTable());
  if (free.size() == 0) throw InputError("parameters", "none is free, so there is no gradient");
  GradientReport report;
  for (const FreeEntry& entry : free.entries()) report.names.push_back(entry.name);

  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  if (!EvaluateResiduals(scene, config, free, free.start(), last_frame, &residuals, &jacobian)) {
    throw std::runtime_error("the simulation fails at the start values");
  }
  report.num_residuals = static_cast<int>(residuals.size());

  GradientCheckOptions options;
  options.typical.resize(free.size());
  for (int i = 0; i < free.size(); ++i) {
    options.typical[i] = TypicalSize(free.entries()[static_cast<size_t>(i)]);
  }
  const VectorFunction function = [&](const Eigen::VectorXd& theta, Eigen::VectorXd* f) {
    return EvaluateResiduals(scene, config, free, theta, last_frame, f, nullptr);
  };
  report.check = CheckGradient(function, free.start(), jacobian, options);
  return report;
}

}  // namespace clothfit
