// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/study_plan.h"

#include <algorithm>
#include <utility>

#include "fitting/files/version.h"
#include "fitting/studies/study_recording.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr int kRecordingStage = 0, kStudyStage = 1;

std::string Description(const Study& study, const StudyOptions& options) {
  const nlohmann::json json = {
      {"study", study.name}, {"clothfit", Version()}, {"options", options}};
  return json.dump(1) + "\n";
}

std::vector<Job> RecordingJobs(const Study& study, const StudyOptions& options) {
  std::vector<Job> jobs;
  if (!study.uses_recordings) return jobs;
  for (const std::string& experiment : options.experiments)
    jobs.push_back(RecordingJob(options, experiment));
  return jobs;
}

// A folder of recordings is never replaced, and other studies may use it at the same time.
void PrepareRecordings(const std::vector<Job>& recordings, const fs::path& folder) {
  if (recordings.empty()) return;
  std::vector<std::string> files;
  for (const Job& job : recordings)
    for (const char* part : {"/pictures/", "/seen/"}) files.push_back(job.name + part);
  OutputFolder(folder, FolderKind::kStudyRecordings, "study", Existing::kJoin).Begin(files);
}

StudyPlace PlaceOf(const JobList& list, const fs::path& folder) {
  const auto recordings = list.options.at("recordings").get<std::string>();
  return {folder, recordings.empty() ? folder / "recordings" : fs::path(recordings)};
}

std::string Report(const Study& study, const StudyOptions& options, const StudyPlace& place,
                   const std::vector<Job>& jobs, const std::vector<JobResult>& results) {
  std::vector<JobResult> good;
  for (const JobResult& result : results) {
    const bool is_own = std::any_of(jobs.begin(), jobs.end(),
                                    [&](const Job& job) { return job.name == result.name; });
    if (is_own && result.IsDone()) good.push_back(result);
  }
  if (good.empty()) return "";
  const std::string table = study.report(options, jobs, good, place);
  WriteWholeFile(place.folder / (study.name + ".md"), table);
  return table;
}

}  // namespace

FolderLock PrepareStudy(const Study& study, const StudyOptions& options, const fs::path& folder,
                        const fs::path& recordings, Existing existing) {
  options.Check();
  JobFolderContents contents;
  contents.list.command = "study " + study.name;
  const std::string shared =
      recordings.empty() ? "" : fs::absolute(recordings).lexically_normal().string();
  contents.list.options = {{"options", options}, {"recordings", shared}};
  contents.list.jobs = RecordingJobs(study, options);
  const std::vector<Job> recording_jobs = contents.list.jobs;
  for (Job& job : study.jobs(options)) {
    job.stage = kStudyStage;
    contents.list.jobs.push_back(std::move(job));
  }
  contents.file = "study.json";
  contents.description = Description(study, options);
  contents.files = study.files;
  for (const char* ending : {".md", ".csv", ".svg", ".png"})
    contents.files.push_back(study.name + ending);
  FolderLock lock = PrepareJobFolder(folder, contents, existing);
  PrepareRecordings(recording_jobs, PlaceOf(contents.list, folder).recordings);
  return lock;
}

JobPlan StudyPlan(const Study& study, JobList list, const fs::path& folder) {
  const StudyPlace place = PlaceOf(list, folder);
  const auto options = list.options.at("options").get<StudyOptions>();
  std::vector<Job> own;
  for (const Job& job : list.jobs)
    if (job.stage == kStudyStage) own.push_back(job);
  JobPlan plan;
  plan.threads_a_job = options.under_way;
  plan.list = std::move(list);
  plan.work = [study, options, place](const Job& job, const JobContext& context) {
    if (job.stage == kRecordingStage) return MakeStudyRecording(place.recordings, job, context);
    if (study.work) return study.work(options, job, context);
    return RunStudyFit(place.recordings, options, job, context);
  };
  plan.report = [study, options, place, own](const std::vector<JobResult>& results) {
    return Report(study, options, place, own, results);
  };
  return plan;
}

std::optional<Study> StudyOf(const JobList& list) {
  for (Study& study : Studies())
    if (list.command == "study " + study.name) return std::move(study);
  return std::nullopt;
}

}  // namespace clothfit
