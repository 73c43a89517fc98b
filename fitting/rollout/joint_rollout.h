// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One simulation of each of several recordings from its first frame on, as one problem.
#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <vector>

#include "fitting/rollout/joint_scenes.h"
#include "fitting/rollout/window_cost.h"

namespace clothfit {

class JointRollout {
 public:
  static constexpr int kAllFrames = std::numeric_limits<int>::max();

  // attract: see WindowSimulator. The scenes must outlive it.
  JointRollout(const JointScenes& scenes, bool attract, const std::atomic<bool>* stop);

  // The starts of the recordings, which move with the free vector.
  std::vector<WindowStart> FirstStarts(const Eigen::VectorXd& theta) const;

  // Residuals of the fitted observations of frames 0 to `last`, or to the last fitted one,
  // recording after recording, and their Jacobian where it is asked for: a recording is
  // differentiated by its own vector alone. Each in its own job, by all cores; the same numbers for
  // any of them. False where one cannot be simulated.
  bool Evaluate(const std::vector<WindowStart>& starts, const Eigen::VectorXd& theta, int last,
                WindowRows rows, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian);
  // The same from the starts at theta.
  bool Evaluate(const Eigen::VectorXd& theta, WindowRows rows, Eigen::VectorXd* residuals,
                RowMajorMatrix* jacobian) {
    return Evaluate(FirstStarts(theta), theta, kAllFrames, rows, residuals, jacobian);
  }
  // A recording's part of compressed residuals.
  Eigen::VectorXd ResidualsOf(std::size_t recording, const Eigen::VectorXd& residuals) const;
  int NumCompressedRows() const;

  // See WindowSimulator::Hold; entries of the joint vector.
  void Hold(const std::vector<int>& entries);

  WindowSimulator& operator[](std::size_t recording) { return *simulators_[recording]; }
  double simulated_frames() const;
  double differentiated_frames() const;
  StepReport last_report() const;

 private:
  const JointScenes& scenes_;
  std::vector<std::unique_ptr<WindowSimulator>> simulators_;
};

}  // namespace clothfit
