// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The candidates that are worth it, switched on one at a time and fitted against one another: a few
// iterations each, then more for those that may come first.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/model/fitted_model.h"
#include "fitting/diagnosis/model/switch_on.h"

namespace clothfit {

inline constexpr int kModelIterations = 12;  // a model starts near its end

// Of what a model gains, that it may lose without a part of it.
inline constexpr double kIdle = 0.1;

// Of what the best gains, from which a model may come first yet.
inline constexpr double kNearBest = 0.9;

class ModelScreening {
 public:
  // `baseline`: the config that a diagnosis was given, whose material parameters models begin from
  // where the fitted one leaves large residuals. Both must outlive this.
  ModelScreening(const FitConfig& baseline, const DiagnosisOptions& options)
      : baseline_(baseline), options_(options), runner_(options) {}

  // The cheapest first.
  std::vector<FittedModel> Run(const FittedScene& current, const Ranking& ranking) const;

  // The observation's faults of the short list alone, each put right.
  std::vector<FittedModel> FitFaults(const FittedScene& current, const Ranking& ranking) const;

  // What could make much of the force of the first of the models, and may so explain as much
  // itself: fitted in its place. Left out is what one of the models is
  // already and explains nearly as much. `current`: the fit without that force; `ranking`: of any
  // fit of the recording, for its candidates and faults.
  std::vector<FittedModel> FitCompetitors(const FittedScene& current, const Ranking& ranking,
                                          const std::vector<FittedModel>& models) const;

 private:
  std::vector<RankedCandidate> CandidatesToFit(const Ranking& ranking) const;
  // Fits each of them, and those further that may come first.
  std::vector<FittedModel> Screen(const FittedScene& current, const Ranking& ranking,
                                  const std::vector<RankedCandidate>& screened) const;
  using FitOne = std::function<std::optional<FittedScene>(const RankedCandidate&)>;
  std::vector<FittedModel> RunAll(const std::vector<RankedCandidate>& screened,
                                  const Ranking& ranking, const FitOne& fit_one) const;
  std::optional<FittedScene> FirstFit(const FittedScene& current, const RankedCandidate& candidate,
                                      const Ranking& ranking) const;
  void FinishModels(const FittedScene& current, double promoted_share,
                    std::vector<FittedModel>* models) const;
  std::vector<RankedCandidate> MatchingCandidates(const FittedScene& current,
                                                  const Ranking& ranking,
                                                  const std::vector<FittedModel>& models) const;
  void GoOnWith(FittedModel* model) const;
  void TakeOutIdleParts(const FittedScene& current, const Ranking& ranking,
                        FittedModel* model) const;
  void Say(const std::string& stage, double fraction) const {
    if (options_.progress) options_.progress(stage, fraction);
  }
  void Log(const std::string& line) const {
    if (options_.log) options_.log(line);
  }
  bool Stopped() const { return runner_.IsStopped(); }

  const FitConfig& baseline_;
  const DiagnosisOptions& options_;
  FitRunner runner_;
};

}  // namespace clothfit
