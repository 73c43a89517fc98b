// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The vector that the fit of one recording moves: physical parameters (log scale where they are
// positive), control points of unknown handle paths, and offsets of the initial state.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fitting/config/config.h"
#include "fitting/rollout/free_vector.h"
#include "fitting/scene/path_guess.h"
#include "fitting/scene/scene.h"

namespace clothfit {

class FreeParameters : public FreeVector {
 public:
  // Its start: the config's values, unknown paths as the markers near them suggest or at rest where
  // there are none, no offsets. Throws InputError where a parameter is free on a logarithmic scale
  // from 0 or less.
  FreeParameters(const FitConfig& config, const Scene& scene,
                 const std::vector<NamedParameter>& table);

  // theta with the unknown handles' paths (by handle; those of known ones are not looked at) as
  // near to these points as their sigma (m) and the paths' priors let them.
  Eigen::VectorXd WithHandlePaths(Eigen::VectorXd theta, const Scene& scene,
                                  const std::vector<std::vector<PathPoint>>& paths,
                                  double sigma) const;

  // All physical parameters, in the table's order, and their derivatives (all x size()).
  Eigen::VectorXd Values(const Eigen::VectorXd& theta) const;
  Eigen::MatrixXd ValueDirections(const Eigen::VectorXd& theta) const;

  // Puts the unknown handles' control points into the scene's paths.
  void ApplyToHandles(const Eigen::VectorXd& theta, std::vector<SceneHandle>* handles) const;
  // d (position of handle h at a time) / d theta, 3 x size().
  Eigen::MatrixXd HandleDirections(const std::vector<SceneHandle>& handles, int h,
                                   double time) const;

  // Initial positions and velocities (3N) and their derivatives (3N x size()).
  void InitialState(const Eigen::VectorXd& theta, Eigen::VectorXd* x, Eigen::VectorXd* v) const;
  void InitialDirections(Eigen::MatrixXd* dx, Eigen::MatrixXd* dv) const;

 private:
  void AddParameters(const FitConfig& config, const std::vector<NamedParameter>& table);
  void AddHandles(const FitConfig& config, const Scene& scene);
  void AddInitialState(const FitConfig& config, const Scene& scene);
  void BuildPrior(const FitConfig& config, const Scene& scene);
  void GuessHandlePaths(const Scene& scene);

  std::vector<double> starts_;
  Eigen::VectorXd values_;   // all physical parameters; free ones are replaced
  Eigen::VectorXd initial_;  // 3N, m
  Eigen::MatrixXd modes_;    // N x polynomials
};

}  // namespace clothfit
