// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/log_evidence.h"

#include <algorithm>
#include <cmath>

namespace clothfit {

double LogEvidence(double before, double after, double unknowns, const ResidualScale& scale) {
  const double correlation = std::max(1.0, scale.correlation);
  const double independent = std::max(1.0, scale.rows / correlation);
  return (before - after) / (std::max(1.0, scale.chi_square) * correlation) -
         0.5 * unknowns * std::log(independent);
}

}  // namespace clothfit
