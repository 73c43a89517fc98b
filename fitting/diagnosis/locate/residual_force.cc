// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/residual_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/locate/force_equations.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// L' information L, both triangles.
Eigen::MatrixXd Whitened(const Eigen::MatrixXd& information, const Eigen::MatrixXd& factor) {
  const Eigen::MatrixXd right = information.selfadjointView<Eigen::Lower>() *
                                Eigen::MatrixXd(factor.triangularView<Eigen::Lower>());
  return factor.transpose().triangularView<Eigen::Upper>() * right;
}

Eigen::LLT<Eigen::MatrixXd> Regularised(const Eigen::MatrixXd& whitened, double strength) {
  Eigen::MatrixXd sum = strength * strength * whitened;
  sum.diagonal().array() += 1.0;
  return Cholesky(sum, "the information on the missing force");
}

double LogLikelihood(double sum, double rows, double log_determinant, double* noise) {
  const double variance = std::max(1.0, sum / rows);
  *noise = std::sqrt(variance);
  return -0.5 * (rows * std::log(variance) + sum / variance + log_determinant);
}

}  // namespace

Evidence MaximiseEvidence(const LinearSystem& system, const Eigen::MatrixXd& correlation_factor) {
  const Eigen::MatrixXd whitened = Whitened(system.information, correlation_factor);
  const Eigen::VectorXd data =
      correlation_factor.triangularView<Eigen::Lower>().transpose() * system.data.col(0);
  const double rows = std::max(1.0, system.rows);
  double noise = 1.0;
  const double without = LogLikelihood(system.sum, rows, 0.0, &noise);
  const auto evaluate = [&](double log10_strength) {
    Evidence at;
    at.strength = std::pow(10.0, log10_strength);
    const Eigen::LLT<Eigen::MatrixXd> factor = Regularised(whitened, at.strength);
    const double gain = at.strength * at.strength * factor.matrixL().solve(data).squaredNorm();
    const double log_determinant = 2.0 * factor.matrixLLT().diagonal().array().log().sum();
    at.log_evidence = LogLikelihood(system.sum - gain, rows, log_determinant, &at.noise) - without;
    return at;
  };
  constexpr double kLowest = -2.5, kHighest = 1.5;  // log10 of N/m^2 over the noise
  double best = kLowest;
  Evidence result = evaluate(best);
  const auto look = [&](double place) {
    const Evidence at = evaluate(place);
    if (at.log_evidence <= result.log_evidence) return;
    result = at;
    best = place;
  };
  for (double place = kLowest + 0.5; place <= kHighest; place += 0.5) look(place);
  for (const double step : {0.25, 0.125}) {
    const double middle = best;
    look(middle - step);
    look(middle + step);
  }
  return result;
}

PosteriorForce::PosteriorForce(const LinearSystem& system,
                               const Eigen::MatrixXd& correlation_factor, double strength,
                               double noise)
    : factor_(correlation_factor),
      whitened_(Regularised(Whitened(system.information, correlation_factor), strength)),
      strength_(strength),
      noise_(noise) {}

Eigen::MatrixXd PosteriorForce::Mean(const Eigen::MatrixXd& data) const {
  const Eigen::MatrixXd right = factor_.transpose().triangularView<Eigen::Upper>() * data;
  const Eigen::MatrixXd white = strength_ * strength_ * whitened_.solve(right);
  return factor_.triangularView<Eigen::Lower>() * white;
}

// L'h for each function h, as columns, times the prior's sigma.
Eigen::MatrixXd PosteriorForce::ScaledRows(const Eigen::MatrixXd& functions) const {
  const Eigen::MatrixXd scaled = noise_ * strength_ * functions.transpose();
  return factor_.transpose().triangularView<Eigen::Upper>() * scaled;
}

Eigen::MatrixXd PosteriorForce::Covariance(const Eigen::MatrixXd& functions) const {
  const Eigen::MatrixXd half = whitened_.matrixL().solve(ScaledRows(functions));
  return half.transpose() * half;
}

