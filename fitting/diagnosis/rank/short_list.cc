// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/short_list.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/diagnosis/gate/gate.h"

namespace clothfit {
namespace {

constexpr double kStandsOut = 2.0;         // detection limits
constexpr double kShareOfOutlines = 0.01;  // of the sum of squares that they leave

bool IsFault(const RankedCandidate& candidate) {
  return candidate.summary.kind == CandidateKind::kObservation;
}

const Fault& FaultOf(const RankedCandidate& candidate, std::size_t k, const Ranking& ranking) {
  return ranking.faults[static_cast<std::size_t>(candidate.faults[k])];
}

// Is any of a fault's amounts larger than well-made recordings have it?
bool IsBeyondWellMade(const RankedCandidate& candidate, const Ranking& ranking) {
  for (std::size_t k = 0; k < candidate.faults.size(); ++k) {
    const double amount = std::abs(candidate.amounts[static_cast<Eigen::Index>(k)]);
    if (amount > kWellMade * FaultOf(candidate, k, ranking).typical) return true;
  }
  return false;
}

std::vector<EffectParameter> ParametersOf(const RankedCandidate& candidate,
                                          const Ranking& ranking) {
  std::vector<EffectParameter> parameters;
  for (std::size_t k = 0; k < candidate.names.size(); ++k) {
    const auto index = static_cast<Eigen::Index>(k);
    const std::string unit = IsFault(candidate) ? FaultOf(candidate, k, ranking).unit
                                                : ParameterNamed(candidate.names[k]).unit;
    parameters.push_back({candidate.names[k], unit});
    SetInterval(candidate.amounts[index], candidate.sigma[index], &parameters.back());
  }
  return parameters;
}

// Empty where it is worth a fit.
std::string WhyNot(const RankedCandidate& candidate, bool has_points, bool may_be_mesh,
                   const DiagnosisOptions& options, const Ranking& ranking) {
  const Candidate& summary = candidate.summary;
  const double left = ranking.residual_rms * ranking.residual_rms * ranking.num_rows;
  if (summary.q_value > options.false_discovery)
    return fmt::format("the null does as much with p = {:.2g}", summary.p_value);
  // A fit in a local minimum errs by more, and otherwise, than the null tells.
  if (ranking.residual_rms > kLargeResidual && IsFault(candidate) && !candidate.Exceeds(kStandsOut))
    return "the fit leaves large residuals, and it does not stand out of the null";
  if (may_be_mesh && !IsFault(candidate)) return "mesh and step may make all that is left";
  if (IsFault(candidate) && !IsBeyondWellMade(candidate, ranking))
    return "no larger than in well-made recordings";
  if (IsFault(candidate) && !has_points && summary.score < kShareOfOutlines * left)
    return fmt::format("explains {:.2g} % of what outlines alone leave",
                       100.0 * summary.score / left);
  if (summary.share < options.least_share)
    return fmt::format("explains {:.0f} % of it", 100.0 * summary.share);
  return "";
}

}  // namespace

void ShortList(bool has_points, const DiagnosisOptions& options, Ranking* ranking) {
  std::vector<double> p_values;
  for (const RankedCandidate& c : ranking->candidates) p_values.push_back(c.summary.p_value);
  const std::vector<double> rates = FalseDiscoveryRates(p_values);
  // Of outlines alone no model is validated against the discretisation error: the residual has to
  // be larger.
  const bool may_be_mesh = !has_points && ranking->gate_p_value >= kGate;
  double of_fault = HUGE_VAL;  // the lowest score of a fault that is short-listed
  for (std::size_t i = 0; i < ranking->candidates.size(); ++i) {
    RankedCandidate& candidate = ranking->candidates[i];
    Candidate& summary = candidate.summary;
    summary.q_value = rates[i];
    summary.parameters = ParametersOf(candidate, *ranking);
    summary.why_not = WhyNot(candidate, has_points, may_be_mesh, options, *ranking);
    summary.is_short_listed = summary.why_not.empty();
    if (summary.is_short_listed && IsFault(candidate)) of_fault = std::min(of_fault, summary.score);
  }
  // No fault is blamed for want of an alternative.
  for (RankedCandidate& candidate : ranking->candidates) {
    Candidate& summary = candidate.summary;
    const bool competes = !IsFault(candidate) && !may_be_mesh && summary.score > of_fault;
    if (!competes || summary.q_value > options.false_discovery) continue;
    summary.is_short_listed = true;
    summary.why_not.clear();
  }
}

}  // namespace clothfit
