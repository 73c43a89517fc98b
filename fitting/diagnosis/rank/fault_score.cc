// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/fault_score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fitting/diagnosis/rank/short_list.h"

namespace clothfit {

double ShareOf(double score, double left) { return left > 0.0 ? std::min(1.0, score / left) : 0.0; }

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         std::max(1.0, static_cast<double>(values.size()));
}

std::vector<double> LeftByNulls(const Projection& projection,
                                const std::vector<NullResidual>& nulls) {
  std::vector<double> left;
  for (const NullResidual& null : nulls)
    left.push_back(projection.Product(null.squared, null.products, null.products));
  return left;
}

void JudgeAgainstNull(const Projection& projection, const Eigen::VectorXd& scale,
                      const std::vector<double>& null_scores, RankedCandidate* candidate) {
  Candidate& summary = candidate->summary;
  if (null_scores.empty()) {
    summary.p_value = TailProbability({}, 0.0);
    return;
  }
  const Eigen::VectorXd scaled_amounts =
      candidate->amounts.cwiseQuotient(scale(candidate->columns));
  const double information = scaled_amounts.dot(
      projection.gram()(candidate->columns, candidate->columns) * scaled_amounts);
  summary.p_value = TailProbability(null_scores, summary.score);
  std::vector<double> sorted = null_scores;
  std::sort(sorted.begin(), sorted.end());
  const double passes = sorted[sorted.size() * 19 / 20];
  if (information > 0.0)
    summary.detection_limit = candidate->amounts.norm() * std::sqrt(passes / information);
}

std::vector<Nuisance> OtherFaults(const std::vector<Fault>& faults, const std::string& group,
                                  int first_fault, const Eigen::VectorXd& scale,
                                  bool are_well_made) {
  std::vector<Nuisance> nuisances;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Fault& fault = faults[i];
    if (fault.group == group) continue;
    const int column = first_fault + static_cast<int>(i);
    const double sigma =
        are_well_made ? std::min(fault.tolerated, kWellMade * fault.typical) : fault.tolerated;
    nuisances.push_back({column, std::pow(scale[column] / sigma, 2)});
  }
  return nuisances;
}

RankedCandidate ScoreFaults(const FaultProducts& products, const std::string& group,
                            const std::vector<Nuisance>& nuisances) {
  RankedCandidate ranked;
  ranked.summary.name = group;
  ranked.summary.kind = CandidateKind::kObservation;
  ScoredGroup scored;
  for (std::size_t i = 0; i < products.faults.size(); ++i) {
    const Fault& fault = products.faults[i];
    if (fault.group != group) continue;
    ranked.faults.push_back(static_cast<int>(i));
    ranked.names.push_back(fault.name);
    const int column = products.first_fault + static_cast<int>(i);
    scored.columns.push_back(column);
    scored.is_one_sided.push_back(false);
    const double sigma = LargestSigma(fault) / products.scale[column];
    scored.precision.push_back(1.0 / (sigma * sigma));
  }
  const Projection projection(products.gram, nuisances), raw(products.gram, {});
  const Scorer scorer(projection, scored);
  const int residual = products.residual;
  const Score score = scorer.Of(projection.gram().col(residual));
  const double residual2 = products.scale[residual] * products.scale[residual];
  ranked.summary.score = score.decrease / residual2;
  ranked.summary.raw_score = ScoreOf(raw, scored, raw.gram().col(residual)).decrease / residual2;
  ranked.amounts =
      score.amounts.cwiseProduct(products.scale(scored.columns)) / products.scale[residual];
  ranked.sigma = score.sigma.cwiseProduct(products.scale(scored.columns));
  ranked.columns = scored.columns;
  std::vector<double> null_scores;
  for (const NullResidual& null : products.nulls)
    null_scores.push_back(scorer.Of(projection.Products(null.products)).decrease);
  const double left = projection.gram()(residual, residual) / residual2 - products.null_mean;
  JudgeAgainstNull(projection, products.scale, null_scores, &ranked);
  ranked.summary.share = ShareOf(ranked.summary.score, std::max(left, ranked.summary.score));
  return ranked;
}

}  // namespace clothfit