Eigen::MatrixXd PosteriorForce::NoiseCovariance(const Eigen::MatrixXd& functions) const {
  const Eigen::MatrixXd half = whitened_.matrixL().solve(ScaledRows(functions));
  const Eigen::MatrixXd whole = whitened_.matrixU().solve(half);
  return half.transpose() * half - whole.transpose() * whole;
}

namespace {

// The 3 x 3 blocks on the diagonal of columns' * columns.
void AddBlocks(const Eigen::MatrixXd& columns, double scale, Eigen::MatrixXd* blocks) {
  for (Eigen::Index i = 0; i < columns.cols(); i += 3) {
    const auto own = columns.middleCols<3>(i);
    blocks->middleCols<3>(i) += scale * (own.transpose() * own);
  }
}

}  // namespace

Eigen::MatrixXd PosteriorForce::Blocks() const {
  const Eigen::Index size = factor_.rows();
  const Eigen::MatrixXd half =
      whitened_.matrixL().solve(ScaledRows(Eigen::MatrixXd::Identity(size, size)));
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(3, size);
  AddBlocks(half, 1.0, &blocks);
  return blocks;
}

Eigen::MatrixXd PosteriorForce::NoiseBlocks() const {
  const Eigen::Index size = factor_.rows();
  Eigen::MatrixXd columns =
      whitened_.matrixL().solve(ScaledRows(Eigen::MatrixXd::Identity(size, size)));
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(3, size);
  AddBlocks(columns, 1.0, &blocks);
  columns = whitened_.matrixU().solve(columns);
  AddBlocks(columns, -1.0, &blocks);
  return blocks;
}

namespace {

// Gauss-Newton from one set of unknowns to the next.
class Estimator {
 public:
  Estimator(const Scene& scene, const FitConfig& config, const FreeParameters& free,
            const ResidualForceOptions& options, MissingForce* result)
      : options_(options),
        result_(*result),
        equations_(scene, config, free, result->layout, options) {
    if (options.nulls.cols() > 0 && options.nulls.rows() != equations_.num_rows()) {
      throw InputError("null residuals",
                       fmt::format("{} rows; expected {}, as many as there are observations",
                                   options.nulls.rows(), equations_.num_rows()));
    }
  }

  bool Run(ForceUnknowns at) {
    const std::optional<double> before = equations_.Sum(at);
    if (!before) return false;
    result_.sum_before = result_.sum_after = *before;
    for (int i = 0; i < options_.iterations; ++i) {
      std::vector<NormalSums> by_source;
      const std::optional<NormalSums> sums =
          equations_.Linearise(at, options_.by_source ? &by_source : nullptr);
      if (!sums) return false;
      Solve(*sums, at);
      LeaveOut(*sums, by_source, at);
      const double cost = Cost(at, result_.sum_after);
      at = Step(*sums, at);
      constexpr double kEnough = 0.02;  // decrease that another linearisation is worth
      if (Cost(at, result_.sum_after) > (1.0 - kEnough) * cost) break;
    }
    Finish(at);
    return equations_.Sum(at, &result_.x, &result_.v).has_value();
  }

 private:
  void Solve(const NormalSums& sums, const ForceUnknowns& at) {
    result_.system = equations_.Eliminate(sums, at);
    const Evidence evidence = ChoosePrior();
    result_.posterior = PosteriorForce(result_.system, result_.correlation_factor,
                                       evidence.strength, evidence.noise);
    result_.log_evidence = evidence.log_evidence;
    result_.noise_factor = evidence.noise;
    result_.prior_sigma = evidence.strength * evidence.noise;
  }

  // The strength and, the first time, the ranges that the data ask for most: a force may change
  // from place to place and from moment to moment, or be much the same throughout.
  Evidence ChoosePrior() {
    if (result_.correlation_factor.size() > 0)
      return MaximiseEvidence(result_.system, result_.correlation_factor);
    constexpr double kThroughout = 10.0;  // times the cloth's side, or the recording's duration
    const ForceLayout& layout = result_.layout;
    const double side = (layout.high - layout.low).maxCoeff();
    const double duration = layout.KnotTime(layout.num_knots - 1);
    Evidence best;
    for (const double length : {options_.correlation_length * side, kThroughout * side}) {
      for (const double time : {options_.correlation_time, kThroughout * duration}) {
        Eigen::MatrixXd factor = layout.CorrelationFactor(length, time);
        const Evidence evidence = MaximiseEvidence(result_.system, factor);
        const bool is_first = result_.correlation_factor.size() == 0;
        if (!is_first && evidence.log_evidence <= best.log_evidence) continue;
        best = evidence;
        result_.correlation_factor = std::move(factor);
      }
    }
    return best;
  }

