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
#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"

namespace clothfit {
namespace {

constexpr std::size_t kMostContradictions = 3;  // that are put right and compared
constexpr int kMostEstimates = 5;               // of amounts, after the first
constexpr double kSettled = 0.3;                // sigmas, by which the last one differs

}  // namespace

// Its amounts are what the sources say of each other, estimated again with what was found put
// right: the cloth's own errors have no part in them.
std::optional<JudgedModel> Diagnoser::PutRight(RankedCandidate fault,
                                               const Ranking& ranking) const {
  std::vector<Fault> own;
  for (const int index : fault.faults)
    own.push_back(ranking.faults[static_cast<std::size_t>(index)]);
  BothMeshes model = now_;
  bool is_settled = false;
  for (int k = 0; k < kMostEstimates && !is_settled && !Stopped(); ++k) {
    ModelStart start = GoOn(now_.coarse);
    start.recording = WithoutFaults(start.recording, own, fault.amounts);
    std::optional<FittedScene> coarse = FitModel(now_.coarse, start, kFirstIterations, runner_);
    if (!coarse) return {};
    model.coarse = *std::move(coarse);
    const Ranking again = RankContradictions(model.coarse, options_);
    const auto same =
        std::find_if(again.candidates.begin(), again.candidates.end(),
                     [&](const auto& other) { return other.summary.name == fault.summary.name; });
    if (same == again.candidates.end()) return {};
    fault.amounts += same->amounts;
    fault.sigma = same->sigma;
    is_settled = (same->amounts.array().abs() <= kSettled * same->sigma.array()).all();
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    SetInterval(fault.amounts[index], fault.sigma[index], &fault.summary.parameters[i]);
  }
  const auto refit = [&](const FittedScene& before, int most_iterations, double tolerance) {
    ModelStart start = GoOn(before);
    start.recording = WithoutFaults(now_.fine.scene.recording, own, fault.amounts);
    return FitModel(before, start, most_iterations, runner_, tolerance);
  };
  std::optional<FittedScene> fine =
      refit(now_.fine, 2 * kModelIterations, EnoughToDecide(now_.fine.scene));
  std::optional<FittedScene> coarse = refit(model.coarse, kFirstIterations, kEnoughForDiagnosis);
  if (!fine || !coarse) return {};
  return JudgedModel{std::move(fault), {*std::move(coarse), *std::move(fine)}};
}

bool Diagnoser::AddContradiction() {
  if (Stopped() || !CanContradict(now_.coarse.scene)) return false;
  Say("comparing cameras and markers", 0.4);
  contradictions_ = RankContradictions(now_.coarse, options_);
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
  std::vector<std::optional<JudgedModel>> models(faults.size());
  ParallelFor(static_cast<int>(faults.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    if (!Stopped()) models[k] = PutRight(faults[k], ranking);
  });
  std::vector<JudgedModel> judged;
  for (std::optional<JudgedModel>& model : models)
    if (model) judged.push_back(*std::move(model));
  Spend("comparing cameras and markers");
  if (judged.empty() || Stopped()) return false;
  Judge(now_.fine, &judged);
  if (judged.front().log_evidence < kStrongEvidence) return false;
  last_ranking_.faults = ranking.faults;
  DescribeAll(judged, now_.fine);
  if (kept_.empty()) TellCandidates(ranking, ranking);
  diagnosis_.models[diagnosis_.models.size() - judged.size()].is_kept = true;
  Keep(std::move(judged), ranking);
  return true;
}

}  // namespace clothfit
