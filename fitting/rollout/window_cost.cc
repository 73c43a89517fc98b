// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Evaluation of a window.
#include "fitting/rollout/window_cost.h"

#include <cmath>
#include <optional>

#include "fitting/optimise/checked_factor.h"
#include "fitting/residuals/marker_places.h"
#include "fitting/residuals/node_sums.h"

namespace clothfit {

namespace {

// Sums up [J r]'[J r], from which rows with the same sums follow.
class RowCompressor {
 public:
  RowCompressor(const ClothMesh& mesh, int columns)
      : of_frame_(mesh), sums_(Eigen::MatrixXd::Zero(columns + 1, columns + 1)) {}

  // sensitivity: null without derivatives
  void Add(const std::vector<PointResidual>& residuals, const Sensitivity* sensitivity) {
    if (sensitivity == nullptr) {
      for (const PointResidual& r : residuals)
        sums_.bottomRightCorner<1, 1>()(0) += r.value * r.value;
      return;
    }
    of_frame_.Set(residuals);
    of_frame_.AddTo(*sensitivity, &sums_);
  }

  void TakeOut(const MarkerPlaces& places) { places.TakeOutOfSums(&sums_); }

  // False where what was added is of no use.
  bool Finish(Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) const {
    const Eigen::Index n = sums_.rows() - 1;
    residuals->setZero(n + 1);
    if (jacobian == nullptr) {
      (*residuals)[0] = std::sqrt(sums_(n, n));
      return true;
    }
    // P'LDL'P, as columns that nothing depends on are zero.
    const auto factor = TrySemidefinite(sums_);
    if (!factor) return false;
    const Eigen::VectorXd root = factor->vectorD().cwiseMax(0.0).cwiseSqrt();
    Eigen::MatrixXd columns = Eigen::MatrixXd(factor->matrixL()) * root.asDiagonal();
    columns = factor->transpositionsP().transpose() * columns;
    const Eigen::MatrixXd rows = columns.transpose();
    *jacobian = rows.leftCols(n);
    *residuals = rows.col(n);
    return true;
  }

 private:
  NodeSums of_frame_;
  Eigen::MatrixXd sums_;  // lower triangle
};

}  // namespace

WindowSimulator::Outcome EvaluateWindow(WindowSimulator* simulator,
                                        const ObservationResiduals& observations,
                                        const WindowStart& start, const Eigen::VectorXd& theta,
                                        int first, int last, WindowRows rows,
                                        Eigen::VectorXd* residuals, RowMajorMatrix* jacobian,
                                        WindowStart* end) {
  const bool all = rows == WindowRows::kAll;
  const int count = all ? observations.Count(first, last) : 0;
  residuals->resize(count);
  if (jacobian != nullptr) jacobian->resize(count, theta.size());
  RowCompressor compressor(simulator->mesh(), static_cast<int>(theta.size()));
  std::optional<MarkerPlaces> places;
  if (observations.scene().layout_sigma > 0.0)
    places.emplace(observations.scene(), static_cast<int>(theta.size()));
  std::vector<PointResidual> of_frame;
  int row = 0;
  bool usable = true;
  const WindowSimulator::Observer observer = [&](int frame, const State& state,
                                                 const Sensitivity* sensitivity) {
    if (frame < first || !usable) return;
    const Sensitivity* const asked_for = jacobian != nullptr ? sensitivity : nullptr;
    if (!all || places) usable = observations.EvaluateAtPoints(frame, state, &of_frame);
    if (usable && places) places->Add(frame, state.x, of_frame, asked_for, row);
    if (usable && !all) compressor.Add(of_frame, asked_for);
    if (usable && all) {
      usable = observations.Evaluate(frame, state, sensitivity, row, residuals, jacobian);
      row += observations.Count(frame);
    }
  };
  const bool derivatives = jacobian != nullptr || end != nullptr;
  const WindowSimulator::Outcome outcome =
      simulator->Run(start, theta, last, derivatives, observer, end);
  if (outcome != WindowSimulator::Outcome::kComplete) return outcome;
  if (usable && places && all) places->TakeOutOfRows(residuals, jacobian);
  if (usable && places && !all) compressor.TakeOut(*places);
  if (usable && !all) usable = compressor.Finish(residuals, jacobian);
  usable = usable && residuals->allFinite() && (jacobian == nullptr || jacobian->allFinite());
  return usable ? outcome : WindowSimulator::Outcome::kDiverged;
}

LinearCost::LinearCost(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& offset)
    : jacobian_(jacobian), offset_(offset) {
  set_num_residuals(static_cast<int>(jacobian.rows()));
  mutable_parameter_block_sizes()->push_back(static_cast<int>(jacobian.cols()));
}

bool LinearCost::Evaluate(double const* const* parameters, double* residuals,
                          double** jacobians) const {
  const Eigen::Map<const Eigen::VectorXd> theta(parameters[0], jacobian_.cols());
  Eigen::Map<Eigen::VectorXd>(residuals, jacobian_.rows()) = jacobian_ * theta - offset_;
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    Eigen::Map<RowMajorMatrix>(jacobians[0], jacobian_.rows(), jacobian_.cols()) = jacobian_;
  }
  return true;
}

bool EvaluateResiduals(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                       const Eigen::VectorXd& theta, int last_frame, Eigen::VectorXd* residuals,
                       Eigen::MatrixXd* jacobian) {
  WindowSimulator simulator(scene, config, free, false, nullptr);
  const ObservationResiduals observations(scene, config);
  const WindowStart start = simulator.FirstStart(theta);
  const Eigen::VectorXd prior = free.PriorResiduals(theta);
  Eigen::VectorXd observed;
  RowMajorMatrix observed_jacobian;
  if (EvaluateWindow(&simulator, observations, start, theta, 0, last_frame, WindowRows::kAll,
                     &observed, jacobian != nullptr ? &observed_jacobian : nullptr) !=
      WindowSimulator::Outcome::kComplete) {
    return false;
  }
  residuals->resize(observed.size() + prior.size());
  *residuals << observed, prior;
  if (jacobian != nullptr) {
    jacobian->resize(residuals->size(), free.size());
    *jacobian << observed_jacobian, free.prior_jacobian();
  }
  return true;
}

}  // namespace clothfit
