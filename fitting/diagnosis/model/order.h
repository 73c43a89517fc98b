// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of several fitted models comes first: by cost, prediction and simplicity.
#pragma once

#include <cstddef>
#include <vector>

#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "fitting/diagnosis/model/switch_on.h"

namespace clothfit {

// A candidate with what was fitted with it.
struct FittedModel {
  RankedCandidate candidate;
  FittedScene scene;
  HeldOutErrors errors;
};

inline constexpr double kNearBest = 0.9;  // of what the best gains: it may come first yet

bool IsCheaper(const FittedModel& a, const FittedModel& b);

// All of what follows: in the order of their costs, but the best prediction first, and a simpler
// twin of the first before it. `cost_before`, `before`: of the fit without any of them, whose
// ranking it is.
void PutBestFirst(double cost_before, const HeldOutErrors& before, const Ranking& ranking,
                  std::vector<FittedModel>* models);

// Of models in the order of their costs, those that explain nearly all that the first does come in
// the order of their predictions: what stands for another effect follows the frames that it was
// fitted to more easily than it foresees the others. Of those that predict about as well the one
// with the fewest unknowns is the first. What explains more with fewer unknowns comes before that
// unless it predicts clearly worse, by more than mesh and step do to a prediction (`by_mesh`, root
// mean square); the cheapest of several. `before`: of the fit without any of them.
void PutBestPredictionFirst(double cost_before, const HeldOutErrors& before, double by_mesh,
                            std::vector<FittedModel>* models);

// If the first model is physics: a model with lower cost and fewer unknowns that matches at least
// 0.95 of the first one's force along its motion (Imitate) comes before it. A gust that lasts
// throughout and acts everywhere is a wind.
void PutSimplerTwinFirst(const Extent& extent, std::vector<FittedModel>* models);

}  // namespace clothfit
