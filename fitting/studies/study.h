// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A study: a list of independent jobs, and the tables and pictures that are made of their results.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fitting/jobs/job.h"
#include "fitting/studies/study_fit.h"
#include "fitting/studies/study_options.h"

namespace clothfit {

struct StudyPlace {
  std::filesystem::path folder;      // of the study
  std::filesystem::path recordings;  // of its recordings, which others may share
};

struct Study {
  std::string name, doc;  // of the command, one line
  // What --values are: name, unit and meaning; empty where there are none.
  std::string values;
  // Those that are asked for, or the list of the size.
  std::function<std::vector<double>(const StudyOptions&)> values_of;
  bool uses_recordings = true;
  std::function<std::vector<Job>(const StudyOptions&)> jobs;
  // Does one of them. Empty: RunStudyFit.
  std::function<nlohmann::json(const StudyOptions&, const Job&, const JobContext&)> work;
  std::vector<std::string> files;  // of its report beside NAME.md, NAME.csv, NAME.svg and NAME.png
  // Writes NAME.csv and pictures into the folder and returns the table, as Markdown. Of the same
  // results it makes the same files. `results` are in the order of the jobs, those without a
  // problem.
  std::function<std::string(const StudyOptions&, const std::vector<Job>&,
                            const std::vector<JobResult>&, const StudyPlace&)>
      report;
};

// One a file of this folder.
Study AttractionStudy();
Study AugmentedStudy();
Study CameraStudy();
Study LocalParameterStudy();
Study RuntimeStudy();
Study OptimiserStudy();
Study ReconstructionStudy();
Study GradientStudy();
Study ContactStudy();

// All of the above.
std::vector<Study> Studies();

// A fit and what came of it.
struct DoneFit {
  StudyFit fit;
  StudyFitResult result;
};
std::vector<DoneFit> DoneFits(const std::vector<Job>& jobs, const std::vector<JobResult>& results);

// The first that `matches`; null where there is none.
const DoneFit* FindFit(const std::vector<DoneFit>& fits,
                       const std::function<bool(const StudyFit&)>& matches);

// The values asked for, else these.
std::vector<double> ValuesOr(const StudyOptions& options, std::vector<double> reduced,
                             std::vector<double> full);

}  // namespace clothfit
