// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/modelling.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/parameter_table.h"

namespace clothfit {
namespace {

// Keeps an estimate inside, off the bounds themselves so that a logarithm can move it.
double Inside(double value, const ParameterSetting& setting) {
  return std::clamp(value, setting.lower, setting.upper);
}

// The shapes of a term that a fit may move once it is on.
void FreeShapes(const Probe& probe, FitConfig* config) {
  for (const auto& [name, value] : probe) {
    ParameterSetting& setting = config->parameters.at(name);
    setting.value = setting.prior = Inside(value, setting);
    setting.free = true;
  }
}

}  // namespace

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
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (std::size_t i = 0; i < candidate.names.size(); ++i) {
    ParameterSetting& setting = start.config.parameters.at(candidate.names[i]);
    const Parameter& parameter = table[FindParameter(table, candidate.names[i])].parameter;
    const double amount = candidate.amounts[static_cast<Eigen::Index>(i)];
    // The amounts of logarithms are changes of them.
    const double value = parameter.scale == Scale::kLog && parameter.off > 0.0
                             ? parameter.off * std::exp(std::clamp(amount, -2.0, 2.0))
                             : amount;
    setting.value = Inside(value, setting);
    setting.free = true;
  }
  const bool is_law = IsLaw(candidate.term.term);  // whose middle is as good anywhere
  for (const auto& [name, value] : candidate.probe)
    if (is_law) start.config.parameters.at(name).value = value;
  if (!is_law) FreeShapes(candidate.probe, &start.config);
  return start;
}

ModelStart GoOn(const FittedScene& model) {
  ModelStart start{model.scene.recording, model.config};
  for (auto& [name, setting] : start.config.parameters)
    setting.value = model.values.parameters.at(name).value;
  return start;
}

ModelStart WithoutEffect(const FittedScene& before, const FittedScene& model) {
  ModelStart start = GoOn(before);
  for (auto& [name, setting] : start.config.parameters) {
    if (setting.free) setting.value = Inside(model.values.parameters.at(name).value, setting);
  }
  return start;
}

std::optional<FittedScene> FitModel(const FittedScene& fitted, const ModelStart& start,
                                    int most_iterations, const std::atomic<bool>* stop) {
  FitConfig config = start.config;
  config.coarse_resolution = 0;  // it begins where the last fit ended
  config.window = 0.0;
  config.max_iterations = std::min(config.max_iterations, most_iterations);
  config.function_tolerance = std::max(config.function_tolerance, kEnoughForDiagnosis);
  Scene scene = MakeScene(start.recording, config, &fitted.scene);
  FitCallbacks callbacks;
  callbacks.stop = stop;
  // Handles and initial state go on from where they were; they follow the parameters.
  const FreeParameters free(config, scene, MakeParameterTable());
  FitCheckpoint from;
  from.next_window = 1;
  from.theta = free.start();
  from.theta.tail(fitted.unknown.size()) = fitted.unknown;
  from.information = free.PriorInformation();
  from.mean = free.PriorMean();
  const FitResult result = RunFit(scene, config, callbacks, &from);
  if (result.status == FitStatus::kFailed || !std::isfinite(result.cost_after)) return std::nullopt;
  config.max_iterations = start.config.max_iterations;
  config.function_tolerance = start.config.function_tolerance;
  return MakeFittedScene(std::move(scene), config, result);
}

}  // namespace clothfit
