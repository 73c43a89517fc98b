// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/trial_jobs.h"

#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/names.h"
#include "fitting/diagnosis/answer/folder.h"
#include "fitting/diagnosis/pipeline/diagnose.h"
#include "fitting/files/sha256.h"
#include "fitting/files/version.h"
#include "fitting/trials/summary.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// What decides the scores. The digest of the labels' digests binds to them before any is scored.
std::string Conditions(const TrialSettings& settings, const std::string& commitments) {
  const auto flag = [](bool value) { return value ? "true" : "false"; };
  return fmt::format(
      "clothfit: {}\nplan: {}\nmatch: '{}'\nsample: {}\nfirst_seed: {}\nseeds: {}\nonly: "
      "[{}]\nframes: {}\n"
      "resolution: {}\nfinest: {}\nsame_generator: {}\nfinite_elements: {}\nproject: "
      "{}\nsimulate_null: {}\n"
      "guide: {}\ntrue_model: {}\ncommitments: {}\n",
      Version(), settings.plan, settings.size.match, settings.size.sample, settings.size.first_seed,
      settings.size.num_seeds, JoinNames(settings.size.only), settings.size.frame_count,
      settings.size.resolution, settings.finest_side, flag(settings.size.same_generator),
      flag(settings.size.finite_elements), flag(!settings.no_projection),
      flag(!settings.table_null), flag(!settings.no_guide), flag(!settings.no_true_model),
      Sha256(commitments));
}

TrialRunOptions HowToRun(const TrialSettings& settings, const fs::path& folder) {
  TrialRunOptions run;
  run.diagnosis.finest_side = settings.finest_side;
  run.diagnosis.project = !settings.no_projection;
  run.diagnosis.simulate_null = !settings.table_null;
  run.diagnosis.nudge = !settings.no_guide;
  run.folder = folder / "recordings";
  run.keep_recordings = settings.keep_recordings;
  if (settings.keep_diagnoses) {
    run.diagnosed = [folder](const Trial& trial, const Diagnosis& diagnosis,
                             const std::vector<std::string>& log) {
      const DiagnosisFolder kept(folder / "diagnoses" / trial.name,
                                 DiagnosisFolder::Existing::kReplace);
      for (const std::string& line : log) kept.AppendLog(line);
      kept.Write(diagnosis);
    };
  }
  run.refit_truth = !settings.no_true_model;
  return run;
}

}  // namespace

FolderLock PrepareTrials(const TrialSettings& settings, const std::vector<Trial>& trials,
                         const fs::path& folder, Existing existing) {
  const std::string commitments = CommitmentsAsCsv(trials);
  JobFolderContents contents;
  contents.kind = FolderKind::kTrials;
  contents.list = {"trials", settings, TrialJobs(trials)};
  contents.file = "conditions.yaml";
  contents.description = Conditions(settings, commitments);
  contents.files = {"commitments.csv", "trials.csv", "trials.md"};
  for (const Trial& trial : trials) {
    contents.files.push_back("recordings/" + trial.name + "/");
    contents.files.push_back("diagnoses/" + trial.name + "/");
  }
  FolderLock lock = PrepareJobFolder(folder, contents, existing);
  WriteWholeFile(folder / "commitments.csv", commitments);
  return lock;
}

JobPlan PlanOfTrials(JobList list, const fs::path& folder) {
  const auto settings = list.options.get<TrialSettings>();
  JobPlan plan;
  plan.list = std::move(list);
  plan.work = TrialWork(MakeTrialPlan(kJobListFile, settings.plan, settings.size), Diagnose,
                        HowToRun(settings, folder));
  plan.report = [folder](const std::vector<JobResult>& results) {
    const std::vector<TrialScore> scores = ScoresOf(results);
    WriteWholeFile(folder / "trials.csv", ScoresAsCsv(scores));
    WriteWholeFile(folder / "trials.md", ScoresAsMarkdown(scores));
    return ScoresAsMarkdown(scores);
  };
  plan.reports_partly = true;
  return plan;
}

}  // namespace clothfit
