// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The force that a fitted model lacks: weak-constraint least squares (Tremolet 2006) for a force
// per area over the cloth and over time, through the differentiated simulation, while what was
// fitted may move along. docs/diagnosis.md has the equations.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "fitting/diagnosis/locate/force_layout.h"
#include "fitting/residuals/observation_residuals.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct ResidualForceOptions {
  std::array<int, 2> nodes = {4, 4};  // over the cloth
  double knot_spacing = 0.08;         // s
  // Ranges over which the prior takes forces for alike, a share of the cloth's longer side, and s;
  // instead of each, all of the cloth and all of the time where the marginal likelihood is larger.
  double correlation_length = 0.4;
  double correlation_time = 0.12;
  int iterations = 2;       // linearisations at most
  bool by_source = false;   // keep the equations of each source apart (see WhoseDiscrepancy)
  std::vector<int> frames;  // whose rows are used; empty: all that are fitted
  // Residuals of simulated recordings in which nothing is missing, one a column, rows as
  // ObservationResiduals has them, frame after frame of `frames`, of the very scene below.
  Eigen::MatrixXd nulls;
  // Faults of the observation that go unremarked (camera poses, clocks, ...): d residuals of a
  // frame / d fault, rows x faults, and one sigma of each; eliminated along with the free entries.
  std::function<RowMajorMatrix(int frame, const State& state)> faults;
  Eigen::VectorXd fault_sigmas;
  const std::atomic<bool>* stop = nullptr;  // ends it: there is no estimate
};

// Least squares: information * solution = data, with one column of data the observed one and one
// each null. All in units of the residuals' sigmas.
struct LinearSystem {
  Eigen::MatrixXd information;  // lower triangle
  Eigen::MatrixXd data;
  double sum = 0.0;   // of the squares of the observed data's right-hand sides
  double rows = 0.0;  // observed coordinates, as ObservationResiduals::NumObserved counts them
};

// What a source of observations says: a camera, or the markers.
struct SourceSystem {
  int camera = -1;     // -1: markers
  LinearSystem force;  // with this source LEFT OUT; free entries and faults eliminated
};

// A linear estimate with a Gaussian prior: f = s L w, w ~ N(0, 1), in a system whose unit of noise
// is `noise`. Factored once; everything else is back-substitution.
class PosteriorForce {
 public:
  PosteriorForce() = default;
  // correlation_factor: L; strength: s over the noise.
  PosteriorForce(const LinearSystem& system, const Eigen::MatrixXd& correlation_factor,
                 double strength, double noise);

  double strength() const { return strength_; }
  double noise() const { return noise_; }
  // The mean for these data (controls x columns).
  Eigen::MatrixXd Mean(const Eigen::MatrixXd& data) const;
  // Posterior covariance of linear functions of the force, one a row of `functions`.
  Eigen::MatrixXd Covariance(const Eigen::MatrixXd& functions) const;
  // Covariance that the mean of these functions has where nothing is missing, by noise alone.
  Eigen::MatrixXd NoiseCovariance(const Eigen::MatrixXd& functions) const;
  // The diagonal's 3 x 3 blocks of both, a (knot, node) after the other: 3 x controls.
  Eigen::MatrixXd Blocks() const;
  Eigen::MatrixXd NoiseBlocks() const;

 private:
  Eigen::MatrixXd ScaledRows(const Eigen::MatrixXd& functions) const;

  Eigen::MatrixXd factor_;                // L
  Eigen::LLT<Eigen::MatrixXd> whitened_;  // of I + s^2 L' information L
  double strength_ = 0.0, noise_ = 1.0;
};

struct MissingForce {
  ForceLayout layout;
  Eigen::VectorXd theta;   // the free vector with the force there
  Eigen::VectorXd faults;  // amounts
  Eigen::VectorXd force;   // N/m^2, as the layout has it
  Eigen::VectorXd sigma;   // posterior standard deviation of each
  // One sigma of the prior (N/m^2) where the marginal likelihood is largest, and what the
  // residuals' sigmas are to be multiplied by, at least 1.
  double prior_sigma = 0.0, noise_factor = 1.0;
  // log marginal likelihood with the force less that without it: how much the data ask for it.
  double log_evidence = 0.0;
  // Sum of the squared residuals without the force and with it, both simulated; the share of the
  // former that it explains.
  double sum_before = 0.0, sum_after = 0.0, explained = 0.0;
  int last_frame = 0;
  std::vector<Eigen::VectorXd> x, v;  // by frame 0..last_frame: m and m/s, with the force

  LinearSystem system;  // of the last linearisation
  Eigen::MatrixXd correlation_factor;
  PosteriorForce posterior;
  Eigen::MatrixXd null_forces;        // controls x nulls: the map of each
  std::vector<SourceSystem> without;  // by_source only
};

// Around a fit of `scene` with these free entries at theta. The scene may be coarser than the
// fit's. Nothing where the simulation or an observation fails at theta. Throws InputError where the
// nulls have not as many rows as the observations. The numbers are the same for any number of
// threads.
std::optional<MissingForce> EstimateMissingForce(const Scene& scene, const FitConfig& config,
                                                 const FreeParameters& free,
                                                 const Eigen::VectorXd& theta,
                                                 const ResidualForceOptions& options = {});

// The strength s (N/m^2 over the noise) with the largest marginal likelihood of the first column of
// data, noise profiled out but never below 1 (MacKay 1992); see docs/diagnosis.md.
struct Evidence {
  double strength = 0.0, noise = 1.0;
  double log_evidence = 0.0;  // less that of no force
};
Evidence MaximiseEvidence(const LinearSystem& system, const Eigen::MatrixXd& correlation_factor);

}  // namespace clothfit
