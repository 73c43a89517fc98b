// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks a Jacobian against differences that know their own error: central differences of several
// steps, extrapolated to step zero (Richardson) in the tableau of Ridders 1982, Accurate
// computation of F'(x) and F'(x) F''(x); Press et al. 2007, sec. 5.7. Truncation shows in the large
// steps and roundoff in the small ones; both show in how far neighbours in the tableau lie apart,
// and the entry whose neighbours agree best, as did those of the row before, is the difference.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

struct GradientCheckOptions {
  double tolerance = 1e-5;  // of the relative error of a column, no unit
  double floor = 1e-12;     // unit of f / p: a column whose largest entry is below counts as this
  // Typical size of each entry of p, in its unit; empty for |p|, and 1 where p is 0. An entry's
  // first step is first_step times its typical size.
  Eigen::VectorXd typical;
  double first_step = 1e-2;  // no unit
  double shrink = 2.0;       // each step is the one before over this, above 1
  int max_steps = 9;         // of which two evaluations each are spent on a column
  // Steps are spent until the difference is this much better than the tolerance.
  double sufficient = 0.05;
  // The estimated error may be too small by this factor before a Jacobian is called wrong.
  double safety = 3.0;
};

enum class GradientVerdict {
  kAgrees,     // the relative error is within the tolerance
  kDisagrees,  // it is not, nor can the difference's own error explain it: the Jacobian is wrong
  kUndecided,  // it is not, but lies within the difference's own error, or no difference was found
};

// One entry of p, one column of the Jacobian J; D is the difference. Norms are largest entries.
struct ColumnCheck {
  GradientVerdict verdict = GradientVerdict::kUndecided;
  double relative_error = 0.0;    // |J - D| / max(|D|, floor), no unit
  double difference_error = 0.0;  // estimated |D - exact| / max(|D|, floor), no unit
  double magnitude = 0.0;         // |D|, unit of f / p
  double step = 0.0;              // smallest step that D uses, unit of p; 0 where D was not found
};

struct GradientCheckReport {
  std::vector<ColumnCheck> columns;
  int evaluations = 0;

  int Count(GradientVerdict verdict) const;
  double WorstRelativeError() const;  // of the columns that were decided
};

// Evaluates f(p), any number of entries, always the same; false where f cannot be evaluated at p.
using VectorFunction = std::function<bool(const Eigen::VectorXd& p, Eigen::VectorXd* f)>;

// Compares `jacobian`, df/dp at p, with differences, column by column. A step at which f cannot be
// evaluated is left out.
GradientCheckReport CheckGradient(const VectorFunction& function, const Eigen::VectorXd& p,
                                  const Eigen::MatrixXd& jacobian,
                                  const GradientCheckOptions& options = {});

// df/ds at s = 0 of a function of one number.
struct Difference {
  Eigen::VectorXd derivative;  // unit of f / s; empty where f could not be evaluated
  double error = 0.0;          // estimated, of the worst entry, unit of f / s
  double step = 0.0;           // smallest step it uses, unit of s
  int evaluations = 0;
};
Difference RiddersDifference(const std::function<bool(double s, Eigen::VectorXd* f)>& function,
                             double first_step, const GradientCheckOptions& options = {});

}  // namespace clothfit
