// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/force_equations.h"

#include <algorithm>
#include <numeric>

#include <Eigen/QR>

#include "fitting/diagnosis/fitted/faults.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// The camera of each row of a frame; -1 for markers.
std::vector<int> CamerasOfRows(const Scene& scene, int frame) {
  std::vector<int> cameras;
  for (const ResidualSource& s : SourcesOfFrame(scene, frame))
    cameras.push_back(s.kind == ResidualSource::Kind::kMarker ? -1 : s.source);
  return cameras;
}

// The state's derivatives along the leading directions, up to the last block that anything moved.
Eigen::MatrixXd MovedDirections(const Sensitivity& sensitivity) {
  const std::vector<StateLanes>& lanes = sensitivity.lanes();
  std::size_t count = lanes.size();
  while (count > 0 && lanes[count - 1].is_zero) --count;
  const Eigen::Index rows = lanes.empty() ? 0 : lanes.front().x.rows();
  Eigen::MatrixXd moved(rows, static_cast<Eigen::Index>(count) * kLanes);
  for (std::size_t b = 0; b < count; ++b)
    moved.middleCols<kLanes>(static_cast<Eigen::Index>(b) * kLanes) = lanes[b].x;
  return moved;
}

}  // namespace

// A frame's residuals, and their derivatives by all particles' positions and by faults.
struct ForceEquations::FrameRows {
  Eigen::MatrixXd by_position, by_faults;  // rows x 3N, rows x faults
  Eigen::MatrixXd right;                   // residuals, then nulls
};

// Right-hand sides for the unknowns themselves rather than for steps (of free entries: steps).
struct ForceEquations::Targets {
  Eigen::MatrixXd fixed, force;
  double sum;
};

ForceEquations::ForceEquations(const Scene& scene, const FitConfig& config,
                               const FreeParameters& free, const ForceLayout& layout,
                               const ResidualForceOptions& options)
    : scene_(scene),
      free_(free),
      layout_(layout),
      options_(options),
      observations_(scene, config),
      motion_(scene, config, free, layout, options.stop),
      frames_(options.frames),
      first_row_(scene.is_fitted.size(), -1),
      num_faults_(static_cast<int>(options.fault_sigmas.size())) {
  if (frames_.empty()) {
    for (int f = 0; f <= scene.last_fitted_frame; ++f) {
      if (scene.is_fitted[f]) frames_.push_back(f);
    }
  }
  for (const int f : frames_) {
    first_row_[f] = num_rows_;
    num_rows_ += observations_.Count(f);
  }
}

NormalSums ForceEquations::Empty() const {
  const Eigen::Index size = num_fixed() + layout_.size();
  return {Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, 1 + options_.nulls.cols()),
          0.0, 0.0};
}

bool ForceEquations::Evaluate(int frame, const State& state, const ForceUnknowns& at,
                              FrameRows* rows) const {
  const Eigen::Index size = state.x.size(), count = observations_.Count(frame);
  // With every position a direction of its own the residuals' Jacobian is that by positions.
  Sensitivity each(state, Eigen::MatrixXd::Zero(1, size));
  each.SetInitial(Eigen::MatrixXd::Identity(size, size), Eigen::MatrixXd::Zero(size, size));
  Eigen::VectorXd residuals(count);
  RowMajorMatrix by_position(count, size);
  if (!observations_.Evaluate(frame, state, &each, 0, &residuals, &by_position)) return false;
  rows->by_position = by_position;
  rows->by_faults.resize(count, num_faults_);
  if (num_faults_ > 0) {
    rows->by_faults = options_.faults(frame, state);
    residuals += rows->by_faults * at.faults;
  }
  rows->right.resize(count, 1 + options_.nulls.cols());
  rows->right.col(0) = residuals;
  if (options_.nulls.cols() > 0) {
    rows->right.rightCols(options_.nulls.cols()) =
        options_.nulls.middleRows(first_row_[frame], count);
  }
  return residuals.allFinite() && rows->by_position.allFinite();
}

