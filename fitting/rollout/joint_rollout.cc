// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/joint_rollout.h"

#include <algorithm>

#include "autodiff_sim/base/parallel.h"

namespace clothfit {

JointRollout::JointRollout(const JointScenes& scenes, bool attract, const std::atomic<bool>* stop)
    : scenes_(scenes) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto& [scene, config, free, observations] = scenes[i];
    simulators_.push_back(std::make_unique<WindowSimulator>(scene, config, free, attract, stop));
  }
}

std::vector<WindowStart> JointRollout::FirstStarts(const Eigen::VectorXd& theta) const {
  std::vector<WindowStart> starts;
  for (std::size_t i = 0; i < scenes_.size(); ++i)
    starts.push_back(simulators_[i]->FirstStart(scenes_.free().Of(i, theta)));
  return starts;
}

bool JointRollout::Evaluate(const std::vector<WindowStart>& starts, const Eigen::VectorXd& theta,
                            int last, WindowRows rows, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
  struct Rows {
    Eigen::VectorXd residuals;
    RowMajorMatrix jacobian;
  };
  std::vector<Rows> of_each(scenes_.size());
  std::atomic<bool> is_complete = true;
  ParallelFor(static_cast<int>(scenes_.size()), NumThreads(0), [&](int piece, int) {
    const auto i = static_cast<std::size_t>(piece);
    if (!is_complete) return;
    const JointScenes::Part& part = scenes_[i];
    const WindowSimulator::Outcome outcome = EvaluateWindow(
        simulators_[i].get(), part.observations, starts[i], scenes_.free().Of(i, theta), 0,
        std::min(last, part.scene.last_fitted_frame), rows, &of_each[i].residuals,
        jacobian != nullptr ? &of_each[i].jacobian : nullptr);
    if (outcome != WindowSimulator::Outcome::kComplete) is_complete = false;
  });
  if (!is_complete) return false;
  Eigen::Index count = 0;
  for (const Rows& one : of_each) count += one.residuals.size();
  residuals->resize(count);
  if (jacobian != nullptr) jacobian->setZero(count, scenes_.free().size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < of_each.size(); ++i) {
    residuals->segment(row, of_each[i].residuals.size()) = of_each[i].residuals;
    if (jacobian != nullptr) scenes_.free().PutColumns(i, of_each[i].jacobian, row, jacobian);
    row += of_each[i].residuals.size();
  }
  return true;
}

Eigen::VectorXd JointRollout::ResidualsOf(std::size_t recording,
                                          const Eigen::VectorXd& residuals) const {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < recording; ++i) first += scenes_[i].free.size() + 1;
  return residuals.segment(first, scenes_[recording].free.size() + 1);
}

int JointRollout::NumCompressedRows() const {
  int count = 0;
  for (std::size_t i = 0; i < scenes_.size(); ++i) count += scenes_[i].free.size() + 1;
  return count;
}

void JointRollout::Hold(const std::vector<int>& entries) {
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const std::vector<int>& of_each = scenes_.free().EntriesOf(i);
    std::vector<int> own;
    for (std::size_t k = 0; k < of_each.size(); ++k)
      if (std::find(entries.begin(), entries.end(), of_each[k]) != entries.end())
        own.push_back(static_cast<int>(k));
    simulators_[i]->Hold(own);
  }
}

double JointRollout::simulated_frames() const {
  double frames = 0.0;
  for (const auto& simulator : simulators_) frames += simulator->simulated_frames();
  return frames;
}

double JointRollout::differentiated_frames() const {
  double frames = 0.0;
  for (const auto& simulator : simulators_) frames += simulator->differentiated_frames();
  return frames;
}

StepReport JointRollout::last_report() const {
  StepReport report = simulators_.front()->last_report();
  for (std::size_t i = 1; i < simulators_.size(); ++i) report += simulators_[i]->last_report();
  return report;
}

}  // namespace clothfit
