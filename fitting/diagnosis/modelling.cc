// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/modelling.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/parameter_table.h"

namespace clothfit {
namespace {

// A model starts near its end.
constexpr int kMostIterations = 12;

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
  FreeShapes(candidate.probe, &start.config);
  return start;
}

std::optional<FittedScene> FitModel(const FittedScene& fitted, const ModelStart& start,
                                    const std::atomic<bool>* stop) {
  FitConfig config = start.config;
  config.coarse_resolution = 0;  // it begins where the last fit ended
  config.window = 0.0;
  config.max_iterations = std::min(config.max_iterations, kMostIterations);
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
  return MakeFittedScene(std::move(scene), config, result);
}

}  // namespace clothfit
