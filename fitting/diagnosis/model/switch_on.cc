// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/switch_on.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/rollout/shooting_windows.h"

namespace clothfit {
namespace {

// Where a fit may begin.
constexpr double kSharesOfEstimate[] = {1.0, 0.3, 0.1, 3.0};

// The shapes of a term that a fit may move once it is on.
void FreeShapes(const Probe& probe, FitConfig* config) {
  for (const auto& [name, value] : probe) {
    ParameterSetting& setting = config->parameters.at(name);
    setting.value = setting.prior = Inside(value, setting);
    setting.free = true;
  }
  for (const std::string& name : EndsOfLine(probe)) config->parameters.at(name).free = false;
}

double LeastStiffness(const RankedCandidate& candidate, const FittedScene& fitted) {
  for (const TermInfo& term : AllTerms()) {
    const auto is = [&](Tie tie) {
      return std::find(term.ties.begin(), term.ties.end(), tie) != term.ties.end();
    };
    if (term.name == candidate.term.term && is(Tie::kContact) && is(Tie::kWorld))
      return SoftestObstacle(fitted);
  }
  return 0.0;
}

// A candidate's settings, as a model has fitted them; a fault has none.
void TakeOver(const RankedCandidate& candidate, const FittedScene& model, FitConfig* config) {
  if (candidate.summary.kind == CandidateKind::kObservation) return;
  std::vector<std::string> names = candidate.names;
  for (const auto& [name, value] : candidate.probe) names.push_back(name);
  for (const std::string& name : names) {
    ParameterSetting& setting = config->parameters.at(name);
    setting = model.config.parameters.at(name);
    setting.value = Inside(model.values.parameters.at(name).value, setting);
  }
}

// Of a start as FitModel begins it, without derivatives; infinite where the simulation fails.
double CostOf(const FittedScene& fitted, const ModelStart& start) {
  const FitConfig config = QuickConfig(start.config, 0, kEnoughForDiagnosis);
  const Scene scene = MakeScene(start.recording, config, &fitted.scene);
  const FreeParameters free(config, scene, MakeParameterTable());
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& theta : {ThetaOfPass(free, fitted.unknown), free.start()}) {
    Eigen::VectorXd residuals;
    if (EvaluateResiduals(scene, config, free, theta, scene.last_fitted_frame, &residuals, nullptr))
      least = std::min(least, 0.5 * residuals.squaredNorm());
  }
  return least;
}

}  // namespace

double SoftestObstacle(const FittedScene& fitted) {
  constexpr double kSinksIn = 0.01;  // m
  return fitted.values.parameters.at("cloth.areal_density").value *
         fitted.scene.world.gravity.norm() / kSinksIn;
}

ModelStart SwitchOn(const FittedScene& fitted, const RankedCandidate& candidate,
                    const std::vector<Fault>& faults) {
  ModelStart start{fitted.scene.recording, fitted.config};
  for (auto& [name, setting] : start.config.parameters) {
    const ParameterSetting& found = fitted.values.parameters.at(name);
    setting.value = setting.free ? Inside(found.value, setting) : found.value;
  }
  if (candidate.summary.kind == CandidateKind::kObservation) {
    Eigen::VectorXd amounts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(faults.size()));
    for (std::size_t i = 0; i < candidate.faults.size(); ++i)
      amounts[candidate.faults[i]] = candidate.amounts[static_cast<Eigen::Index>(i)];
    start.recording = WithoutFaults(fitted.scene.recording, faults, amounts);
    return start;
  }
  for (std::size_t i = 0; i < candidate.names.size(); ++i) {
    ParameterSetting& setting = start.config.parameters.at(candidate.names[i]);
    const Parameter parameter = ParameterNamed(candidate.names[i]);
    const double amount = candidate.amounts[static_cast<Eigen::Index>(i)];
    // The amounts of logarithms are changes of them.
    const double value = parameter.scale == Scale::kLog && parameter.off > 0.0
                             ? parameter.off * std::exp(std::clamp(amount, -2.0, 2.0))
                             : amount;
    if (parameter.unit == std::string("Pa/m")) setting.lower = LeastStiffness(candidate, fitted);
    setting.value = Inside(value, setting);
    setting.free = true;
  }
  const bool is_law = candidate.term.role == Role::kLaw;  // whose middle is as good anywhere
  for (const auto& [name, value] : candidate.probe)
    if (is_law) start.config.parameters.at(name).value = value;
  if (!is_law) FreeShapes(candidate.probe, &start.config);
  return start;
}

ModelStart WithOnly(const FittedScene& before, const FittedScene& model,
                    const RankedCandidate& candidate) {
  ModelStart start = WithoutEffect(before, model);
  TakeOver(candidate, model, &start.config);
  return start;
}

ModelStart WithEffectOf(const FittedScene& model, const RankedCandidate& candidate,
                        const FittedScene& fitted) {
  ModelStart start = GoOn(fitted);
  TakeOver(candidate, model, &start.config);
  return start;
}

ModelStart FromNothing(const FitConfig& given, ModelStart start, const RankedCandidate& candidate) {
  start = WithMaterialOf(given, std::move(start));
  if (candidate.summary.kind == CandidateKind::kObservation) return start;
  for (const std::string& name : candidate.names) {
    ParameterSetting& setting = start.config.parameters.at(name);
    setting.value = std::clamp(ParameterNamed(name).initial, setting.lower, setting.upper);
  }
  return start;
}

RankedCandidate AtShares(RankedCandidate candidate) {
  std::vector<RankedCandidate::Start> starts;
  const auto add = [&](const Probe& probe, const Eigen::VectorXd& amounts) {
    for (const double share : kSharesOfEstimate) starts.push_back({probe, share * amounts});
  };
  add(candidate.probe, candidate.amounts);
  for (const RankedCandidate::Start& other : candidate.other_starts)
    add(other.probe, other.amounts);
  candidate.other_starts.assign(starts.begin() + 1, starts.end());
  return candidate;
}

ModelStart AtBestShare(const FittedScene& fitted, const ModelStart& start,
                       const RankedCandidate& candidate, const FitRunner& runner) {
  if (candidate.summary.kind == CandidateKind::kObservation) return start;
  ModelStart best = start;
  double least = std::numeric_limits<double>::infinity();
  for (const double share : kSharesOfEstimate) {
    if (runner.IsStopped()) break;
    RankedCandidate smaller = candidate;
    smaller.amounts *= share;
    ModelStart tried = start;
    const FitConfig scaled = SwitchOn(fitted, smaller, {}).config;
    for (const std::string& name : candidate.names)
      tried.config.parameters.at(name).value = scaled.parameters.at(name).value;
    const double cost = CostOf(fitted, tried);
    if (cost >= least) continue;
    least = cost;
    best = std::move(tried);
  }
  return best;
}

std::optional<FittedScene> FitFirst(const FittedScene& fitted, const ModelStart& start,
                                    const FitConfig& given, const RankedCandidate& candidate,
                                    int most_iterations, const FitRunner& runner) {
  const bool is_physics = candidate.summary.kind != CandidateKind::kObservation;
  if (is_physics && FitsWindows(fitted.scene, start.config))
    return FitAfresh(start, Start::kWindows, most_iterations, runner);
  std::optional<FittedScene> model =
      FitModel(fitted, AtBestShare(fitted, start, candidate, runner), most_iterations, runner);
  const bool is_near = model && !HasLargeResidual(model->scene, model->config, model->fit);
  if (is_near || runner.IsStopped()) return model;
  return Cheaper(std::move(model),
                 FitModel(fitted, FromNothing(given, start, candidate), most_iterations, runner));
}

}  // namespace clothfit
