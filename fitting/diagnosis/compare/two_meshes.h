// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Models on two meshes: one that finds and orders them, and a finer one that decides.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fitting/diagnosis/compare/log_evidence.h"
#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

struct BothMeshes {
  FittedScene coarse, fine;
  double Cost() const { return fine.fit.cost_after; }
};

// A candidate with what was fitted with it.
struct JudgedModel {
  RankedCandidate candidate;
  BothMeshes model;
  double log_evidence = 0.0;  // for it, against the fit without it
};

// What the recording speaks for most comes first; else the order stays.
void SortByEvidence(std::vector<JudgedModel>* models);

// Takes fits from one of both meshes to the other. Where those are no grids there is but one.
class Meshes {
 public:
  explicit Meshes(const FitRunner& runner) : runner_(runner) {}

  // coarse: a fit on the coarse mesh; deciding_side: particles along the longer side of the other.
  void Set(const FittedScene& coarse, int deciding_side);

  const std::array<int, 2>& coarse() const { return coarse_; }  // particles along u and v

  // A fit of the coarse mesh gone on with on the deciding one; itself where that is no finer. Empty
  // where it fails.
  std::optional<BothMeshes> Refine(const FittedScene& coarse, int most_iterations) const;
  // The baseline's config fitted on the deciding mesh from its own start by windows; empty where
  // that mesh is no finer, where there are no windows, or where it fails.
  std::optional<FittedScene> FitFromItsOwnStart(const FittedScene& coarse,
                                                int most_iterations) const;
  // The other way round.
  std::optional<BothMeshes> Coarsen(const FittedScene& fine, int most_iterations) const;

 private:
  FitRunner runner_;
  std::array<int, 2> coarse_ = {0, 0}, fine_ = {0, 0};
};

// Particles along the longer side of the mesh that decides: as many as the config says, else as the
// recording does, but at least kCoarseSide, below which amounts come out a tenth wrong; and no more
// than `finest_side`.
int DecidingSide(const Recording& recording, const FitConfig& config, int finest_side);

// Less than noise is left beyond noise, root mean square: too little for any name.
inline constexpr double kTooLittle = 1.0;  // sigmas

// Root mean square of what is left beyond noise, sigmas.
double BeyondNoise(double chi_square);

// How far a fit meets what was observed, and how certain its parameters are.
struct FitQuality {
  FitResult result;     // as RunFit gives it, with the misfit and intervals of AppraiseFit
  ResidualScale scale;  // its chi-square is the fit's own
  double mesh = 0.0;    // root mean square of what mesh and step do, sigmas
  // No more is left than noise and mesh and step make: by the test of the misfit, or where less
  // than noise is left beyond noise and those make more.
  bool is_explained = false;

  double Unexplained() const { return BeyondNoise(scale.chi_square); }
  // Might another mesh and step make all that is left beyond noise?
  bool MayBeMesh() const { return Unexplained() < mesh; }
};

// Of a fit to forecasts, theirs; else as AppraiseQuality has it.
ResidualScale ScaleOf(const FittedScene& fitted);

// Of outlines alone, neighbours along them hang together as measured, and those of one outline for
// a fifth of a second; what mesh and step do is not known then.
FitQuality AppraiseQuality(const FittedScene& fitted);

}  // namespace clothfit
