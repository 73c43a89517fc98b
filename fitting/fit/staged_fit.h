// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fit by Levenberg-Marquardt as a whole: coarse, then fine, from one start or from several.
// Behind RunFit and FitByStrategy; nothing else includes it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fitting/fit/fitter.h"

namespace clothfit {

class StagedFit {
 public:
  // The arguments must outlive this object.
  StagedFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks);

  // Where the first fit leaves more than noise may, others begin from OtherStarts, with the paths
  // and the initial state that it found, side by side; the best of them go on, and on, and what
  // ends lowest is the result.
  void BeginFromOthers() { has_others_ = true; }
  void TellMisfit() { tells_misfit_ = true; }

  FitResult Run(const FitCheckpoint* resume);

 private:
  // One fit. The best of those under way speaks for all.
  struct Chain {
    Chain(const Scene& scene, const FitConfig& config, FitCallbacks own)
        : callbacks(std::move(own)), fitter(scene, config, callbacks) {}
    FitCallbacks callbacks;
    Fitter fitter;
  };
  using Chains = std::vector<std::unique_ptr<Chain>>;
  // Where fits under way stand, as progress and log tell it.
  struct Stage {
    std::string name;                 // that lines begin with
    double begin = 0.0, share = 1.0;  // of the whole
    bool is_coarse = false;
  };

  bool Stopped() const { return callbacks_.stop != nullptr && *callbacks_.stop; }
  std::unique_ptr<Chain> MakeChain(const Scene& scene, const FitConfig& config,
                                   const std::string& name) const;
  void LetSpeak(const Stage& stage, Chain* chain) const;
  // Free vectors with another material each.
  std::vector<Eigen::VectorXd> OtherThetas(const Scene& scene, const FitConfig& config,
                                           const Eigen::VectorXd& theta) const;
  // Fits from others where the first, which has ended, leaves more than noise may; added behind it.
  void AddOthers(const Scene& scene, const FitConfig& config, int most_iterations,
                 const Stage& stage, Chains* chains);
  // All of them, side by side, up to so many iterations of each.
  void Advance(const Chains& chains, int most_iterations) const;
  // All of them to the end, side by side.
  void Race(const Stage& stage, Chains* chains);
  // The best, at most kFollowed of them, and none that costs more than kNearly times the least.
  void KeepBest(Chains* chains);
  // Free vectors that the coarse fits found, the best first. Beside them the fine one measures its
  // start.
  std::vector<Eigen::VectorXd> FitCoarse(const FitConfig& coarser, const FitCheckpoint* resume,
                                         Chain* fine, FitResult* before);
  void CountAgreeing(const Chains& chains, FitResult* result) const;

  const Scene& scene_;
  const FitConfig& config_;
  const FitCallbacks& callbacks_;
  bool has_others_ = false, tells_misfit_ = false;
  FitStarts starts_;
  FitResult work_;  // of fits that are no more
  mutable std::mutex mutex_;
};

}  // namespace clothfit
