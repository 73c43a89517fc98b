// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The score of an observation fault against the scores that the null gives it.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/rank/ranking.h"

namespace clothfit {

// Products of a residual and of faults' columns. A column of the Gram matrix is its values times
// its scale.
struct FaultProducts {
  const std::vector<Fault>& faults;
  const Eigen::MatrixXd& gram;
  const Eigen::VectorXd& scale;
  int residual = 0, first_fault = 0;  // columns
  const std::vector<NullResidual>& nulls;
  double null_mean = 0.0;  // sum of squares that the null leaves
};

// All faults but those of a group, as nuisances: as well-made recordings have them at most, or as
// much as is tolerated.
std::vector<Nuisance> OtherFaults(const std::vector<Fault>& faults, const std::string& group,
                                  int first_fault, const Eigen::VectorXd& scale,
                                  bool are_well_made);

// All faults of a group together, scored beside these nuisances.
RankedCandidate ScoreFaults(const FaultProducts& products, const std::string& group,
                            const std::vector<Nuisance>& nuisances);

// p-value and detection limit of a candidate from the scores that the null gave it.
void JudgeAgainstNull(const Projection& projection, const Eigen::VectorXd& scale,
                      const std::vector<double>& null_scores, RankedCandidate* candidate);

// Sums of squares that the null leaves beside these nuisances, one a draw.
std::vector<double> LeftByNulls(const Projection& projection,
                                const std::vector<NullResidual>& nulls);
double Mean(const std::vector<double>& values);

// Of what is left a score takes this share.
double ShareOf(double score, double left);

}  // namespace clothfit