// Adds chosen rows. `motion`: d positions / d directions of ForcedMotion, the leading ones.
void ForceEquations::Add(const FrameRows& rows, const std::vector<int>& chosen,
                         const Eigen::MatrixXd& motion, NormalSums* sums) const {
  Eigen::MatrixXd by_position = rows.by_position(chosen, Eigen::all);
  Eigen::MatrixXd by_faults = rows.by_faults(chosen, Eigen::all);
  Eigen::MatrixXd right = rows.right(chosen, Eigen::all);
  sums->sum += right.col(0).squaredNorm();
  const Eigen::Index size = by_position.cols() + num_faults_;
  if (by_position.rows() > size) {  // as few rows with the same sums
    Eigen::MatrixXd both(by_position.rows(), size);
    both << by_position, by_faults;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(both);
    right = (qr.householderQ().adjoint() * right).topRows(size).eval();
    const Eigen::MatrixXd upper = qr.matrixQR().topRows(size).triangularView<Eigen::Upper>();
    by_position = upper.leftCols(by_position.cols());
    by_faults = upper.rightCols(num_faults_);
  }
  const Eigen::Index controls =  // lanes may go on beyond the last
      std::min<Eigen::Index>(motion.cols() - motion_.first_control(), layout_.size());
  Eigen::MatrixXd jacobian(by_position.rows(), num_fixed() + controls);
  jacobian.leftCols(free_.size()) = by_position * motion.leftCols(free_.size());
  jacobian.middleCols(free_.size(), num_faults_) = by_faults;
  jacobian.rightCols(controls) = by_position * motion.middleCols(motion_.first_control(), controls);
  const Eigen::Index active = jacobian.cols();
  sums->information.topLeftCorner(active, active)
      .selfadjointView<Eigen::Lower>()
      .rankUpdate(jacobian.transpose());
  sums->data.topRows(active) += jacobian.transpose() * right;
}

std::optional<NormalSums> ForceEquations::Linearise(const ForceUnknowns& at,
                                                    std::vector<NormalSums>* by_source) {
  NormalSums sums = Empty();
  if (by_source != nullptr) by_source->assign(1 + scene_.recording.cameras.size(), NormalSums());
  bool usable = true;
  const auto observe = [&](int frame, const State& state, const Sensitivity* sensitivity) {
    if (!usable || first_row_[frame] < 0) return;
    FrameRows rows;
    usable = Evaluate(frame, state, at, &rows);
    if (!usable || rows.right.rows() == 0) return;
    Eigen::MatrixXd motion = MovedDirections(*sensitivity);
    if (motion.cols() < motion_.first_control()) {
      motion.conservativeResizeLike(Eigen::MatrixXd::Zero(state.x.size(), motion_.first_control()));
    }
    std::vector<int> all(static_cast<std::size_t>(rows.right.rows()));
    std::iota(all.begin(), all.end(), 0);
    Add(rows, all, motion, &sums);
    sums.rows += observations_.NumObserved(frame, frame);
    if (by_source == nullptr) return;
    const std::vector<int> cameras = CamerasOfRows(scene_, frame);
    for (std::size_t s = 0; s < by_source->size(); ++s) {
      std::vector<int> own;
      for (const int row : all) {
        if (cameras[row] + 1 == static_cast<int>(s)) own.push_back(row);
      }
      if (own.empty()) continue;
      NormalSums& source = (*by_source)[s];
      if (source.information.size() == 0) source = Empty();
      Add(rows, own, motion, &source);
      source.rows += static_cast<double>(own.size());
    }
  };
  if (!motion_.Run(at.theta, at.force, last_frame(), true, observe) || !usable) return {};
  return sums;
}

std::optional<double> ForceEquations::Sum(const ForceUnknowns& at, std::vector<Eigen::VectorXd>* x,
                                          std::vector<Eigen::VectorXd>* v) {
  double sum = 0.0;
  bool usable = true;
  const auto observe = [&](int frame, const State& state, const Sensitivity*) {
    if (x != nullptr) x->push_back(state.x);
    if (v != nullptr) v->push_back(state.v);
    if (!usable || first_row_[frame] < 0) return;
    Eigen::VectorXd residuals(observations_.Count(frame));
    usable = observations_.Evaluate(frame, state, nullptr, 0, &residuals, nullptr);
    if (usable && num_faults_ > 0) residuals += options_.faults(frame, state) * at.faults;
    sum += residuals.squaredNorm();
  };
  if (!motion_.Run(at.theta, at.force, last_frame(), false, observe) || !usable) return {};
  return sum;
}

