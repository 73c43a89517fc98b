// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/optimiser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <nlopt.hpp>

#include "autodiff_sim/base/error.h"
#include "fitting/optimise/annealing.h"
#include "fitting/optimise/evaluation_counter.h"
#include "fitting/optimise/levenberg_marquardt.h"
#include "fitting/optimise/pattern_search.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// --- Levenberg-Marquardt

Minimum MinimiseByLevenbergMarquardt(const Objective& objective, const OptimiserOptions& options) {
  EvaluationCounter counter(objective, options);
  Eigen::VectorXd tried;
  const auto evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    if (!counter.Spent().empty()) return false;
    const bool usable = objective.residuals(x, residuals, jacobian);
    // What was tried and is differentiated now is the same evaluation.
    if (jacobian == nullptr || tried.size() != x.size() || tried != x) {
      counter.Count(
          x, usable ? 0.5 * residuals->squaredNorm() : std::numeric_limits<double>::infinity());
    }
    tried = x;
    return usable;
  };
  Eigen::VectorXd x = objective.start;
  const ceres::Solver::Summary summary =
      MinimiseWithin({objective.lower, objective.upper, {}}, objective.num_residuals, evaluate,
                     LevenbergMarquardtOptions(1000, 1e-6), &x);
  const std::string spent = counter.Spent();
  const bool converged = spent.empty() && summary.termination_type == ceres::CONVERGENCE;
  return counter.Finish(converged, spent.empty() ? summary.message : spent);
}

// --- NLopt

struct NloptCall {
  EvaluationCounter* counter;
  double worst;  // the largest finite value so far: BOBYQA's model cannot hold infinite ones
};

double NloptValue(const std::vector<double>& x, std::vector<double>& /*gradient*/, void* data) {
  auto* call = static_cast<NloptCall*>(data);
  if (!call->counter->Spent().empty()) throw nlopt::forced_stop();
  const double value = call->counter->Value(Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()));
  if (std::isfinite(value)) {
    call->worst = std::max(call->worst, value);
    return value;
  }
  return 2.0 * std::abs(call->worst) + 1.0;
}

Minimum MinimiseByNlopt(nlopt::algorithm algorithm, const Objective& objective,
                        const OptimiserOptions& options) {
  EvaluationCounter counter(objective, options);
  NloptCall call{&counter, 0.0};
  const auto n = static_cast<unsigned>(objective.start.size());
  const auto to_vector = [](const Eigen::VectorXd& x) {
    return std::vector<double>(x.data(), x.data() + x.size());
  };
  nlopt::opt search(algorithm, n);
  search.set_min_objective(NloptValue, &call);
  search.set_lower_bounds(to_vector(objective.lower));
  search.set_upper_bounds(to_vector(objective.upper));
  search.set_initial_step(to_vector(objective.step));
  search.set_xtol_abs(to_vector(options.tolerance * objective.step));
  constexpr int kGlobalEvaluations = 500;  // a coordinate: a global search knows no end of its own
  if (algorithm == nlopt::GN_DIRECT_L) search.set_maxeval(kGlobalEvaluations * static_cast<int>(n));
  std::vector<double> x = to_vector(objective.start);
  double value = 0.0;
  try {
    const nlopt::result result = search.optimize(x, value);
    return counter.Finish(true, fmt::format("NLopt ended with {}", static_cast<int>(result)));
  } catch (const nlopt::forced_stop&) {
    return counter.Finish(false, counter.Spent());
  } catch (const nlopt::roundoff_limited&) {
    return counter.Finish(true, "no further than rounding allows");
  }
}

const std::map<std::string, nlopt::algorithm>& NloptAlgorithms() {
  static const std::map<std::string, nlopt::algorithm> algorithms = {
      {"bobyqa", nlopt::LN_BOBYQA},
      {"nelder-mead", nlopt::LN_NELDERMEAD},
      {"sbplx", nlopt::LN_SBPLX},
      {"direct", nlopt::GN_DIRECT_L}};
  return algorithms;
}

void CheckObjective(const std::string& optimiser, const Objective& objective) {
  if (NeedsDerivatives(optimiser) && !objective.residuals) {
    throw InputError("optimiser", optimiser + ": the error has no derivatives; expected one of " +
                                      "those that need none");
  }
  if (optimiser == "bobyqa" && objective.start.size() < 2) {
    throw InputError("optimiser", optimiser + ": expected at least two free entries");
  }
  if (optimiser == "direct" && !(objective.lower.allFinite() && objective.upper.allFinite())) {
    throw InputError("optimiser", optimiser + ": expected finite bounds for every free entry");
  }
}

}  // namespace

const std::vector<std::string>& OptimiserNames() {
  static const std::vector<std::string> names = {"lm",          "pattern", "annealing", "bobyqa",
                                                 "nelder-mead", "sbplx",   "direct"};
  return names;
}

bool NeedsDerivatives(const std::string& optimiser) { return optimiser == "lm"; }

Minimum Minimise(const std::string& optimiser, const Objective& objective,
                 const OptimiserOptions& options) {
  const std::vector<std::string>& names = OptimiserNames();
  if (std::find(names.begin(), names.end(), optimiser) == names.end()) {
    throw InputError("optimiser", "'" + optimiser + "': expected one of " + JoinNames(names));
  }
  CheckObjective(optimiser, objective);
  if (optimiser == "lm") return MinimiseByLevenbergMarquardt(objective, options);
  if (optimiser == "pattern") return SearchPattern(objective, options);
  if (optimiser == "annealing") return Anneal(objective, options);
  return MinimiseByNlopt(NloptAlgorithms().at(optimiser), objective, options);
}

}  // namespace clothfit
