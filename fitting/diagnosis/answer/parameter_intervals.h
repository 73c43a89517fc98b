// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How certain the parameters of a model are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/diagnosis/fitted/rows.h"

namespace clothfit {

// The fitted ones of these names (term.parameter), in the table's order, with intervals by noise:
// those of the fit, wider by the root of the residuals' correlation time.
std::vector<EffectParameter> EstimatesOf(const FittedScene& fitted,
                                         const std::vector<std::string>& names);

// How far mesh and step push each free entry of a fit, in simulations of the fit on a finer mesh
// with half the step to which it was fitted again (MeasureShifts); in the entries' own scale.
struct DiscretisationShifts {
  std::vector<FreeEntry> entries;
  Eigen::MatrixXd by;     // entries x simulations that it is known from
  Eigen::MatrixXd noise;  // covariance of the entries by noise alone, as it is in EstimatesOf
  // Mean sum of squares (in sigmas) that noise, mesh and step leave after such a fit.
  double left_squared = 0.0;
};
DiscretisationShifts MeasureDiscretisationShifts(const FittedScene& fitted, std::uint64_t seed);

// Adds what mesh and step do to the intervals' halves, in squares: which way they push a fit of
// this recording is known for the simulations only, and by so few of them not well how far
// (Student 1908). Bounds are those of the config.
void Widen(const DiscretisationShifts& shifts, const FitConfig& config,
           std::vector<EffectParameter>* parameters);

// Whether an effect with these amounts, their intervals widened, may be what noise, mesh and step
// make where there is none: every interval holds the value that is off, and where there are several
// amounts, so does the 90 % region of all of them, by the covariances of both. Single intervals are
// too wide for that: the components of a wind along a cloth are hardly known, and with them that
// across it. `values` are the fitted ones. False where nothing is known of it.
bool MayBeNothing(const DiscretisationShifts& shifts, const FitConfig& values,
                  const std::vector<EffectParameter>& amounts);

}  // namespace clothfit