double ForceEquations::PriorSum(const ForceUnknowns& at) const {
  return free_.PriorResiduals(at.theta).squaredNorm() +
         at.faults.cwiseQuotient(options_.fault_sigmas).squaredNorm();
}

Eigen::LLT<Eigen::MatrixXd> ForceEquations::FixedFactor(const NormalSums& sums) const {
  const Eigen::Index p = free_.size();
  Eigen::MatrixXd fixed =
      sums.information.topLeftCorner(num_fixed(), num_fixed()).selfadjointView<Eigen::Lower>();
  fixed.topLeftCorner(p, p) += free_.prior_jacobian().transpose() * free_.prior_jacobian();
  fixed.diagonal().tail(num_faults_) += options_.fault_sigmas.cwiseAbs2().cwiseInverse();
  return Cholesky(fixed, "the information on material parameters, start and faults");
}

// Around `at` the residuals are r + J (z - z_at) with z = (step of theta, faults, force), so that
// z solves the least squares of J z against -(r - J z_at).
ForceEquations::Targets ForceEquations::MakeTargets(const NormalSums& sums,
                                                    const ForceUnknowns& at) const {
  Eigen::VectorXd here = Eigen::VectorXd::Zero(num_fixed() + layout_.size());
  here.segment(free_.size(), num_faults_) = at.faults;
  here.tail(layout_.size()) = at.force;
  const Eigen::VectorXd moved = sums.information.selfadjointView<Eigen::Lower>() * here;
  Eigen::MatrixXd right = -sums.data;
  right.col(0) += moved;
  const Eigen::VectorXd prior = free_.PriorResiduals(at.theta);
  right.col(0).head(free_.size()) -= free_.prior_jacobian().transpose() * prior;
  const double sum = sums.sum - 2.0 * here.dot(sums.data.col(0)) + here.dot(moved);
  return {right.topRows(num_fixed()), right.bottomRows(layout_.size()), sum + prior.squaredNorm()};
}

LinearSystem ForceEquations::Eliminate(const NormalSums& sums, const ForceUnknowns& at) const {
  const Targets targets = MakeTargets(sums, at);
  const Eigen::Index controls = layout_.size();
  LinearSystem system;
  system.information = sums.information.bottomRightCorner(controls, controls);
  system.data = targets.force;
  system.sum = targets.sum;
  system.rows = sums.rows;
  if (num_fixed() == 0) return system;
  const Eigen::LLT<Eigen::MatrixXd> factor = FixedFactor(sums);
  // Rows of L^-1 B and L^-1 g, of which B'A^-1 B and B'A^-1 g are products.
  const Eigen::MatrixXd cross =
      factor.matrixL().solve(sums.information.bottomLeftCorner(controls, num_fixed()).transpose());
  const Eigen::MatrixXd fixed = factor.matrixL().solve(targets.fixed);
  system.information.selfadjointView<Eigen::Lower>().rankUpdate(cross.transpose(), -1.0);
  system.data -= cross.transpose() * fixed;
  system.sum -= fixed.col(0).squaredNorm();
  return system;
}

ForceUnknowns ForceEquations::Complete(const NormalSums& sums, const ForceUnknowns& at,
                                       const Eigen::VectorXd& force) const {
  ForceUnknowns result = {at.theta, at.faults, force};
  if (num_fixed() == 0) return result;
  const Targets targets = MakeTargets(sums, at);
  const Eigen::VectorXd right =
      targets.fixed.col(0) -
      sums.information.bottomLeftCorner(layout_.size(), num_fixed()).transpose() * force;
  const Eigen::VectorXd fixed = FixedFactor(sums).solve(right);
  result.theta =
      (at.theta + fixed.head(free_.size())).cwiseMax(free_.lower()).cwiseMin(free_.upper());
  result.faults = fixed.tail(num_faults_);
  return result;
}

}  // namespace clothfit
