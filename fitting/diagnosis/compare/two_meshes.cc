// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/two_meshes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fitting/diagnosis/fitted/refit.h"
#include "fitting/diagnosis/gate/baseline_fit.h"
#include "fitting/fit/discretisation.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

// Gone on with on a grid, where the fit has another; itself where not. Outlines alone, which no
// windows lead, go by a grid between the two where the other one is much finer: the first
// iterations, which gain most, cost less there.
std::optional<FittedScene> FitOn(const std::array<int, 2>& grid, const FittedScene& fitted,
                                 int most_iterations, const FitRunner& runner) {
  if (!fitted.scene.mesh.is_grid() || fitted.scene.mesh.grid == grid) return fitted;
  const double from =
      *std::max_element(fitted.scene.mesh.grid.begin(), fitted.scene.mesh.grid.end());
  const double to = *std::max_element(grid.begin(), grid.end());
  if (!HasPoints(fitted.scene) && to >= 2.0 * from) {
    const int side = static_cast<int>(std::lround(std::sqrt(from * to)));
    const std::optional<FittedScene> between =
        FitOn(GridWithSide(grid, side), fitted, most_iterations / 2, runner);
    if (between) return FitOn(grid, *between, most_iterations, runner);
  }
  return FitOnGrid(grid, fitted, most_iterations, runner);
}

// Rows of outlines that say as much as one.
double CorrelationOfOutlines(const FittedScene& fitted) {
  const ObservationResiduals observations(fitted.scene, fitted.config);
  const RowFrames frames(fitted.scene, observations, kMostRows);
  const std::optional<Rows> rows = EvaluateRows(fitted, {fitted.values, false, false}, frames, {});
  if (!rows) return 1.0;
  std::vector<std::vector<double>> outlines;
  for (const int frame : frames.frames()) {
    int source = -1;
    const std::vector<ResidualSource> sources = SourcesOfFrame(fitted.scene, frame);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (i == 0 || sources[i].source != source) outlines.emplace_back();
      source = sources[i].source;
      outlines.back().push_back(rows->residuals[frames.FirstRow(frame) + static_cast<int>(i)]);
    }
  }
  return OutlineCorrelation(outlines, fitted.scene.recording.frame_rate);
}

}  // namespace

int DecidingSide(const Recording& recording, const FitConfig& config, int finest_side) {
  const std::array<int, 2>& told = config.resolution;
  const int side =
      told[0] > 0 ? LongerSide(told) : std::max(kCoarseSide, recording.cloth.resolution.maxCoeff());
  return std::min(side, finest_side);
}

void Meshes::Set(const FittedScene& coarse, int deciding_side) {
  if (!coarse.scene.mesh.is_grid()) return;
  coarse_ = coarse.scene.mesh.grid;
  fine_ = GridWithSide(coarse_, deciding_side);
}

void SortByEvidence(std::vector<JudgedModel>* models) {
  std::stable_sort(models->begin(), models->end(), [](const JudgedModel& a, const JudgedModel& b) {
    return a.log_evidence > b.log_evidence;
  });
}

std::optional<BothMeshes> Meshes::Refine(const FittedScene& coarse, int most_iterations) const {
  std::optional<FittedScene> fine = FitOn(fine_, coarse, most_iterations, runner_);
  if (!fine) return {};
  return BothMeshes{coarse, std::move(*fine)};
}

std::optional<FittedScene> Meshes::FitFromItsOwnStart(const FittedScene& coarse,
                                                      int most_iterations) const {
  if (!coarse.scene.mesh.is_grid() || coarse_ == fine_) return {};
  ModelStart start{coarse.scene.recording, coarse.config};
  start.config.resolution = fine_;
  return FitAfresh(start, Start::kWindows, most_iterations, runner_, EnoughToDecide(coarse.scene));
}

std::optional<BothMeshes> Meshes::Coarsen(const FittedScene& fine, int most_iterations) const {
  std::optional<FittedScene> coarse = FitOn(coarse_, fine, most_iterations, runner_);
  if (!coarse) return {};
  return BothMeshes{std::move(*coarse), fine};
}

double BeyondNoise(double chi_square) { return std::sqrt(std::max(0.0, chi_square - 1.0)); }

ResidualScale ScaleOf(const FittedScene& fitted) {
  const std::optional<Misfit> misfit =
      fitted.of_forecasts ? fitted.fit.misfit
                          : MisfitOfPoints(fitted.scene, fitted.config, fitted.fit.theta);
  if (!misfit) return AppraiseQuality(fitted).scale;
  return {static_cast<double>(misfit->observed), misfit->correlation, misfit->chi_square};
}

FitQuality AppraiseQuality(const FittedScene& fitted) {
  FitQuality quality;
  quality.result = AppraiseFit(fitted.scene, fitted.config, fitted.fit.theta);
  if (const std::optional<Misfit>& misfit = quality.result.misfit) {
    quality.scale = {static_cast<double>(misfit->observed), misfit->correlation,
                     misfit->chi_square};
    quality.mesh = misfit->discretisation.value_or(0.0);
    const bool is_little = quality.Unexplained() < kTooLittle;
    quality.is_explained = misfit->IsNoiseAndMesh() || (is_little && quality.MayBeMesh());
    return quality;
  }
  const ObservationResiduals observations(fitted.scene, fitted.config);
  const double rows = observations.NumObserved(0, fitted.scene.last_fitted_frame);
  quality.scale = {rows, CorrelationOfOutlines(fitted),
                   2.0 * quality.result.cost_after / std::max(1.0, rows)};
  return quality;
}

}  // namespace clothfit