  // Sum of squares with all priors, in units of the residuals' sigmas.
  double Cost(const ForceUnknowns& at, double sum) const {
    const Eigen::VectorXd white =
        result_.correlation_factor.triangularView<Eigen::Lower>().solve(at.force);
    const double strength = result_.posterior.strength();
    return sum + equations_.PriorSum(at) + white.squaredNorm() / (strength * strength);
  }

  // To the solution of the linearised problem, or where the simulation likes that better to that of
  // a narrower prior, as Levenberg and Marquardt do.
  ForceUnknowns Step(const NormalSums& sums, const ForceUnknowns& at) {
    ForceUnknowns best = at;
    double best_cost = Cost(at, result_.sum_after), strength = result_.posterior.strength();
    constexpr int kTries = 10;
    for (int i = 0; i < kTries; ++i, strength /= 3.0) {
      const PosteriorForce narrower(result_.system, result_.correlation_factor, strength,
                                    result_.posterior.noise());
      const ForceUnknowns next = equations_.Complete(
          sums, at, (i == 0 ? result_.posterior : narrower).Mean(result_.system.data.leftCols(1)));
      const std::optional<double> sum = equations_.Sum(next);
      const double cost = sum ? Cost(next, *sum) : std::numeric_limits<double>::infinity();
      if (cost < best_cost) {
        best = next;
        best_cost = cost;
        result_.sum_after = *sum;
      } else if (best.force != at.force) {
        break;
      }
    }
    return best;
  }

  void LeaveOut(const NormalSums& all, const std::vector<NormalSums>& by_source,
                const ForceUnknowns& at) {
    result_.without.clear();
    for (std::size_t s = 0; s < by_source.size(); ++s) {
      const NormalSums& source = by_source[s];
      if (source.information.size() == 0) continue;
      const NormalSums rest = {all.information - source.information, all.data - source.data,
                               all.sum - source.sum, all.rows - source.rows};
      result_.without.push_back({static_cast<int>(s) - 1, equations_.Eliminate(rest, at)});
    }
  }

  void Finish(const ForceUnknowns& at) {
    result_.theta = at.theta;
    result_.faults = at.faults;
    // Where the simulation accepts no step, the linearised problem still tells where to look.
    result_.force = at.force;
    if (at.force.isZero(0.0))
      result_.force = result_.posterior.Mean(result_.system.data.leftCols(1));
    result_.explained = 1.0 - result_.sum_after / result_.sum_before;
    result_.last_frame = equations_.last_frame();
    const Eigen::MatrixXd blocks = result_.posterior.Blocks();
    result_.sigma.resize(at.force.size());
    for (Eigen::Index i = 0; i < at.force.size(); ++i)
      result_.sigma[i] = std::sqrt(blocks(i % 3, i));
    result_.null_forces =
        result_.posterior.Mean(result_.system.data.rightCols(options_.nulls.cols()));
  }

  const ResidualForceOptions& options_;
  MissingForce& result_;
  ForceEquations equations_;
};

}  // namespace

std::optional<MissingForce> EstimateMissingForce(const Scene& scene, const FitConfig& config,
                                                 const FreeParameters& free,
                                                 const Eigen::VectorXd& theta,
                                                 const ResidualForceOptions& options) {
  MissingForce result;
  const int last = options.frames.empty() ? scene.last_fitted_frame : options.frames.back();
  result.layout = MakeForceLayout(scene.mesh, options.nodes, scene.recording.frame_rate, last,
                                  options.knot_spacing);
  Estimator estimator(scene, config, free, options, &result);
  const ForceUnknowns start = {theta, Eigen::VectorXd::Zero(options.fault_sigmas.size()),
                               Eigen::VectorXd::Zero(result.layout.size())};
  if (!estimator.Run(start)) return {};
  return result;
}

}  // namespace clothfit
