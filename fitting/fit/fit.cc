// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/fit.h"

#include "fitting/fit/fitter.h"
#include "fitting/fit/staged_fit.h"

namespace clothfit {

std::string ToString(FitStatus status) {
  switch (status) {
    case FitStatus::kConverged:
      return "converged";
    case FitStatus::kNotConverged:
      return "not converged";
    case FitStatus::kInterrupted:
      return "interrupted";
    case FitStatus::kFailed:
      return "failed";
  }
  return "unknown";
}

FitResult RunFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks,
                 const FitCheckpoint* resume) {
  return StagedFit(scene, config, callbacks).Run(resume);
}

FitResult AppraiseFit(const Scene& scene, const FitConfig& config, const Eigen::VectorXd& theta) {
  Fitter fitter(scene, config, {});
  fitter.TellMisfit();
  return fitter.At(theta);
}

int SimulateFrames(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                   const Eigen::VectorXd& theta, int last_frame,
                   const std::function<void(int frame, const State& state)>& observer,
                   StepReport* steps) {
  WindowSimulator simulator(scene, config, free, false, nullptr);
  int frames = 0;
  simulator.Run(simulator.FirstStart(theta), theta, last_frame, false,
                [&](int frame, const State& state, const Sensitivity*) {
                  observer(frame, state);
                  ++frames;
                });
  if (steps != nullptr) *steps = simulator.last_report();
  return frames;
}

}  // namespace clothfit
