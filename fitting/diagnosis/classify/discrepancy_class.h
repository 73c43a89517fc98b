// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Of what class a missing force is, before it has a name: the cloth's own or from outside, with the
// motion or against it, and to what it is tied. docs/diagnosis.md has the equations.
#pragma once

#include <string>
#include <vector>

#include "fitting/diagnosis/classify/classes.h"
#include "fitting/diagnosis/locate/locate.h"
#include "fitting/diagnosis/locate/residual_force.h"

namespace clothfit {

// A missing force that is tied to something spans fewer dimensions than any force at all.
struct TriedTie {
  std::string to;             // as in DiscrepancyClass::tied_to; "" for any force at all
  std::string family;         // "one vector", "field in the world", ...
  double log_evidence = 0.0;  // against no force
  double explained = 0.0;     // decrease of the sum of squares over that of any force at all
  // Forces in the patch only, or in its time only: found in the same data, so that their evidence
  // is too good and they are not said to be a tie.
  bool is_of_patch = false;
};

// Net sums over the cloth at the knots of the map, and what they show.
struct DiscrepancyBalance {
  std::vector<double> times;           // s
  Eigen::MatrixXd force, force_sigma;  // N, world, 3 x times
  // N m about what the handles cannot turn the cloth around: components along the directions in
  // which they leave it free (about a point, the line through two of them, nothing beyond).
  std::vector<double> moment, moment_sigma;  // of all knots, component after component
  Eigen::VectorXd power, power_sigma;        // W, of the force on the cloth's motion
  // |free net moment, and net force where nothing holds the cloth| over the same sum with all parts
  // taken without their signs: near 0 for forces that cancel, towards 1 for those that add up.
  double coherence = 0.0;
  bool is_testable = false;  // false where the handles could hide any net force and moment
};

struct DiscrepancyReport {
  DiscrepancyClass discrepancy_class;
  DiscrepancyBalance balance;
  std::vector<TriedTie> ties;  // all that were tried, best first
};

// `scene` is the one that the force was estimated in.
DiscrepancyReport ClassifyDiscrepancy(const Scene& scene, const MissingForce& missing,
                                      const Location& location);

}  // namespace clothfit
