// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The options of clothfit fit, and what fits of one recording and of several do alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/options/config.h"
#include "apps/options/tracking.h"
#include "fitting/runs/run_folder.h"

namespace clothfit {

struct FitOptions {
  ConfigOptions config;
  std::vector<std::string> recordings, hold_out;
  TrackingOptions tracking;  // where there are pictures only
  std::string run;           // empty: runs/NAME
  std::optional<double> window;
  std::optional<int> initial_order, max_iterations;
  std::optional<double> alpha, beta, max_simulations;
  std::optional<std::string> strategy, optimiser;
  std::optional<int> finest;
  FramesOptions frames;
  std::optional<LossKind> loss;
  bool no_polish = false, attract = false, force = false, resume = false;
  bool quiet = false;
};

// Over what the config options say; then all is checked.
void ApplyOptions(const FitOptions& options, FitConfig* config);

bool HasPicturesOnly(const Recording& recording);

// What is seen in the pictures becomes a recording of its own, inside the run. Empty where it was
// interrupted, which is told.
std::optional<Recording> TrackIntoRun(const Recording& recording, const RunFolder& run,
                                      const FitOptions& options);

// How a fit that is written ends: a word on what to do next, and the exit status. Throws where the
// fit has failed.
int EndOfFit(const FitResult& result, const RunFolder& run, bool quiet);

// clothfit fit A B ...
bool IsOfSeveral(const FitOptions& options);
int RunFitOfSeveral(const FitOptions& options);

}  // namespace clothfit
