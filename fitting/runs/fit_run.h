// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits and simulations that leave a run folder.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fitting/fit/fit.h"
#include "fitting/fit/search.h"
#include "fitting/runs/run_folder.h"

namespace clothfit {

// Throws InputError where handles lie so close that they hold the same particle.
void CheckSimulable(const Scene& scene);

// Throws InputError where contact cannot begin as config and recording say: see
// Simulation::CheckStart.
void CheckContact(const Scene& scene, const FitConfig& config);

// As CheckSimulable(), where the scene has nothing that a fit could go by, and where a fit takes
// more memory than there is.
void CheckFittable(const Scene& scene, const FitConfig& config);

// Names of the handles whose paths are not known and, in held-out frames after the fitted ones, are
// not found either: what is predicted there says nothing.
std::vector<std::string> HandlesUnknownInHeldOutFrames(const Scene& scene);

// Throws InputError, naming what differs, where a run is not of this config: it cannot be resumed.
// A fit that is given fewer iterations or simulations goes the same way as far as it goes.
void RequireSameConfig(const RunFolder& run, const Recording& recording, const FitConfig& config);

// A fit's results into the run, but for the config: parameters, trajectory, summary. Returns what
// the steps of the trajectory took.
StepReport WriteResults(const Scene& scene, const FitConfig& config, const FitResult& result,
                        const RunFolder& run);

// The same of a fit that is over, with its last lines in the log.
void WriteFit(const Scene& scene, const FitConfig& config, const FitResult& result,
              const RunFolder& run);

// The parameters of a fit that goes on into its run: intervals are not known yet.
void WriteParametersSoFar(const FreeParameters& free, const Eigen::VectorXd& theta,
                          const RunFolder& run);

// FitOnChosenMesh with everything written into the run: config and log at once, the checkpoint and
// the parameters (without intervals) after every accepted step, a whole run before another start or
// a finer mesh is tried, the results at the end. The checkpoint stays behind where more can be had:
// after an interruption, or when the iterations were used up. `callbacks` are called too, but
// for those that keep what there is.
// `resume` goes on from the run's own checkpoint, or from the beginning where it has none yet.
FitOnMesh FitIntoRun(const Scene& scene, const FitConfig& config, const RunFolder& run,
                     const FitCallbacks& callbacks, bool resume);

// The frame of both: the log and the checkpoint of a fit that `fit` does and whose results `write`
// writes.
FitResult FitWithCheckpoint(const RunFolder& run, const FitCallbacks& callbacks, bool resume,
                            const std::function<FitResult(const FitCallbacks&)>& fit,
                            const std::function<void(const FitResult&)>& write);

// Simulates frames 0 to last_frame from the config's own values, open loop, and writes config,
// trajectory, mesh and residuals, and what contact took into the log. Returns the number of frames
// reached; `steps`, where given, gets what they took.
int SimulateIntoRun(const Scene& scene, const FitConfig& config, const RunFolder& run,
                    int last_frame, StepReport* steps = nullptr);

// What contact did, in one line; empty where there is none to follow.
std::string DescribeContact(const Scene& scene, const FitConfig& config, const StepReport& steps);

}  // namespace clothfit
