// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/gate/null_residuals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/Eigenvalues>
#include <ceres/ceres.h>

#include "autodiff_sim/base/normal_numbers.h"
#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "fitting/optimise/levenberg_marquardt.h"

namespace clothfit {
namespace {

// How much finer: the error that a fit's mesh makes is mostly gone, and the cost bearable.
constexpr double kFinerMesh = 1.6;
// A finer mesh has an error of its own: that of the fit's is this much more than the difference, by
// the order in which errors of linear elements fall, the second (Richardson 1911).
constexpr double kOfDifference = 1.0 / (1.0 - 1.0 / (kFinerMesh * kFinerMesh));
constexpr double kFinerStep = 0.5;

// Streams of one seed.
constexpr std::uint64_t kNearFit = 101, kNull = 103;

// The fit with its free vector moved.
FittedScene Moved(const FittedScene& fitted, const std::vector<FreeEntry>& entries,
                  const Eigen::VectorXd& by) {
  FittedScene moved = fitted;
  const auto material = by.size() - fitted.unknown.size();
  for (Eigen::Index i = 0; i < by.size(); ++i) {
    const FreeEntry& entry = entries[static_cast<std::size_t>(i)];
    if (i >= material) {
      moved.unknown[i - material] += by[i];
      continue;
    }
    ParameterSetting& setting = moved.values.parameters.at(entry.name);
    const double value = entry.is_log ? setting.value * std::exp(std::clamp(by[i], -0.5, 0.5))
                                      : setting.value + by[i];
    setting.value = std::clamp(value, setting.lower, setting.upper);
  }
  return moved;
}

// J'J with the priors of the entries.
Eigen::MatrixXd Information(const Rows& rows) {
  Eigen::MatrixXd information = rows.jacobian.transpose() * rows.jacobian;
  AddPriors(rows.entries, &information);
  return information;
}

// The residuals that a baseline has of a recording that was simulated, and the priors of how far it
// moves; one parameter block, the moves of the free vector from a start. The derivatives are those
// there, or, where `near` is given, those: of a motion nearby, at the cost of a plain simulation.
class RefitCost : public ceres::CostFunction {
 public:
  // target: residuals of the recording's own simulation.
  RefitCost(const FittedScene& start, const RowFrames& frames,
            const std::vector<FreeEntry>& entries, const Eigen::VectorXd& target,
            const RowMajorMatrix* near, const std::atomic<bool>* stop)
      : start_(start),
        frames_(frames),
        entries_(entries),
        target_(target),
        near_(near),
        stop_(stop) {
    set_num_residuals(static_cast<int>(target.size() + Size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int32_t>(Size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::VectorXd> by(parameters[0], Size());
    const bool derivatives = jacobians != nullptr && jacobians[0] != nullptr;
    // The solver asks for a step that it takes twice, the second time with derivatives.
    const bool is_known = last_at_.size() == by.size() && last_at_ == by;
    if (is_known && (!derivatives || near_ != nullptr)) {
      Fill(by, last_, residuals);
      if (derivatives) FillJacobian(*near_, jacobians[0]);
      return true;
    }
    if (stop_ != nullptr && *stop_) return false;
    const FittedScene moved = Moved(start_, entries_, by);
    Pass pass{moved.values, false, false};
    if (derivatives && near_ == nullptr) {
      pass = BaselinePass(moved);
      pass.of_faults = false;
    }
    const std::optional<Rows> rows = EvaluateRows(moved, pass, frames_, {});
    if (!rows) return false;
    last_at_ = by;
    last_ = rows->residuals;
    Fill(by, last_, residuals);
    if (derivatives) FillJacobian(near_ != nullptr ? *near_ : rows->jacobian, jacobians[0]);
    return true;
  }

 private:
  Eigen::Index Size() const { return static_cast<Eigen::Index>(entries_.size()); }
  double Precision(Eigen::Index i) const {
    return 1.0 / entries_[static_cast<std::size_t>(i)].prior_sigma;
  }
  void Fill(const Eigen::VectorXd& by, const Eigen::VectorXd& own, double* residuals) const {
    Eigen::Map<Eigen::VectorXd> r(residuals, num_residuals());
    r.head(target_.size()) = own - target_;
    for (Eigen::Index i = 0; i < Size(); ++i) r[target_.size() + i] = by[i] * Precision(i);
  }
  void FillJacobian(const RowMajorMatrix& own, double* values) const {
    Eigen::Map<RowMajorMatrix> jacobian(values, num_residuals(), Size());
    jacobian.topRows(target_.size()) = own;
    jacobian.bottomRows(Size()).setZero();
    for (Eigen::Index i = 0; i < Size(); ++i) jacobian(target_.size() + i, i) = Precision(i);
  }

  const FittedScene& start_;
  const RowFrames& frames_;
  const std::vector<FreeEntry>& entries_;
  const Eigen::VectorXd& target_;
  const RowMajorMatrix* near_;
  const std::atomic<bool>* stop_;
  mutable Eigen::VectorXd last_at_, last_;
};

struct Refit {
  Eigen::VectorXd by;    // how far the free vector went
  Eigen::VectorXd left;  // residuals, rows
};

// Levenberg-Marquardt from `by`, which becomes where it ends. False where it fails.
bool Solve(RefitCost* cost, int iterations, Eigen::VectorXd* by) {
  ceres::Problem::Options not_ours;
  not_ours.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(not_ours);
  problem.AddResidualBlock(cost, nullptr, by->data());
  constexpr double kEnough = 0.02;  // of the cost
  ceres::Solver::Options options = LevenbergMarquardtOptions(iterations, kEnough);
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;  // of many rows
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.IsSolutionUsable();
}

// Fits the baseline to a recording that was simulated: `target` are the residuals of that
// simulation itself. First by the derivatives at the baseline, which cost nothing more, then by its
// own. Empty where it fails.
std::optional<Refit> FitAgain(const FittedScene& start, const RowFrames& frames,
                              const Rows& baseline, const Eigen::VectorXd& target,
                              Eigen::VectorXd by, const std::atomic<bool>* stop) {
  constexpr int kNearIterations = 6, kOwnIterations = 2;
  const std::vector<FreeEntry>& entries = baseline.entries;
  RefitCost near(start, frames, entries, target, &baseline.jacobian, stop);
  RefitCost own(start, frames, entries, target, nullptr, stop);
  if (!Solve(&near, kNearIterations, &by) || !Solve(&own, kOwnIterations, &by)) return {};
  Eigen::VectorXd residuals(own.num_residuals());
  const double* const at = by.data();
  if (!own.Evaluate(&at, residuals.data(), nullptr)) return {};
  Eigen::VectorXd left = -residuals.head(target.size());
  return Refit{std::move(by), std::move(left)};
}

}  // namespace

FittedScene Finer(const FittedScene& fitted) {
  std::array<int, 2> resolution = fitted.config.resolution;
  if (fitted.scene.mesh.is_grid()) {
    resolution = fitted.scene.mesh.grid;
    for (int& n : resolution) n = 1 + static_cast<int>(std::lround(kFinerMesh * (n - 1)));
  }
  return WithOtherSteps(fitted, resolution, kFinerStep * fitted.scene.step);
}

std::vector<FittedScene> DrawNearFit(const FittedScene& fitted, const Rows& baseline, int count,
                                     std::uint64_t seed) {
  constexpr double kOfPosterior = 0.5;  // sigmas
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Information(baseline));
  const Eigen::MatrixXd root =
      kOfPosterior * eigen.eigenvectors() *
      eigen.eigenvalues().cwiseMax(1e-12).cwiseSqrt().cwiseInverse().asDiagonal();
  NormalNumbers normal(seed, kNearFit);
  std::vector<FittedScene> scenes;
  for (int k = 0; k < count; ++k) {
    Eigen::VectorXd unit(root.cols());
    for (double& u : unit) u = normal.Next();
    scenes.push_back(Moved(fitted, baseline.entries, root * unit));
  }
  return scenes;
}

DiscretisationErrors MeasureDiscretisationErrors(const FittedScene& fitted, const RowFrames& frames,
                                                 const Rows& baseline, int draws,
                                                 std::uint64_t seed,
                                                 const std::atomic<bool>* stop) {
  DiscretisationErrors errors;
  errors.num_rows = frames.num_rows();
  double held_out = 0.0;
  // Mesh and step change about the same wherever they are: a later fit begins where one ended.
  Eigen::VectorXd way = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(baseline.entries.size()));
  for (const FittedScene& drawn : DrawNearFit(fitted, baseline, draws, seed)) {
    if (stop != nullptr && *stop) break;
    const FittedScene finer = Finer(drawn);
    const std::optional<Eigen::VectorXd> seen = ResidualsOfOtherSteps(finer, drawn, frames);
    if (!seen) continue;
    std::optional<Refit> refit = FitAgain(drawn, frames, baseline, *seen, way, stop);
    // A lively cloth can go elsewhere altogether, and then it is no recording like this one.
    constexpr double kLikeThisOne = 3.0;  // times the residuals of the recording itself
    const bool is_alike = refit && refit->left.norm() <= kLikeThisOne * baseline.residuals.norm();
    if (!is_alike) {
      ++errors.num_elsewhere;
      continue;
    }
    way = std::move(refit->by);
    errors.at_draws.push_back(kOfDifference * refit->left);
    const double rms = HeldOutDistance(finer, Moved(drawn, baseline.entries, way));
    held_out += rms * rms;
  }
  if (!errors.at_draws.empty())
    errors.held_out_rms =
        kOfDifference * std::sqrt(held_out / static_cast<double>(errors.at_draws.size()));
  return errors;
}

std::vector<NullResidual> DrawNulls(const Eigen::MatrixXd& gram, Eigen::Index num_rows,
                                    const std::vector<DrawnColumn>& numerical,
                                    const std::vector<DrawnColumn>& faults, int count,
                                    std::uint64_t seed) {
  // Products of unit noise with columns have the Gram matrix as their covariance.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const double least = 1e-10 * std::max(1e-300, roots.maxCoeff());
  const auto rank = static_cast<double>((roots.array() > least).count());
  NormalNumbers normal(seed, kNull);
  std::vector<NullResidual> nulls;
  for (int k = 0; k < count; ++k) {
    Eigen::VectorXd unit(gram.cols());
    for (double& u : unit) u = normal.Next();
    for (Eigen::Index i = 0; i < unit.size(); ++i) {
      if (roots[i] <= least) unit[i] = 0.0;
    }
    const Eigen::VectorXd noise = eigen.eigenvectors() * roots.cwiseProduct(unit);
    Eigen::VectorXd amounts = Eigen::VectorXd::Zero(gram.cols());
    if (!numerical.empty()) {
      // Of either sign: a few simulations do not tell which way all of them would go, and what can
      // only be positive would never be seen in those that happen to go the other.
      const DrawnColumn& error = numerical[normal.Index(numerical.size())];
      const double sign = normal.Index(2) == 0 ? 1.0 : -1.0;
      amounts[error.column] += sign * error.amount * (1.0 + 0.3 * normal.Next());
    }
    for (const DrawnColumn& fault : faults) amounts[fault.column] += fault.amount * normal.Next();
    const Eigen::VectorXd moved = gram * amounts;
    // The part of the noise that no column shares has a chi-squared length.
    const double others = std::max(0.0, static_cast<double>(num_rows) - rank);
    const double rest = std::max(0.0, others + std::sqrt(2.0 * others) * normal.Next());
    NullResidual null;
    null.products = noise + moved;
    null.squared = unit.squaredNorm() + rest + 2.0 * amounts.dot(noise) + amounts.dot(moved);
    nulls.push_back(std::move(null));
  }
  return nulls;
}

}  // namespace clothfit
