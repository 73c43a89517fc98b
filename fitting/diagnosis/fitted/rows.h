// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Residuals of a fitted scene and their derivatives by anything, row by row: what the score test
// and its null are made of.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/fitted/faults.h"
#include "fitting/fit/fit.h"
#include "fitting/rollout/nudging.h"
#include "fitting/rollout/shooting_windows.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {

// A fit as the diagnosis goes on from it. Every physical parameter is fixed in `values` at what was
// found.
struct FittedScene {
  Scene scene;
  FitConfig config;         // as it was fitted
  FitConfig values;         // the same with the parameters' fitted values, none of them free
  Eigen::VectorXd unknown;  // handles' and initial state's part of the free vector
  FitResult fit;
  bool of_forecasts = false;  // is it a fit to forecasts (FitForecasts), and its cost theirs?
  // Where it is looked at in forecasts, those: none where it is simulated as a whole.
  std::shared_ptr<const std::vector<LaidWindow>> forecasts = nullptr;
};
// The config must be the one that `fit` came from.
FittedScene MakeFittedScene(Scene scene, const FitConfig& config, const FitResult& fit);
// Is what such a fit ends at a motion that is pulled at, and no open loop?
bool IsNudged(const FitConfig& config);
// The same fit on another mesh or with another step; nothing is fitted again.
FittedScene WithOtherSteps(const FittedScene& fitted, const std::array<int, 2>& resolution,
                           double max_step);

// Frames whose rows are looked at, and where their rows begin.
class RowFrames {
 public:
  // All fitted frames, or every n-th of them where there were more than `most` rows.
  RowFrames(const Scene& scene, const ObservationResiduals& observations, int most);
  const std::vector<int>& frames() const { return frames_; }
  int num_rows() const { return first_row_.back(); }
  // Of a frame; -1 where its rows are not looked at.
  int FirstRow(int frame) const;
  // The frame that each row is of.
  std::vector<int> FrameOfRows() const;

 private:
  std::vector<int> frames_, first_row_;
};

// What one simulation tells.
struct Rows {
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;  // rows x free entries of the pass
  std::vector<FreeEntry> entries;
  RowMajorMatrix faults;  // rows x faults, where asked for
};

// Adds the precisions of the entries' priors to the first places of a matrix J'J's diagonal.
void AddPriors(const std::vector<FreeEntry>& entries, Eigen::MatrixXd* information);

// Which derivatives a pass takes.
struct Pass {
  FitConfig config;         // FittedScene::values with what is to be differentiated set free
  bool of_unknown = false;  // handles and initial state too
  bool of_faults = false;
};
// The free vector of a pass: its parameters' values, then what the fit found for the rest.
Eigen::VectorXd ThetaOfPass(const FreeParameters& free, const Eigen::VectorXd& unknown);
// The pass of what the fit itself had free, faults of the observation and all unknowns.
Pass BaselinePass(const FittedScene& fitted);
// Simulates once from the fit's start, pulled at where the fit is (IsNudged), or its forecasts.
// Empty where the simulation or an observation fails. observer(frame, state), where given, is
// called for all frames, fitted ones or not, up to the last that is fitted.
std::optional<Rows> EvaluateRows(
    const FittedScene& fitted, const Pass& pass, const RowFrames& frames,
    const std::vector<Fault>& faults,
    const std::function<void(int frame, const State& state)>& observer = {});

// Beyond so many rows not every frame is looked at.
inline constexpr int kMostRows = 20000;

// Residuals (rows of `frames`) where `fine` stands for the recording and the mesh of `coarse`
// predicts it: their discretisation error. Both must be of one recording.
std::optional<Eigen::VectorXd> ResidualsOfOtherSteps(const FittedScene& fine,
                                                     const FittedScene& coarse,
                                                     const RowFrames& frames);

}  // namespace clothfit
