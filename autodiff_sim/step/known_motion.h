// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A motion that has been simulated, so that it can be differentiated without being solved for
// again.
#pragma once

#include <vector>

#include "autodiff_sim/step/simulation.h"

namespace clothfit {

class KnownMotion {
 public:
  // Of nothing yet. `key`: all numbers that decide the motion.
  void Begin(const Eigen::VectorXd& key) {
    key_ = key;
    velocities_.clear();
  }
  bool IsOf(const Eigen::VectorXd& key) const { return key_.size() == key.size() && key_ == key; }

  // The next step, after it was made.
  void Add(const StepReport& report, const State& state) {
    velocities_.push_back(report.halvings == 0 ? state.v : Eigen::VectorXd());
  }

  // What Simulation::Advance may be told of a step; null where the motion did not get there, or
  // took parts.
  const Eigen::VectorXd* After(std::size_t step) const {
    return step < velocities_.size() && velocities_[step].size() > 0 ? &velocities_[step] : nullptr;
  }

 private:
  Eigen::VectorXd key_;
  std::vector<Eigen::VectorXd> velocities_;  // 3N a step, m/s
};

}  // namespace clothfit
