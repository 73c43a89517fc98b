// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a fit of several recordings: what they share, and a run of each.
#pragma once

#include <string>
#include <vector>

#include "fitting/fit/fit.h"
#include "fitting/runs/recording_list.h"
#include "fitting/runs/run_folder.h"

namespace clothfit {

// A recording that is made ready; FitConfig::hold_out says whether it is fitted.
struct JointRecording {
  std::string name;
  FitConfig config;
  Scene scene;
};

// Throws InputError where they cannot be fitted together: see CheckJoint. As CheckFittable, where
// they take more memory together than there is.
void CheckFittableTogether(const std::vector<JointRecording>& recordings);

// RunJointFit with everything written, as FitIntoRun does: the checkpoint, log and summary into the
// run, the config, trajectory and all else of each recording into its own, parameters of those that
// are fitted after every accepted step. Those that are held out are predicted.
// FitResult::recordings has all of them, in their order.
FitResult FitIntoJointRun(const std::vector<JointRecording>& recordings, const RunFolder& run,
                          const FitCallbacks& callbacks, bool resume);

}  // namespace clothfit
