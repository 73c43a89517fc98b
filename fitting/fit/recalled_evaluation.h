// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>

#include "autodiff_sim/step/simulation.h"
#include "fitting/files/evaluation_journal.h"
#include "fitting/optimise/simulation_cost.h"

namespace clothfit {

// Frames simulated, and how many of them with derivatives.
struct FrameCounts {
  double simulated = 0.0, differentiated = 0.0;
};

// Residuals and their Jacobian, simulated or as a journal has them; the same bits either way. A
// simulator differentiates the motion that it simulated last: where that was only recalled, it is
// simulated once more before.
class RecalledEvaluation {
 public:
  struct Simulated {
    SimulationCost::Evaluator evaluate;
    std::function<FrameCounts()> work;       // of the simulators, so far
    std::function<StepReport()> last_steps;  // of the last evaluation
  };
  // journal: null for none. `name`: nothing else in the journal has it. `recalled` is added what
  // was recalled, and less what was simulated for the second time.
  RecalledEvaluation(EvaluationJournal* journal, std::string name, Simulated simulated,
                     const std::atomic<bool>* stop, FrameCounts* recalled)
      : journal_(journal),
        name_(std::move(name)),
        simulated_(std::move(simulated)),
        stop_(stop),
        recalled_(recalled) {}

  bool operator()(const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian);
  const StepReport& steps() const { return steps_; }

 private:
  bool Simulate(const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian);
  void WarmUp(const Eigen::VectorXd& at);

  EvaluationJournal* journal_;
  std::string name_;
  Simulated simulated_;
  const std::atomic<bool>* stop_;
  FrameCounts* recalled_;
  StepReport steps_;
  Eigen::VectorXd only_recalled_;  // whose motion the simulator does not have
};

}  // namespace clothfit
