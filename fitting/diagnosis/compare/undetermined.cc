// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/undetermined.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "fitting/diagnosis/fitted/named_parameter.h"

namespace clothfit {

std::vector<std::string> Undetermined(const std::vector<EffectParameter>& parameters) {
  std::map<std::string, std::vector<const EffectParameter*>> terms;
  for (const NamedParameter& named : MakeParameterTable()) {
    if (!SwitchesOff(named.parameter) || named.parameter.off != 0.0) continue;
    for (const EffectParameter& p : parameters)
      if (p.name == named.name) terms[named.term].push_back(&p);
  }
  const auto sureness = [](const EffectParameter* p) {
    return std::abs(p->value) / std::max(1e-300, p->upper90 - p->lower90);
  };
  std::vector<std::string> names;
  for (const auto& [term, amounts] : terms) {
    const EffectParameter* surest = *std::max_element(
        amounts.begin(), amounts.end(), [&](const EffectParameter* a, const EffectParameter* b) {
          return sureness(a) < sureness(b);
        });
    for (const EffectParameter* p : amounts) {
      const bool may_be_off = p->lower90 <= 0.0 && p->upper90 >= 0.0;
      if (p != surest && may_be_off) names.push_back(p->name);
    }
  }
  return names;
}

std::optional<FittedModel> WithoutUndetermined(const FittedModel& model, double cost_before,
                                               const std::vector<EffectParameter>& parameters,
                                               const FitRunner& runner) {
  const std::vector<std::string> names = Undetermined(parameters);
  if (names.empty() || runner.IsStopped()) return {};
  std::optional<FittedScene> scene =
      FitModel(model.scene, GoOnWithout(model.scene, names), kModelIterations, runner);
  if (!scene) return {};
  const double cost = model.scene.fit.cost_after;
  HeldOutErrors errors = MeasureHeldOut(*scene);
  const bool is_as_good = scene->fit.cost_after <= cost + kIdle * (cost_before - cost) &&
                          errors.Rms() <= kAsGood * model.errors.Rms();
  if (!is_as_good) return {};
  return FittedModel{model.candidate, std::move(*scene), std::move(errors)};
}

void TakeValues(const FitConfig& values, std::vector<EffectParameter>* parameters) {
  for (EffectParameter& p : *parameters) {
    const auto found = values.parameters.find(p.name);
    if (found == values.parameters.end()) continue;
    const double before = p.value, value = found->second.value;
    p.value = value;
    const double off = ParameterNamed(p.name).off;
    if (value == off) {  // taken out: it may be what it may have been
      p.lower90 = std::min(p.lower90, off);
      p.upper90 = std::max(p.upper90, off);
      continue;
    }
    const bool is_positive = p.lower90 > 0.0 && before > 0.0 && value > 0.0;
    for (double* end : {&p.lower90, &p.upper90})
      *end = is_positive ? *end * (value / before) : *end + (value - before);
  }
}

}  // namespace clothfit
