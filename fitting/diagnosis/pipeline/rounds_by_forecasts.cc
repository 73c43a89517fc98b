// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Rounds by forecasts: how an effect is found and decided upon where there are points.
#include <algorithm>
#include <array>
#include <future>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/compare/forecast_screening.h"
#include "fitting/diagnosis/compare/order_by_all_frames.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"

namespace clothfit {
namespace {

// Other equations than the recorded cloth's leave something of which one of sixty terms always
// takes a part; what is missing takes most. In between: docs/adr/0017.
constexpr double kLeastShareBeside = 0.4;  // of an effect beside another one
// The order is that of all frames where forecasts leave it in doubt: of what the best gains, and
// times what it leaves beyond noise.
constexpr double kGainInDoubt = 0.8, kLeftInDoubt = 2.0;
// By which models are compared that begin near their minimum, each by as many.
constexpr int kWholeIterations = 6;

bool Follows(const FittedScene& fitted) {
  return !HasLargeResidual(fitted.scene, fitted.config, fitted.fit);
}

}  // namespace

std::optional<bool> Diagnoser::AddByForecasts(const Ranking& ranking) {
  const ForecastScreening screening(baseline_, options_);
  const std::vector<FittedModel> faults =
      ModelScreening(baseline_, options_).FitFaults(now_.coarse, ranking);
  Spend("fitting faults");
  const double least_share = HasPhysics() ? kLeastShareBeside : options_.least_share;
  std::optional<ForecastRound> round = screening.Run(now_.fine, faults, contacts_, least_share);
  Spend("forecasts");
  if (!round) return {};
  if (kept_.empty()) TellCandidates(round->ranking, ranking);
  if (!HasPhysics()) forecasts_lack_ = LeftByForecasts(round->before);
  std::vector<JudgedModel> judged = std::move(round->judged);
  Judge(round->before, &judged);
  if (judged.empty() || Stopped()) return false;
  const double share = ShareOfForecasts(round->before, judged.front().model.fine);
  const bool may_explain = share >= least_share;
  std::vector<JudgedModel> whole;
  if (may_explain) {
    whole = FitWhole(round->before, judged);
    if (whole.empty()) return false;
    SettleContradiction(judged.front(), &whole);
    // Over half a second another mesh makes less than over all frames.
    const bool decide = Follows(whole.front().model.fine) && !quality_->MayBeMesh();
    OrderByAllFrames(whole, decide, &judged);
  }
  DescribeAll(judged, round->before);
  if (!may_explain) {
    Log(fmt::format("{} explains {:.2g} % of what forecasts leave: no explanation",
                    judged.front().candidate.summary.name, 100.0 * share));
    return false;
  }
  if (!IsBorneOut(judged.front(), whole)) return false;
  diagnosis_.models[diagnosis_.models.size() - judged.size()].is_kept = true;
  forecasts_left_ = LeftByForecasts(judged.front().model.fine);
  ForgetContacts(judged.front().candidate);
  Keep(std::move(judged), ranking);
  return true;
}

// What the shapes of contacts were found for is one obstacle.
void Diagnoser::ForgetContacts(const RankedCandidate& kept) {
  const bool is_obstacle =
      std::any_of(contacts_.begin(), contacts_.end(),
                  [&](const ContactShape& shape) { return shape.term == kept.term.name; });
  if (is_obstacle) contacts_.clear();
}

// The models of forecasts, the best first, fitted to all frames, the others where forecasts leave
// the order in doubt. Beyond the second only where the best follows the recording to its end, since
// what has lost it says nothing of their order.
std::vector<JudgedModel> Diagnoser::FitWhole(const FittedScene& before,
                                             const std::vector<JudgedModel>& forecasts) {
  Say("fitting all frames", 0.75);
  const double cost = before.fit.cost_after, best = forecasts.front().model.Cost();
  const double left = LeftByForecasts(forecasts.front().model.fine);
  const double doubtful =
      std::min(cost - kGainInDoubt * (cost - best), best + (kLeftInDoubt - 1.0) * left);
  std::vector<std::optional<FittedScene>> fits(forecasts.size());
  const auto fit = [&](std::size_t k) {
    if (!Stopped() && forecasts[k].model.Cost() <= doubtful)
      fits[k] = FitToAllFrames(baseline_, now_.fine, forecasts[k].model.fine, meshes_.coarse(),
                               kWholeIterations, runner_);
  };
  // One simulation does not fill two cores.
  const auto fit_some = [&](std::size_t first, std::size_t end) {
    ParallelFor(static_cast<int>(end - first), NumThreads(0),
                [&](int i, int) { fit(first + static_cast<std::size_t>(i)); });
  };
  const std::size_t at_once = std::min<std::size_t>(2, fits.size());
  fit_some(0, at_once);
  if (fits[0] && Follows(*fits[0])) fit_some(at_once, fits.size());
  std::vector<JudgedModel> whole;
  if (Stopped()) return whole;
  for (std::size_t k = 0; k < fits.size(); ++k)
    if (fits[k]) whole.push_back({forecasts[k].candidate, {*fits[k], *fits[k]}});
  Judge(now_.fine, &whole);
  Spend("fitting all frames");
  return whole;
}

// Where all frames prefer another model than forecasts do, a few iterations do not tell which of
// the two is nearer to its minimum: both are fitted to their end.
void Diagnoser::SettleContradiction(const JudgedModel& best_of_forecasts,
                                    std::vector<JudgedModel>* whole) {
  if (IsSame(whole->front(), best_of_forecasts)) return;
  const auto other = std::find_if(whole->begin(), whole->end(), [&](const JudgedModel& one) {
    return IsSame(one, best_of_forecasts);
  });
  if (other == whole->end()) return;
  const std::array<JudgedModel*, 2> both = {&whole->front(), &*other};
  ParallelFor(2, NumThreads(0), [&](int i, int) {
    FittedScene& fine = both[static_cast<std::size_t>(i)]->model.fine;
    fine = FitToEnd(fine, 1);
  });
  Judge(now_.fine, whole);
  Spend("fitting all frames");
}

// Both have to speak for it: forecasts begin where the recorded cloth is said to have been, which
// may be wrong alike in all of them.
bool Diagnoser::IsBorneOut(const JudgedModel& best, const std::vector<JudgedModel>& whole) const {
  const JudgedModel* const same = Named(best, whole);
  return best.log_evidence >= kStrongEvidence && same != nullptr &&
         same->log_evidence >= kStrongEvidence && !PredictsWorse(*same);
}

// Of all frames. What has lost the recorded motion comes to no minimum, however far it is fitted:
// that is asked after `at_least` times.
FittedScene Diagnoser::FitToEnd(FittedScene fine, int at_least) const {
  constexpr int kMostTimes = 3;
  for (int times = 0; times < kMostTimes; ++times) {
    const bool may_gain = fine.fit.status != FitStatus::kConverged && !Stopped() &&
                          (times < at_least || Follows(fine));
    if (!may_gain) break;
    std::optional<FittedScene> next =
        FitModel(fine, GoOn(fine), kModelIterations, runner_, EnoughToDecide(fine.scene));
    if (!next || next->fit.cost_after >= fine.fit.cost_after) break;
    fine = *std::move(next);
  }
  return fine;
}

void Diagnoser::GoOnBeyondForecasts() {
  Say("fitting all frames", 0.75);
  std::optional<FittedScene> fine = FitToAllFrames(baseline_, kept_.back().before.fine, now_.fine,
                                                   meshes_.coarse(), kWholeIterations, runner_);
  if (fine) fine = FitToEnd(*std::move(fine), 0);
  if (fine && !Stopped()) {
    // One simulation does not fill two cores.
    std::future<FitQuality> appraising =
        std::async(std::launch::async, [&] { return AppraiseQuality(*fine); });
    std::optional<BothMeshes> both = meshes_.Coarsen(*fine, kModelIterations);
    FitQuality quality = appraising.get();
    if (both) {
      now_ = *std::move(both);
      quality_ = std::move(quality);
    }
  }
  Spend("fitting what was kept to all frames");
}

}  // namespace clothfit
