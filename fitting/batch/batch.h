// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits many recordings, and puts what came of them into one table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/batch/list.h"
#include "fitting/jobs/folder.h"
#include "fitting/jobs/plan.h"

namespace clothfit {

// All that a batch writes into its folder. The description is the list and the files of settings
// that it names.
JobFolderContents BatchContents(const std::vector<BatchFit>& fits, std::string description);

// Of a list with these contents.
JobPlan BatchPlan(JobList list, const std::filesystem::path& folder);

// Fits one into folder/runs/NAME, after tracking into folder/runs/NAME/observations where there are
// pictures only. The run is whole or not there.
nlohmann::json RunBatchFit(const std::filesystem::path& folder, const BatchFit& fit,
                           const JobContext& context);

// batch.csv, parameters.csv (a row a fit and free parameter), and the table, batch.md, which is
// returned. Those that failed are named with their problem.
std::string WriteBatchTables(const std::filesystem::path& folder,
                             const std::vector<JobResult>& results);

}  // namespace clothfit
