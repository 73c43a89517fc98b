// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/run_study.h"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "autodiff_sim/error.h"
#include "fitting/jobs/job_ledger.h"
#include "fitting/studies/study_recording.h"
#include "fitting/version.h"
#include "fitting/whole_file.h"
#include "tracking/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestWait = 120.0;  // s, for the first of the processes

fs::path ReadyFile(const fs::path& folder, const Ranks& ranks) {
  return folder / "jobs" / ("ready-" + ranks.launch);
}

void WaitForFirst(const fs::path& folder, const Ranks& ranks) {
  for (double waited = 0.0; waited < kLongestWait; waited += 0.02) {
    if (fs::exists(ReadyFile(folder, ranks))) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  throw InputError(folder.string(),
                   "the first of the processes has not prepared it; do all of "
                   "them see the same folder?");
}

void RequireSame(const fs::path& file, const std::string& description) {
  if (fs::exists(file) && ReadTextFile(file) == description) return;
  throw InputError("--resume", "the options differ from those in " + file.string());
}

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

// By one of the processes, whichever: it is a job like the others.
JobRunResult Report(const Study& study, const StudyOptions& options, const StudyPlace& place,
                    const std::vector<Job>& jobs, const std::vector<JobResult>& results,
                    const StudyRunOptions& run) {
  std::vector<JobResult> good;
  for (const JobResult& result : results) {
    if (result.IsDone()) good.push_back(result);
  }
  JobRunOptions job_options = run.jobs;
  job_options.folder = place.folder / "jobs";
  job_options.num_threads = 1;
  job_options.progress = nullptr;
  const JobWork work = [=](const Job&, const JobContext&) -> nlohmann::json {
    const std::string table = study.report(options, jobs, good, place);
    WriteWholeFile(place.folder / (study.name + ".md"), table);
    return table;
  };
  return RunJobs({{"report", nullptr}}, work, job_options);
}

void Take(const JobRunResult& result, StudyRun* run) {
  run->complete = result.complete;
  run->num_problems += result.CountProblems();
  if (run->first_problem.empty()) run->first_problem = result.FirstProblem();
  run->num_hanging += result.num_hanging;
}

}  // namespace

void PrepareJobFolder(const fs::path& folder, const std::string& file,
                      const std::string& description, const StudyRunOptions& run) {
  if (run.ranks.rank > 0) {
    WaitForFirst(folder, run.ranks);
    RequireSame(folder / file, description);
    return;
  }
  const bool exists = fs::exists(folder / file) || fs::exists(folder / "jobs");
  if (exists && !run.force && !run.resume) {
    throw InputError(folder.string(),
                     "already holds results; --force replaces them, --resume goes on with them");
  }
  if (run.resume) RequireSame(folder / file, description);
  if (run.force) fs::remove_all(folder / "jobs");
  fs::create_directories(folder / "jobs");
  JobLedger::Clear(folder / "jobs");
  fs::remove(folder / "jobs" / "report.json");
  WriteWholeFile(folder / file, description);
  if (run.ranks.size > 1) WriteWholeFile(ReadyFile(folder, run.ranks), "");
}

StudyRun RunStudy(const Study& study, const StudyOptions& options, const StudyPlace& place,
                  const StudyRunOptions& run) {
  options.Check();
  PrepareJobFolder(place.folder, "study.json", Description(study, options), run);
  const auto tell = [&](const char* stage) {
    if (run.stage) run.stage(stage);
  };
  StudyRun result;
  if (study.uses_recordings) {
    tell("recordings");
    Take(MakeRecordings(options, place, run), &result);
    if (!result.complete || result.num_problems > 0) return result;
  }
  tell("fits");
  const std::vector<Job> jobs = study.jobs(options);
  const JobRunResult done = DoJobs(study, options, place, jobs, run);
  Take(done, &result);
  if (!done.complete || result.num_problems == static_cast<int>(jobs.size())) return result;
  tell("report");
  const JobRunResult report = Report(study, options, place, jobs, done.results, run);
  Take(report, &result);
  if (report.complete && report.results[0].IsDone())
    result.table = report.results[0].output.get<std::string>();
  return result;
}

}  // namespace clothfit
