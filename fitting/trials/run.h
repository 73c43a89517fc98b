// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs trials: makes each recording, has it diagnosed, scores the answer.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/diagnosis/fitted/options.h"
#include "fitting/jobs/job.h"
#include "fitting/trials/score.h"

namespace clothfit {

// What is measured: Diagnose, or a stand-in. It may be called from several threads at once.
using DiagnoseFunction = std::function<Diagnosis(
    const Recording& recording, const FitConfig& baseline, const DiagnosisOptions& options)>;

struct TrialRunOptions {
  DiagnosisOptions diagnosis;    // ablations; the seed is each trial's own
  std::filesystem::path folder;  // of recordings, where they have to be on disk
  bool keep_recordings = false;  // write all, and leave them there with their truth
  // Each diagnosis and its log; may be called from several threads at once.
  std::function<void(const Trial& trial, const Diagnosis& diagnosis,
                     const std::vector<std::string>& log)>
      diagnosed;
  bool refit_truth = true;  // find each trial's TrueModelError, which costs a fit
};

// One trial. A diagnosis that throws makes a failed score.
TrialScore RunTrial(const Trial& trial, const DiagnoseFunction& diagnose,
                    const TrialRunOptions& options, const JobContext& context);

// The scores of those that are done.
std::vector<TrialScore> ScoresOf(const std::vector<JobResult>& results);

// One a trial, by its name.
std::vector<Job> TrialJobs(const std::vector<Trial>& trials);

// Runs the trial of a job; the output is its score.
JobWork TrialWork(const std::vector<Trial>& trials, const DiagnoseFunction& diagnose,
                  const TrialRunOptions& options);

// Every trial's name and digest, to be written before any is scored.
std::string CommitmentsAsCsv(const std::vector<Trial>& trials);

}  // namespace clothfit
