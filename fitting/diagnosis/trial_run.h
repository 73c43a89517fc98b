// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs trials: makes each recording, has it diagnosed, scores the answer.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <vector>

#include "fitting/diagnosis/trial_score.h"

namespace clothfit {

// What is measured: Diagnose, or a stand-in. It may be called from several threads at once.
using Diagnoser = std::function<Diagnosis(const Recording& recording, const FitConfig& baseline,
                                          const DiagnosisOptions& options)>;

struct TrialRunOptions {
  DiagnosisOptions diagnosis;    // ablations; the seed is each trial's own
  std::filesystem::path folder;  // of recordings, where they have to be on disk
  bool keep_recordings = false;  // write all, and leave them there with their truth
  // Each diagnosis and its log; may be called from several threads at once.
  std::function<void(const Trial& trial, const Diagnosis& diagnosis,
                     const std::vector<std::string>& log)>
      diagnosed;
  bool refit_truth = true;  // find each trial's TrueModelError, which costs a fit
  int num_threads = 1;      // trials at the same time; no influence on the scores
  const std::atomic<bool>* stop = nullptr;
  // From one thread at a time: the scores so far, in the plan's order, after each trial.
  std::function<void(const std::vector<TrialScore>&)> done;
};

// One trial. A diagnosis that throws makes a failed score.
TrialScore RunTrial(const Trial& trial, const Diagnoser& diagnose, const TrialRunOptions& options);

// Runs what `done_before` does not hold already, by name. Trials that were stopped are no part of
// the result. In the plan's order.
std::vector<TrialScore> RunTrials(const std::vector<Trial>& trials, const Diagnoser& diagnose,
                                  const TrialRunOptions& options,
                                  const std::vector<TrialScore>& done_before = {});

// Every trial's name and digest, to be written before any is scored.
std::string CommitmentsAsCsv(const std::vector<Trial>& trials);

}  // namespace clothfit
