// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/joint_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/shared_parameters.h"
#include "fitting/fit/evaluation.h"
#include "fitting/rollout/joint_rollout.h"

namespace clothfit {
namespace {

constexpr double kSigmas95 = 1.959964;

std::string PathOf(const NamedScene& one) { return one.scene->recording.path.string(); }

// Where both move it, or neither does, and where it is shared.
void CheckAgreement(const NamedScene& a, const NamedScene& b) {
  for (const NamedParameter& named : MakeParameterTable()) {
    const ParameterSetting& of_a = a.config->parameters.at(named.name);
    const ParameterSetting& of_b = b.config->parameters.at(named.name);
    const bool is_shared = IsShared(*a.config, named.name);
    if (is_shared != IsShared(*b.config, named.name)) {
      throw InputError("parameters." + named.name + ".shared",
                       fmt::format("{} in {} and {} in {}; expected the same", is_shared, PathOf(a),
                                   !is_shared, PathOf(b)));
    }
    if (!is_shared || of_a.free != of_b.free || of_a.value == of_b.value) continue;
    throw InputError(PathOf(b),
                     fmt::format("{} is {} here and {} in {}; expected one value of one cloth: "
                                 "--set {}=VALUE, or shared: false in the config",
                                 named.name, of_b.value, of_a.value, PathOf(a), named.name));
  }
}

// The estimate of an entry that nothing was fitted to: what its prior says.
void TellPrior(const FreeParameters& free, int entry, ParameterEstimate* estimate) {
  const FreeEntry& one = free.entries()[static_cast<std::size_t>(entry)];
  const double start = free.start()[entry];
  estimate->name = one.name;
  estimate->unit = one.unit;
  estimate->free = true;
  estimate->determined = false;
  estimate->value = estimate->start = free.UnitValue(entry, start);
  estimate->lower95 = free.UnitValue(entry, start - kSigmas95 * one.prior_sigma);
  estimate->upper95 = free.UnitValue(entry, start + kSigmas95 * one.prior_sigma);
}

// Of all markers and tracks, to which nothing was fitted; empty where there are none, or they are
// not reached.
std::optional<Misfit> MisfitOfPrediction(const Scene& scene, const FitConfig& config,
                                         const Eigen::VectorXd& theta) {
  Scene seen = scene;
  seen.silhouettes.reset();
  seen.recording.splits.held_out_frames.reset();
  seen.is_fitted.assign(seen.is_fitted.size(), true);
  seen.last_fitted_frame = seen.recording.frame_count - 1;
  FitConfig of_points = config;
  of_points.use_silhouettes = false;
  of_points.beta = 1.0;  // sigmas, not shares of a cost
  const JointScenes scenes({{"", &seen, &of_points}});
  Eigen::VectorXd residuals;
  if (scenes.NumResiduals() == 0 ||
      !JointRollout(scenes, false, nullptr).Evaluate(theta, WindowRows::kAll, &residuals, nullptr))
    return std::nullopt;
  return MeasureMisfit(SeenResiduals(scenes, residuals), 0);
}

// The fit's estimate of a parameter that is shared and was free; null where there is none.
const ParameterEstimate* FindFitted(const FitResult& fit, const std::string& name) {
  for (const ParameterEstimate& estimate : fit.estimates)
    if (estimate.free && estimate.name == name) return &estimate;
  return nullptr;
}

}  // namespace

void CheckJoint(const std::vector<NamedScene>& scenes) {
  for (const NamedScene& one : scenes) {
    if (one.config->optimiser != "lm" || one.config->loops != Strategy::kJoint) {
      throw InputError("strategy", fmt::format("{}/{}: several recordings are fitted by lm, joint",
                                               one.config->optimiser, ToString(one.config->loops)));
    }
    CheckAgreement(scenes.front(), one);
  }
}

FitResult PredictRecording(const Scene& scene, const FitConfig& config, const FitResult& fit) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  const FreeParameters free(config, scene, table);
  FitResult result;
  result.status = fit.status;
  result.theta = free.start();
  const Eigen::VectorXd values = free.Values(free.start());
  for (std::size_t k = 0; k < table.size(); ++k) {
    ParameterEstimate estimate;
    estimate.name = table[k].name;
    estimate.unit = table[k].parameter.unit;
    estimate.value = estimate.start = estimate.lower95 = estimate.upper95 =
        values[static_cast<Eigen::Index>(k)];
    result.estimates.push_back(estimate);
  }
  for (int i = 0; i < free.size(); ++i) {
    const FreeEntry& entry = free.entries()[static_cast<std::size_t>(i)];
    const bool is_physical = entry.kind == FreeEntry::Kind::kParameter;
    if (!is_physical) result.estimates.emplace_back();
    ParameterEstimate* estimate = is_physical
                                      ? &result.estimates[static_cast<std::size_t>(entry.index)]
                                      : &result.estimates.back();
    const ParameterEstimate* found =
        is_physical && IsShared(config, entry.name) ? FindFitted(fit, entry.name) : nullptr;
    TellPrior(free, i, estimate);
    if (found == nullptr) continue;
    *estimate = *found;
    result.theta[i] = entry.is_log ? std::log(found->value) : found->value;
  }
  result.parameters = free.Values(result.theta);
  result.before = EvaluateScene(scene, config, free, free.start());
  result.after = EvaluateScene(scene, config, free, result.theta);
  result.cost_before = result.cost_after = std::numeric_limits<double>::quiet_NaN();
  result.misfit = MisfitOfPrediction(scene, config, result.theta);
  if (result.misfit) result.noise_factor = std::max(1.0, std::sqrt(result.misfit->chi_square));
  return result;
}

}  // namespace clothfit
