// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ridders' tableau for vectors.
#include "autodiff_sim/base/gradient_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace clothfit {
namespace {

double Largest(const Eigen::VectorXd& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

// The next row of the tableau: entry k has the errors of order s^2 ... s^(2k) removed.
std::vector<Eigen::VectorXd> NextRow(const std::vector<Eigen::VectorXd>& above,
                                     Eigen::VectorXd difference, double shrink) {
  std::vector<Eigen::VectorXd> row = {std::move(difference)};
  double factor = 1.0;
  for (const Eigen::VectorXd& entry : above) {
    factor *= shrink * shrink;
    row.push_back((factor * row.back() - entry) / (factor - 1.0));
  }
  return row;
}

}  // namespace

Difference RiddersDifference(const std::function<bool(double s, Eigen::VectorXd* f)>& function,
                             double first_step, const GradientCheckOptions& options) {
  Difference best;
  best.error = std::numeric_limits<double>::infinity();
  std::vector<Eigen::VectorXd> above;
  std::vector<double> apart_above;  // how far each entry lies from its neighbours
  int without_gain = 0;
  double step = first_step;
  for (int i = 0; i < options.max_steps; ++i, step /= options.shrink) {
    Eigen::VectorXd plus, minus;
    best.evaluations += 2;
    if (!function(step, &plus) || !function(-step, &minus)) continue;
    if (!plus.allFinite() || !minus.allFinite()) continue;
    std::vector<Eigen::VectorXd> row =
        NextRow(above, (plus - minus) / (2.0 * step), options.shrink);
    if (above.empty()) best.derivative = row[0];
    ++without_gain;
    std::vector<double> apart = {std::numeric_limits<double>::infinity()};
    for (std::size_t k = 1; k < row.size(); ++k) {
      apart.push_back(std::max(Largest(row[k] - row[k - 1]), Largest(row[k] - above[k - 1])));
      // Neighbours may agree by chance once; twice running they hardly do.
      const double error = std::max(apart[k], apart_above[k - 1]);
      if (error >= best.error) continue;
      best.error = error;
      best.derivative = row[k];
      best.step = step;
      without_gain = 0;
    }
    apart_above = std::move(apart);
    above = std::move(row);
    const double enough = options.sufficient * options.tolerance;
    if (best.error <= enough * std::max(Largest(best.derivative), options.floor)) break;
    constexpr int kPatience = 4;  // the first steps may be far too long
    if (without_gain == kPatience) break;
  }
  return best;
}

int GradientCheckReport::Count(GradientVerdict verdict) const {
  return static_cast<int>(
      std::count_if(columns.begin(), columns.end(),
                    [verdict](const ColumnCheck& column) { return column.verdict == verdict; }));
}

double GradientCheckReport::WorstRelativeError() const {
  double worst = 0.0;
  for (const ColumnCheck& column : columns) {
    if (column.verdict != GradientVerdict::kUndecided)
      worst = std::max(worst, column.relative_error);
  }
  return worst;
}

GradientCheckReport CheckGradient(const VectorFunction& function, const Eigen::VectorXd& p,
                                  const Eigen::MatrixXd& jacobian,
                                  const GradientCheckOptions& options) {
  GradientCheckReport report;
  for (Eigen::Index j = 0; j < p.size(); ++j) {
    const double magnitude = std::abs(p[j]);
    const double typical =
        options.typical.size() > 0 ? options.typical[j] : (magnitude > 0.0 ? magnitude : 1.0);
    const auto along_entry = [&](double s, Eigen::VectorXd* f) {
      Eigen::VectorXd moved = p;
      moved[j] += s;
      return function(moved, f);
    };
    const Difference difference =
        RiddersDifference(along_entry, options.first_step * typical, options);
    report.evaluations += difference.evaluations;
    ColumnCheck column;
    if (difference.step > 0.0 && difference.derivative.size() == jacobian.rows()) {
      column.magnitude = Largest(difference.derivative);
      const double scale = std::max(column.magnitude, options.floor);
      column.relative_error = Largest(jacobian.col(j) - difference.derivative) / scale;
      column.difference_error = difference.error / scale;
      column.step = difference.step;
      if (column.relative_error <= options.tolerance) {
        column.verdict = GradientVerdict::kAgrees;
      } else if (column.relative_error > options.safety * column.difference_error) {
        column.verdict = GradientVerdict::kDisagrees;
      }
    }
    if (!jacobian.col(j).allFinite()) column.verdict = GradientVerdict::kDisagrees;
    report.columns.push_back(column);
  }
  return report;
}

}  // namespace clothfit
