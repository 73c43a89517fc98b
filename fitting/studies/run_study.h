// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a study in a folder, alone or as one of many processes that run the same one.
#pragma once

#include <string>

#include "fitting/jobs/folder.h"
#include "fitting/jobs/run_jobs.h"
#include "fitting/studies/study.h"

namespace clothfit {

struct StudyRunOptions {
  JobRunOptions jobs;  // the folder is the study's own
  JobFolderOptions folder;
  std::function<void(const std::string& stage)> stage;  // what is being done now
};

struct StudyRun {
  std::string table;  // Markdown
  bool complete = false;
  int num_problems = 0;  // jobs that failed; the table is without them
  std::string first_problem;
  int num_hanging = 0;  // see JobRunResult

  // What came of one more list of jobs.
  void Add(const JobRunResult& result);
};

// Makes the recordings that are missing, does the jobs, writes table and pictures. The folder then
// has study.json (what decides the numbers), jobs/ (a result each), NAME.csv, NAME.md and pictures.
// Throws InputError where the folder holds a study already, unless it is to be replaced (force) or
// gone on with (resume, of the same options).
StudyRun RunStudy(const Study& study, const StudyOptions& options, const StudyPlace& place,
                  const StudyRunOptions& run);

}  // namespace clothfit
