// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the data determine, and how well.
#pragma once

#include <string>
#include <vector>

#include "fitting/residuals/observation_residuals.h"
#include "fitting/rollout/free_vector.h"

namespace clothfit {

// Errors beyond independent noise that the intervals have to hold.
struct ModelErrors {
  double correlation = 1.0;  // residuals that say as much as one: variances grow by it
  // What the gradient J' r may be by errors that last over frames (its covariance): of what
  // residuals are beyond noise, and of the discretisation error. Empty where there is none.
  Eigen::MatrixXd lasting;
  // How far the discretisation error e moves the free entries. It is one more unknown how many
  // times it is there: `mean`, give or take `amplitude`. Empty where e is not known.
  Eigen::VectorXd shift;
  double mean = 0.0, amplitude = 0.0;
};

struct Uncertainty {
  Eigen::VectorXd sigma;  // one a free entry, in the free vector's scale
  // Ends of the 95 % interval, as offsets from the solution in the free vector's scale: a physical
  // parameter's are the profile's (fitting/fit/profile_interval.h), others 1.96 sigmas, around
  // where the expected discretisation error puts the entry.
  Eigen::VectorXd lower95, upper95;
  std::vector<bool> determined;  // by the data: the posterior variance is below half of the prior's
  // Residuals over stated sigmas, at least 1; the intervals contain it, and their correlation.
  double noise_factor = 1.0;
  std::vector<std::string> statements;  // the directions that the data leave to the prior, in words
};

// From the observations' residuals and Jacobian at the solution and the priors. The covariance is
// Ceres', of the linearised problem. The undetermined directions are those of the physical
// parameters along which the singular values of the Jacobian, in units of the priors' sigmas and
// with every other free entry projected out, are below 1: there the prior knows more than the data.
// `num_observed` is the number of observed coordinates, which compressed rows do not show.
Uncertainty QuantifyUncertainty(const FreeVector& free, int num_observed,
                                const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian,
                                const ModelErrors& errors = {});

// The directions of these entries that the data leave to their priors, in words, from the entries'
// posterior covariance (marginal, in the free vector's scale).
std::vector<std::string> DescribeUndetermined(const std::vector<FreeEntry>& entries,
                                              const Eigen::MatrixXd& covariance);

}  // namespace clothfit
