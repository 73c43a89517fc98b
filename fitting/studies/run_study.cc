// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/run_study.h"

#include "fitting/files/version.h"
#include "fitting/jobs/ledger.h"
#include "fitting/studies/study_recording.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::string Description(const Study& study, const StudyOptions& options) {
  const nlohmann::json json = {
      {"study", study.name}, {"clothfit", Version()}, {"options", ToJson(options)}};
  return json.dump(1) + "\n";
}

JobRunResult MakeRecordings(const StudyOptions& options, const StudyPlace& place,
                            const StudyRunOptions& run) {
  std::vector<Job> jobs;
  for (const std::string& experiment : options.experiments)
    jobs.push_back(RecordingJob(options, experiment));
  JobRunOptions job_options = run.jobs;
  job_options.folder = place.recordings / "jobs";
  return RunJobs(
      jobs,
      [folder = place.recordings](const Job& job, const JobContext& context) {
        return MakeStudyRecording(folder, job, context);
      },
      job_options);
}

JobRunResult DoJobs(const Study& study, const StudyOptions& options, const StudyPlace& place,
                    const std::vector<Job>& jobs, const StudyRunOptions& run) {
  JobRunOptions job_options = run.jobs;
  job_options.folder = place.folder / "jobs";
  const JobWork work = [study, options, place](const Job& job, const JobContext& context) {
    if (study.work) return study.work(options, job, context);
    return RunStudyFit(place.recordings, options, job, context);
  };
  return RunJobs(jobs, work, job_options);
}

// Fit after fit, each by all processes together.
JobRunResult DoJobsTogether(const StudyOptions& options, const StudyPlace& place,
                            const std::vector<Job>& jobs, const StudyRunOptions& run) {
  const fs::path folder = place.folder / "jobs";
  JobLedger ledger(folder, run.jobs.patience, 0);
  JobContext context;
  context.stop = run.jobs.stop;
  context.alive = [] {};
  const auto is_stopped = [&] { return run.jobs.stop != nullptr && *run.jobs.stop; };
  JobRunResult result;
  for (const Job& job : jobs) {
    if (!ledger.HasResult(job.name)) {
      JobResult one{job.name, nullptr, "", 0.0};
      try {
        one.output =
            RunStudyFit(place.recordings, options, job, context, folder / (job.name + ".search"));
      } catch (const std::exception& error) {
        one.problem = error.what();
      }
      if (is_stopped()) return result;
      ledger.Record(one);
    }
    result.results.push_back(*ledger.Read(job.name));
    if (run.jobs.progress)
      run.jobs.progress(static_cast<int>(result.results.size()), static_cast<int>(jobs.size()));
  }
  result.complete = true;
  return result;
}

JobRunResult Report(const Study& study, const StudyOptions& options, const StudyPlace& place,
                    const std::vector<Job>& jobs, const std::vector<JobResult>& results,
                    const StudyRunOptions& run) {
  std::vector<JobResult> good;
  for (const JobResult& result : results) {
    if (result.IsDone()) good.push_back(result);
  }
  JobRunOptions job_options = run.jobs;
  job_options.folder = place.folder / "jobs";
  const auto write = [=] {
    const std::string table = study.report(options, jobs, good, place);
    WriteWholeFile(place.folder / (study.name + ".md"), table);
    return table;
  };
  return RunReport(write, job_options);
}

}  // namespace

void StudyRun::Add(const JobRunResult& result) {
  complete = result.complete;
  num_problems += result.CountProblems();
  if (first_problem.empty()) first_problem = result.FirstProblem();
  num_hanging += result.num_hanging;
}

namespace {

// A folder of recordings is never replaced, and other studies may use it at the same time.
void PrepareRecordings(const StudyOptions& options, const StudyPlace& place) {
  std::vector<Job> jobs;
  std::vector<std::string> files;
  for (const std::string& experiment : options.experiments) {
    jobs.push_back(RecordingJob(options, experiment));
    for (const char* part : {"/pictures/", "/seen/"}) files.push_back(jobs.back().name + part);
  }
  OutputFolder folder(place.recordings, FolderKind::kStudyRecordings, "study", Existing::kJoin);
  const std::vector<std::string> of_jobs = LedgerFiles(jobs);
  files.insert(files.end(), of_jobs.begin(), of_jobs.end());
  folder.Begin(files);
}

FolderLock Prepare(const Study& study, const StudyOptions& options, const StudyPlace& place,
                   const StudyRunOptions& run) {
  JobFolderContents contents;
  contents.command = "study " + study.name;
  contents.file = "study.json";
  contents.description = Description(study, options);
  contents.jobs = study.jobs(options);
  contents.files = study.files;
  contents.files.emplace_back("report.html");
  for (const char* ending : {".md", ".csv", ".svg", ".png"})
    contents.files.push_back(study.name + ending);
  contents.shares_searches = options.share_search && !study.work;
  FolderLock lock = PrepareJobFolder(place.folder, contents, run.folder);
  if (study.uses_recordings && run.folder.ranks.rank == 0) PrepareRecordings(options, place);
  return lock;
}

}  // namespace

StudyRun RunStudy(const Study& study, const StudyOptions& options, const StudyPlace& place,
                  const StudyRunOptions& run) {
  options.Check();
  const FolderLock lock = Prepare(study, options, place, run);
  const auto tell = [&](const char* stage) {
    if (run.stage) run.stage(stage);
  };
  StudyRun result;
  if (study.uses_recordings) {
    tell("recordings");
    result.Add(MakeRecordings(options, place, run));
    if (!result.complete || result.num_problems > 0) return result;
  }
  tell("fits");
  const std::vector<Job> jobs = study.jobs(options);
  const JobRunResult done = options.share_search && !study.work
                                ? DoJobsTogether(options, place, jobs, run)
                                : DoJobs(study, options, place, jobs, run);
  result.Add(done);
  if (!done.complete || result.num_problems == static_cast<int>(jobs.size())) return result;
  tell("report");
  const JobRunResult report = Report(study, options, place, jobs, done.results, run);
  result.Add(report);
  if (report.complete && report.results[0].IsDone())
    result.table = report.results[0].output.get<std::string>();
  return result;
}

}  // namespace clothfit
