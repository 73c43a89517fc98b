// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Residuals of a fit where nothing is missing, the null: the fitted baseline simulated on a finer
// mesh with a shorter step, seen by cameras and markers with the errors of well-made ones, with
// noise.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/fitted/rows.h"

namespace clothfit {

// One sigma of the amounts of numerical error that are taken out where a force is located.
inline constexpr double kDiscretisationSigma = 2.0;

// Discretisation errors: residuals of twins, which are simulated on the finer mesh with half the
// step, at parameters drawn around the fit, after the baseline was fitted to them again. Such a fit
// takes most effects of mesh and step for material parameters. The residuals are larger by the
// error that the finer mesh still has.
struct DiscretisationErrors {
  Eigen::Index num_rows = 0;
  std::vector<Eigen::VectorXd> at_draws;  // rows
  // How many of all these simulations went so far elsewhere that they are left out.
  int num_elsewhere = 0;
  // How far the held-out frames are predicted from where the finer simulation has them, over the
  // draws; see HeldOutValidation. 0 where there are neither markers nor tracks.
  double held_out_rms = 0.0;
};

// `baseline`: the rows of the fit with its Jacobian, from which the draws are made. `stop`, which
// may be null, ends it early: what was not measured by then is left out.
DiscretisationErrors MeasureDiscretisationErrors(const FittedScene& fitted, const RowFrames& frames,
                                                 const Rows& baseline, int draws,
                                                 std::uint64_t seed,
                                                 const std::atomic<bool>* stop = nullptr);

// The finer mesh and step that stand for the truth.
FittedScene Finer(const FittedScene& fitted);

// The fit with its free vector drawn around where it ended, so near that what is simulated with it
// still looks like the recording.
std::vector<FittedScene> DrawNearFit(const FittedScene& fitted, const Rows& baseline, int count,
                                     std::uint64_t seed);

// A null residual, by its products with all columns of a Gram matrix and with itself.
struct NullResidual {
  Eigen::VectorXd products;
  double squared = 0.0;
};

// A column and how much of it a draw contains: about once its amount, of either sign, or its amount
// times a normal variate. Amounts are in the columns' own scale.
struct DrawnColumn {
  int column;
  double amount;
};

// Draws: noise of unit variance in each of `num_rows` rows, plus one of the columns `numerical` and
// all of `faults`. Columns should be of about one length.
std::vector<NullResidual> DrawNulls(const Eigen::MatrixXd& gram, Eigen::Index num_rows,
                                    const std::vector<DrawnColumn>& numerical,
                                    const std::vector<DrawnColumn>& faults, int count,
                                    std::uint64_t seed);

}  // namespace clothfit
