// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/law/learn.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/law.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr std::size_t kFamiliesFitted = 2;
constexpr int kMostFamilies = 2;  // at once
constexpr int kIterations = 8;
constexpr double kWorthMore = 0.2;  // share of the cost that another family has to take away

// Coefficients of families that are free, a family after the other.
std::vector<std::string> FreeCoefficients(const FitConfig& config,
                                          const std::vector<std::string>& terms) {
  std::vector<std::string> names;
  for (const std::string& term : terms) {
    for (const NamedParameter& named : MakeParameterTable()) {
      const bool is_coefficient = named.term == term && SwitchesOff(named.parameter);
      if (is_coefficient && config.parameters.at(named.name).free) names.push_back(named.name);
    }
  }
  return names;
}

// The model without the coefficients that its intervals hold for nothing; nothing to take out:
// empty.
std::optional<ModelStart> Pruned(const FittedScene& model, const std::vector<std::string>& terms) {
  std::vector<std::string> nothing;
  for (const std::string& name : FreeCoefficients(model.config, terms)) {
    for (const ParameterEstimate& e : model.fit.estimates) {
      const bool is_something = e.lower95 > 0.0 || e.upper95 < 0.0;
      if (e.name == name && !is_something) nothing.push_back(name);
    }
  }
  if (nothing.empty()) return {};
  return GoOnWithout(model, nothing);
}

// Beside the families of `terms`, whose coefficients may come to nothing next to it.
std::optional<FittedScene> FitFamily(const FittedScene& baseline, const FitConfig& given,
                                     const RankedCandidate& family, std::vector<std::string> terms,
                                     const Ranking& ranking, const DiagnosisOptions& options) {
  const FitRunner runner(options);
  std::optional<FittedScene> model = FitFirst(baseline, SwitchOn(baseline, family, ranking.faults),
                                              given, family, kIterations, runner);
  terms.push_back(family.term.term);
  for (int round = 0; model && round < 3; ++round) {
    const std::optional<ModelStart> pruned = Pruned(*model, terms);
    if (!pruned) break;
    model = FitModel(*model, *pruned, kIterations, runner);
  }
  if (model && FreeCoefficients(model->config, {family.term.term}).empty()) return {};
  return model;
}

std::vector<RankedCandidate> FamiliesToFit(const Ranking& ranked) {
  std::vector<RankedCandidate> families;
  for (const RankedCandidate& family : ranked.candidates) {
    const bool is_law = family.summary.kind == CandidateKind::kPhysics;
    if (is_law && family.summary.is_short_listed && families.size() < kFamiliesFitted)
      families.push_back(family);
  }
  return families;
}

// "x - 0.1 m" without a sign of its own.
std::string Offset(const char* axis, double middle) {
  return middle == 0.0
             ? std::string(axis)
             : fmt::format("({} {} {:.2g} m)", axis, middle > 0.0 ? '-' : '+', std::abs(middle));
}

// The feature that a coefficient multiplies; empty for a constant.
std::string FeatureOf(const FitConfig& config, const std::string& term, const std::string& name) {
  const auto middle = [&](const char* axis) {
    return config.parameters.at(term + "." + axis).value;
  };
  if (name == "drag") return "(-v)";
  if (StartsWith(name, "g_")) {
    const std::string axis(1, name[3]);
    return Offset(axis.c_str(), middle(axis.c_str()));
  }
  if (StartsWith(name, "k_") || name.find("_k_") != std::string::npos) return "e";
  if (StartsWith(name, "m_")) return "de/dt";
  return "";
}

// What a coefficient is a part of: "w_x" of law_air.g_xy.
std::string LeftSide(const std::string& term, const std::string& name) {
  if (term == LawTension::kName) {
    const std::string angle = name.substr(name.rfind('_') + 1);
    const bool is_band = StartsWith(name, "band");
    return fmt::format("tension per width at {} degrees{}", angle,
                       is_band ? " within the band of the diagonal" : "");
  }
  if (name == "drag") return "force per area";
  const std::string axis(1, name[2]);
  return (term == LawAir::kName ? "velocity of the air along " : "force per area along ") + axis;
}

}  // namespace

std::optional<LearnedFit> LearnLaw(const FittedScene& baseline, const FitConfig& given,
                                   const Ranking& ranking, const DiagnosisOptions& options) {
  std::optional<LearnedFit> law;
  RankingStart laws{ranking.errors, CandidateSet::kLaws};
  const FitRunner runner(options);
  for (int round = 0; round < kMostFamilies && !runner.IsStopped(); ++round) {
    const FittedScene& from = law ? law->scene : baseline;
    // No more is left than where nothing is missing.
    if (law && from.fit.cost_after <= 0.5 * ranking.null_mean) break;
    const Ranking ranked = RankCandidates(from, options, laws);
    const std::vector<RankedCandidate> families = FamiliesToFit(ranked);
    const std::vector<std::string> terms = law ? law->terms : std::vector<std::string>();
    std::vector<std::optional<FittedScene>> models(families.size());
    ParallelFor(static_cast<int>(families.size()), NumThreads(0), [&](int i, int) {
      const auto k = static_cast<std::size_t>(i);
      models[k] = FitFamily(from, given, families[k], terms, ranked, options);
    });
    std::optional<FittedScene> best;
    std::string best_term;
    for (std::size_t k = 0; k < models.size(); ++k) {
      if (!models[k] || (best && models[k]->fit.cost_after >= best->fit.cost_after)) continue;
      best = std::move(models[k]);
      best_term = families[k].term.term;
    }
    const double needed = (law ? 1.0 - kWorthMore : 1.0) * from.fit.cost_after;
    if (!best || best->fit.cost_after >= needed) break;
    LearnedFit next{std::move(*best), {}, {}};
    for (const std::string& term : terms) {  // whatever is left of them
      if (!FreeCoefficients(next.scene.config, {term}).empty()) next.terms.push_back(term);
    }
    next.terms.push_back(best_term);
    next.names = FreeCoefficients(next.scene.config, next.terms);
    law = std::move(next);
  }
  return law;
}

std::string LawFormula(const LearnedFit& law, const Extent& extent) {
  std::map<std::string, std::string> sums;
  std::vector<std::string> order;
  for (const std::string& full : law.names) {
    const std::string term = full.substr(0, full.find('.')), name = full.substr(term.size() + 1);
    const double value = law.scene.values.parameters.at(full).value;
    const std::string feature = FeatureOf(law.scene.values, term, name);
    std::string& sum = sums[LeftSide(term, name)];
    if (sum.empty()) order.push_back(LeftSide(term, name));
    sum += fmt::format(
        "{}{:.3g} {}{}", sum.empty() ? (value < 0.0 ? "-" : "") : (value < 0.0 ? " - " : " + "),
        std::abs(value), ParameterNamed(full).unit, feature.empty() ? "" : " " + feature);
  }
  std::string words;
  for (const std::string& left : order)
    words += (words.empty() ? "" : "; ") + left + " = " + sums.at(left);
  return words + fmt::format(
                     " (learned for x from {:.2f} to {:.2f} m, y from {:.2f} to {:.2f} m, "
                     "z from {:.2f} to {:.2f} m)",
                     extent.low.x(), extent.high.x(), extent.low.y(), extent.high.y(),
                     extent.low.z(), extent.high.z());
}

}  // namespace clothfit
