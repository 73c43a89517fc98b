// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/recalled_evaluation.h"

#include <cstring>
#include <type_traits>

namespace clothfit {
namespace {

static_assert(std::is_trivially_copyable_v<StepReport>, "kept as its bytes");
constexpr Eigen::Index kStepNumbers = (sizeof(StepReport) + sizeof(double) - 1) / sizeof(double);
constexpr Eigen::Index kHead = 4 + kStepNumbers;  // usable, two counts, number of residuals, steps

struct Evaluated {
  bool is_usable = false;
  FrameCounts work;
  StepReport steps;
};

Eigen::VectorXd Pack(const Evaluated& evaluated, const Eigen::VectorXd& residuals,
                     const RowMajorMatrix* jacobian) {
  const Eigen::Index rows = evaluated.is_usable ? residuals.size() : 0;
  const Eigen::Index of_jacobian =
      evaluated.is_usable && jacobian != nullptr ? jacobian->size() : 0;
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(kHead + rows + of_jacobian);
  numbers.head<4>() << (evaluated.is_usable ? 1.0 : 0.0), evaluated.work.simulated,
      evaluated.work.differentiated, static_cast<double>(rows);
  std::memcpy(&numbers[4], &evaluated.steps, sizeof(StepReport));
  numbers.segment(kHead, rows) = residuals.head(rows);
  if (of_jacobian > 0)
    numbers.tail(of_jacobian) = Eigen::Map<const Eigen::VectorXd>(jacobian->data(), of_jacobian);
  return numbers;
}

Evaluated Unpack(const Eigen::VectorXd& numbers, Eigen::Index columns, Eigen::VectorXd* residuals,
                 RowMajorMatrix* jacobian) {
  Evaluated evaluated;
  evaluated.is_usable = numbers[0] == 1.0;
  evaluated.work = {numbers[1], numbers[2]};
  std::memcpy(static_cast<void*>(&evaluated.steps), &numbers[4], sizeof(StepReport));
  const Eigen::Index rows = static_cast<Eigen::Index>(numbers[3]);
  *residuals = numbers.segment(kHead, rows);
  if (jacobian != nullptr && evaluated.is_usable)
    *jacobian = Eigen::Map<const RowMajorMatrix>(numbers.data() + kHead + rows, rows, columns);
  return evaluated;
}

}  // namespace

bool RecalledEvaluation::operator()(const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                                    RowMajorMatrix* jacobian) {
  if (journal_ == nullptr) return Simulate(at, residuals, jacobian);
  const std::string name = name_ + (jacobian != nullptr ? ", derivatives" : "");
  if (const auto numbers = journal_->Recall(name, at)) {
    const Evaluated evaluated = Unpack(*numbers, at.size(), residuals, jacobian);
    recalled_->simulated += evaluated.work.simulated;
    recalled_->differentiated += evaluated.work.differentiated;
    steps_ = evaluated.steps;
    if (jacobian == nullptr) only_recalled_ = at;
    return evaluated.is_usable;
  }
  if (jacobian != nullptr) WarmUp(at);
  only_recalled_.resize(0);
  const FrameCounts before = simulated_.work();
  const bool is_usable = Simulate(at, residuals, jacobian);
  if (stop_ != nullptr && *stop_) return is_usable;  // it may have ended early
  const FrameCounts now = simulated_.work();
  const FrameCounts work{now.simulated - before.simulated,
                         now.differentiated - before.differentiated};
  journal_->Add(name, at, Pack({is_usable, work, steps_}, *residuals, jacobian));
  return is_usable;
}

bool RecalledEvaluation::Simulate(const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                                  RowMajorMatrix* jacobian) {
  const bool is_usable = simulated_.evaluate(at, residuals, jacobian);
  steps_ = simulated_.last_steps();
  return is_usable;
}

void RecalledEvaluation::WarmUp(const Eigen::VectorXd& at) {
  if (only_recalled_.size() != at.size() || only_recalled_ != at) return;
  const FrameCounts before = simulated_.work();
  Eigen::VectorXd unused;
  simulated_.evaluate(at, &unused, nullptr);
  recalled_->simulated -= simulated_.work().simulated - before.simulated;
}

}  // namespace clothfit
