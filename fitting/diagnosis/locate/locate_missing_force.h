// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where and when a force is missing, of a fitted baseline: the estimate of the force
// with what the fit, the observation's faults and numerical error could do instead taken out.
#pragma once

#include <optional>
#include <vector>

#include "fitting/diagnosis/fitted/options.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/diagnosis/gate/null_residuals.h"
#include "fitting/diagnosis/locate/locate.h"

namespace clothfit {

struct LocatedForce {
  FittedScene fitted;  // that the force was estimated in: the fit's, or a coarser one
  MissingForce missing;
  Location location;  // its words name the source that is to blame, where one is
  std::vector<SourceShift> sources;
  const SourceShift* Blamed() const;  // null where none is to blame
};

// Nothing where the simulation fails, or where no frame after the first is observed. `errors`:
// the discretisation errors of the fit, where they are known.
std::optional<LocatedForce> LocateMissingForce(const FittedScene& fitted,
                                               const DiagnosisOptions& options,
                                               const DiscretisationErrors* errors = nullptr);

// Residuals of recordings in which nothing is missing, one a column: noise of unit variance,
// discretisation errors of the baseline, and well-made recordings' faults.
// fault_columns: d residuals / d faults, rows x faults.
Eigen::MatrixXd DrawNullResiduals(const std::vector<Eigen::VectorXd>& numerical,
                                  const Eigen::MatrixXd& fault_columns,
                                  const Eigen::VectorXd& typical_faults, Eigen::Index num_rows,
                                  int count, std::uint64_t seed);

}  // namespace clothfit
