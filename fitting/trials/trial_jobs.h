// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Trials as a list of jobs in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/jobs/folder.h"
#include "fitting/jobs/plan.h"
#include "fitting/trials/run.h"

namespace clothfit {

// Which trials, and how they are diagnosed.
struct TrialSettings {
  std::string plan;
  TrialPlanOptions size;
  int finest_side = DiagnosisOptions().finest_side;
  bool no_projection = false, table_null = false, no_guide = false;
  bool no_true_model = false;
  bool keep_recordings = false, keep_diagnoses = false;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrialSettings, plan, size, finest_side, no_projection,
                                   table_null, no_guide, no_true_model, keep_recordings,
                                   keep_diagnoses)

// Makes the folder and writes down what is to be found in it. `trials`: those of the settings.
FolderLock PrepareTrials(const TrialSettings& settings, const std::vector<Trial>& trials,
                         const std::filesystem::path& folder, Existing existing);

// What was prepared there. Its report writes trials.csv and trials.md, of those that are done.
JobPlan PlanOfTrials(JobList list, const std::filesystem::path& folder);

}  // namespace clothfit
