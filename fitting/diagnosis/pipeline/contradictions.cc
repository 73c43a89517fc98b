// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Rounds by what cameras and markers say against each other: faults that show whatever the cloth
// does, before it is asked what it lacks.
#include "fitting/diagnosis/rank/contradictions.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/compare/log_evidence.h"
#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"

namespace clothfit {
namespace {

// Contradictions have power to spare: one clean recording in a thousand.
constexpr double kFalseDiscovery = 1e-3;
constexpr std::size_t kMostContradictions = 5;  // that are put right and compared
constexpr int kMostEstimates = 5;               // of amounts, after the first
constexpr double kSettled = 0.3;                // sigmas, by which the last one differs

// Half the sum of squares that sources leave whatever the cloth does.
double CostOf(const Ranking& contradictions) {
  return 0.5 * contradictions.residual_rms * contradictions.residual_rms * contradictions.num_rows;
}

std::vector<Fault> FaultsOf(const RankedCandidate& candidate, const Ranking& ranking) {
  std::vector<Fault> faults;
  for (const int index : candidate.faults)
    faults.push_back(ranking.faults[static_cast<std::size_t>(index)]);
  return faults;
}

}  // namespace

// What sources say of each other along the same motion, with the fault put right.
std::optional<Ranking> Diagnoser::CompareWithout(const RankedCandidate& fault,
                                                 const Ranking& ranking) const {
  ModelStart start = GoOn(now_.coarse);
  start.recording = WithoutFaults(start.recording, FaultsOf(fault, ranking), fault.amounts);
  const std::optional<FittedScene> as_it_is = FitModel(now_.coarse, start, 0, runner_);
  if (!as_it_is) return {};
  return RankContradictions(*as_it_is, options_);
}

// Its amounts are what the sources say of each other, estimated again until they settle, and so is
// the evidence for it.
std::optional<Diagnoser::Contradiction> Diagnoser::Settle(RankedCandidate fault,
                                                          const Ranking& ranking) const {
  std::optional<Ranking> without;
  for (int k = 0; k <= kMostEstimates; ++k) {
    without = CompareWithout(fault, ranking);
    if (!without || Stopped()) return {};
    const auto same =
        std::find_if(without->candidates.begin(), without->candidates.end(),
                     [&](const auto& other) { return other.summary.name == fault.summary.name; });
    if (same == without->candidates.end()) return {};
    fault.sigma = same->sigma;
    const bool is_settled = (same->amounts.array().abs() <= kSettled * same->sigma.array()).all();
    if (is_settled || k == kMostEstimates) break;
    fault.amounts += same->amounts;
  }
  for (std::size_t i = 0; i < fault.faults.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    SetInterval(fault.amounts[index], fault.sigma[index], &fault.summary.parameters[i]);
  }
  ResidualScale scale;
  scale.rows = without->num_rows;
  scale.chi_square = without->residual_rms * without->residual_rms;
  const double evidence = LogEvidence(CostOf(ranking), CostOf(*without),
                                      static_cast<double>(fault.faults.size()), scale);
  return Contradiction{std::move(fault), evidence};
}

std::optional<JudgedModel> Diagnoser::PutRight(const Contradiction& found,
                                               const Ranking& ranking) const {
  const auto refit = [&](const FittedScene& before, double tolerance) {
    ModelStart start = GoOn(before);
    start.recording =
        WithoutFaults(start.recording, FaultsOf(found.fault, ranking), found.fault.amounts);
    return FitModel(before, start, 2 * kModelIterations, runner_, tolerance);
  };
  std::optional<FittedScene> fine = refit(now_.fine, EnoughToDecide(now_.fine.scene));
  std::optional<FittedScene> coarse = refit(now_.coarse, kEnoughForDiagnosis);
  if (!fine || !coarse) return {};
  return JudgedModel{found.fault, {*std::move(coarse), *std::move(fine)}, found.log_evidence};
}

bool Diagnoser::AddContradiction() {
  if (Stopped() || !CanContradict(now_.coarse.scene)) return false;
  Say("comparing cameras and markers", 0.4);
  DiagnosisOptions strict = options_;
  strict.false_discovery = std::min(strict.false_discovery, kFalseDiscovery);
  contradictions_ = RankContradictions(now_.coarse, strict);
  const Ranking& ranking = contradictions_;
  if (!ranking.candidates.empty()) {
    const Candidate& first = ranking.candidates.front().summary;
    Log(
        fmt::format("cameras and markers agree within {:.3g} sigmas, whatever the cloth does; p = "
                    "{:.2g} of {}",
                    ranking.residual_rms, first.p_value, first.name));
  }
  std::vector<RankedCandidate> faults;
  for (const RankedCandidate& candidate : ranking.candidates) {
    if (candidate.summary.is_short_listed && faults.size() < kMostContradictions)
      faults.push_back(candidate);
  }
  std::vector<std::optional<Contradiction>> settled(faults.size());
  ParallelFor(static_cast<int>(faults.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    settled[k] = Settle(faults[k], ranking);
  });
  double best = kStrongEvidence;
  for (const std::optional<Contradiction>& one : settled) {
    if (!one) continue;
    Log(fmt::format("with {} put right: log evidence {:.4g}, by what they leave of each other",
                    one->fault.summary.name, one->log_evidence));
    best = std::max(best, one->log_evidence);
  }
  std::vector<JudgedModel> judged;
  for (const std::optional<Contradiction>& one : settled) {
    if (!one || one->log_evidence < std::max(kStrongEvidence, best - kStrongEvidence)) continue;
    if (std::optional<JudgedModel> model = PutRight(*one, ranking))
      judged.push_back(*std::move(model));
  }
  Spend("comparing cameras and markers");
  if (judged.empty() || Stopped()) return false;
  SortByEvidence(&judged);
  last_ranking_.faults = ranking.faults;
  DescribeAll(judged, now_.fine);
  if (kept_.empty()) TellCandidates(ranking, ranking);
  diagnosis_.models[diagnosis_.models.size() - judged.size()].is_kept = true;
  Keep(std::move(judged), ranking);
  return true;
}

}  // namespace clothfit
