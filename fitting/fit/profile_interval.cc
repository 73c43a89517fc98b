// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/profile_interval.h"

#include <cmath>

#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// s(d) and its slopes.
void Respond(const ResponseModel& model, const Eigen::VectorXd& d, Eigen::VectorXd* s,
             Eigen::VectorXd* slope) {
  *s = d;
  slope->setOnes(d.size());
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    if (!model.is_log[static_cast<std::size_t>(i)] || d[i] >= 0.0) continue;
    (*s)[i] = std::expm1(d[i]);
    (*slope)[i] = std::exp(d[i]);
  }
}

// Twice the growth of the cost.
double Growth(const ResponseModel& model, const Eigen::VectorXd& d) {
  Eigen::VectorXd s, slope;
  Respond(model, d, &s, &slope);
  return s.dot(model.data_information * s) + 2.0 * model.data_gradient.dot(s - d) +
         d.dot(model.prior_information * d);
}

// The least growth with one entry held at its offset; d goes from where it is to the minimum.
double LeastGrowth(const ResponseModel& model, int held, Eigen::VectorXd* d) {
  constexpr int kMaxIterations = 30;
  double growth = Growth(model, *d);
  Eigen::VectorXd s, slope;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    Respond(model, *d, &s, &slope);
    Eigen::VectorXd gradient =
        slope.cwiseProduct(model.data_information * s + model.data_gradient) - model.data_gradient +
        model.prior_information * *d;
    Eigen::MatrixXd hessian =
        slope.asDiagonal() * model.data_information * slope.asDiagonal() + model.prior_information;
    hessian.row(held).setZero();
    hessian.col(held).setZero();
    hessian(held, held) = 1.0;
    gradient[held] = 0.0;
    const auto factor = TrySemidefinite(hessian);
    if (!factor) return growth;  // no way on from here
    const Eigen::VectorXd step = factor->solve(-gradient);
    double share = 1.0, reached = growth;
    for (; share > 1e-4; share *= 0.5) {
      reached = Growth(model, *d + share * step);
      if (reached < growth) break;
    }
    if (!(reached < growth)) return growth;
    *d += share * step;
    const double gain = growth - reached;
    growth = reached;
    if (gain < 1e-6 * (1.0 + growth)) return growth;
  }
  return growth;
}

// The offset on one side (-1 or 1) of the solution.
double ProfileEnd(const ResponseModel& model, const Eigen::MatrixXd& covariance, int entry,
                  double sigmas, double side) {
  const double sigma = std::sqrt(covariance(entry, entry));
  const Eigen::VectorXd along = covariance.col(entry) / covariance(entry, entry);
  const auto grown_beyond = [&](double offset) {
    Eigen::VectorXd d = offset * along;
    return LeastGrowth(model, entry, &d) > sigmas * sigmas;
  };
  double inner = 0.0, outer = sigmas * sigma;
  constexpr double kFarthest = 16.0;  // times what the covariance says
  while (!grown_beyond(side * outer)) {
    inner = outer;
    outer *= 1.5;
    if (outer > kFarthest * sigmas * sigma) return side * inner;
  }
  while (outer - inner > 1e-3 * outer) {
    const double middle = 0.5 * (inner + outer);
    (grown_beyond(side * middle) ? outer : inner) = middle;
  }
  return side * 0.5 * (inner + outer);
}

}  // namespace

Interval ProfileInterval(const ResponseModel& model, const Eigen::MatrixXd& covariance, int entry,
                         double sigmas) {
  if (!(covariance(entry, entry) > 0.0)) return {};
  return {ProfileEnd(model, covariance, entry, sigmas, -1.0),
          ProfileEnd(model, covariance, entry, sigmas, 1.0)};
}

}  // namespace clothfit
