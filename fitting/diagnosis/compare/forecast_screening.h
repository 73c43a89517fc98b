// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What is missing, by forecasts of half a second (fitting/fit/forecast_fit.h): absent terms are
// scored along them, the best are fitted to them, and so are judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/compare/two_meshes.h"
#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/options.h"
#include "fitting/diagnosis/locate/contact_shapes.h"
#include "fitting/diagnosis/model/fitted_model.h"

namespace clothfit {

struct ForecastRound {
  FittedScene before;  // the fit without, to forecasts on the mesh that models are judged on
  Ranking ranking;     // of physics, along forecasts
  std::vector<JudgedModel> judged;  // the highest evidence first; both meshes are the deciding one
};

// Are there points to nudge a motion to, and a mesh that can be refined?
bool CanForecast(const FittedScene& fitted);

class ForecastScreening {
 public:
  // `baseline`: the config that a diagnosis was given, whose material parameters fits begin from
  // where the fitted one leaves large residuals. Both must outlive this.
  ForecastScreening(const FitConfig& baseline, const DiagnosisOptions& options)
      : baseline_(baseline), options_(options), runner_(options) {}

  // `current`: the fit without, on the deciding mesh. `faults`: of the observation, that compete,
  // by the recordings that they were put right in. `contacts`: shapes of obstacles, which compete
  // too. `least_share`: of what forecasts leave beyond noise, that a model has to explain; none is
  // judged where none comes near that on the coarse mesh. Empty where there are no forecasts, or
  // where they cannot be fitted.
  std::optional<ForecastRound> Run(const FittedScene& current,
                                   const std::vector<FittedModel>& faults,
                                   const std::vector<ContactShape>& contacts,
                                   double least_share) const;

 private:
  std::vector<RankedCandidate> CandidatesToFit(const FittedScene& base, const Ranking& ranking,
                                               const std::vector<ContactShape>& contacts) const;
  // A candidate at one of its starts; those of one candidate are of one group.
  struct Attempt {
    RankedCandidate candidate;
    std::size_t group;
    std::optional<FittedScene> fit;
  };
  std::vector<RankedCandidate> StartsOf(const FittedScene& base, const Ranking& ranking,
                                        const RankedCandidate& candidate) const;
  std::optional<FittedScene> FitFirstLengths(const FittedScene& base, const Ranking& ranking,
                                             const RankedCandidate& start,
                                             int most_iterations) const;
  void AddBarThroughBall(const FittedScene& base, const Ranking& ranking,
                         std::vector<Attempt>* attempts) const;
  // nothing: the cost of the baseline in the same forecasts.
  std::vector<Attempt> GoingOn(std::vector<Attempt> attempts, double nothing) const;
  // Fits the baseline and the models that may come first on the deciding mesh; they are in order.
  // False where the baseline's fit fails.
  bool Decide(const FittedScene& current, const FittedScene& base,
              const std::vector<FittedModel>& models, ForecastRound* round) const;
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

// Log evidence of models against the fit before; sorts them by it. Costs and residuals are those of
// `before` and of the models' fits on the deciding mesh: all of forecasts, or none.
void JudgeModels(const FittedScene& before, std::vector<JudgedModel>* judged);

// What a fit to forecasts leaves beyond noise, as a cost.
double LeftByForecasts(const FittedScene& fitted);
// Of that the share that a model, fitted alike, explains.
double ShareOfForecasts(const FittedScene& before, const FittedScene& model);

}  // namespace clothfit
