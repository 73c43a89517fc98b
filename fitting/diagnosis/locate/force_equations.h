// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The normal equations of a missing force, summed up frame by frame. Behind
// EstimateMissingForce; nothing else includes it.
#pragma once

#include <optional>
#include <vector>

#include "fitting/diagnosis/locate/forced_motion.h"
#include "fitting/diagnosis/locate/residual_force.h"

namespace clothfit {

// Where the unknowns stand: the free vector, amounts of faults, the force.
struct ForceUnknowns {
  Eigen::VectorXd theta, faults, force;
};

// Sums over the rows of some frames; columns are free entries, faults, controls.
struct NormalSums {
  Eigen::MatrixXd information;  // lower triangle
  Eigen::MatrixXd data;         // J'residuals, then J'null for each null
  double sum = 0.0;             // of the squared residuals
  double rows = 0.0;            // observed coordinates
};

class ForceEquations {
 public:
  // The arguments must outlive this object.
  ForceEquations(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                 const ForceLayout& layout, const ResidualForceOptions& options);

  int last_frame() const { return frames_.back(); }
  int num_rows() const { return num_rows_; }  // of all frames that are used
  // One simulation with derivatives. Nothing where it or an observation fails. `by_source`, where
  // asked for, gets the sums of the markers and of each camera (empty where it saw nothing).
  std::optional<NormalSums> Linearise(const ForceUnknowns& at,
                                      std::vector<NormalSums>* by_source = nullptr);
  // The sum of the squared residuals, by a simulation without derivatives; x and v by frame where
  // asked for.
  std::optional<double> Sum(const ForceUnknowns& at, std::vector<Eigen::VectorXd>* x = nullptr,
                            std::vector<Eigen::VectorXd>* v = nullptr);

  // The system in the force alone, the free entries and faults eliminated along with their priors,
  // from sums around `at`.
  LinearSystem Eliminate(const NormalSums& sums, const ForceUnknowns& at) const;
  // What free entries and faults then are, for this force.
  ForceUnknowns Complete(const NormalSums& sums, const ForceUnknowns& at,
                         const Eigen::VectorXd& force) const;
  // Of the priors of free entries and faults.
  double PriorSum(const ForceUnknowns& at) const;

 private:
  struct FrameRows;
  struct Targets;
  int num_fixed() const { return free_.size() + num_faults_; }
  bool Evaluate(int frame, const State& state, const ForceUnknowns& at, FrameRows* rows) const;
  void Add(const FrameRows& rows, const std::vector<int>& chosen, const Eigen::MatrixXd& motion,
           NormalSums* sums) const;
  NormalSums Empty() const;
  Targets MakeTargets(const NormalSums& sums, const ForceUnknowns& at) const;
  Eigen::LLT<Eigen::MatrixXd> FixedFactor(const NormalSums& sums) const;

  const Scene& scene_;
  const FreeParameters& free_;
  const ForceLayout& layout_;
  const ResidualForceOptions& options_;
  ObservationResiduals observations_;
  ForcedMotion motion_;
  std::vector<int> frames_;
  std::vector<int> first_row_;  // by frame; -1 where its rows are not used
  int num_rows_ = 0, num_faults_ = 0;
};

}  // namespace clothfit
