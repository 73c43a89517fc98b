// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What lists of jobs cost beside the jobs: a result, and a folder of ten thousand.
#include <chrono>
#include <filesystem>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include "fitting/jobs/folder.h"
#include "fitting/jobs/results.h"
#include "fitting/jobs/run_jobs.h"
#include "fitting/jobs/status.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::vector<Job> Jobs(int count) {
  std::vector<Job> jobs;
  for (int i = 0; i < count; ++i) jobs.push_back({fmt::format("job-{:05}", i), {{"number", i}}});
  return jobs;
}

fs::path NewFolder() {
  fs::path folder = fs::temp_directory_path() / fmt::format("clothfit-jobs-{}", getpid());
  fs::remove_all(folder);
  return folder;
}

void EmptyJobs(benchmark::State& state) {
  constexpr int kCount = 200;
  JobRunOptions options;
  options.folder = NewFolder();
  for (auto _ : state) {
    fs::remove_all(options.folder);
    RunJobs(
        Jobs(kCount), [](const Job& job, const JobContext&) { return job.input; }, options);
  }
  state.counters["jobs_per_s"] =
      benchmark::Counter(kCount, benchmark::Counter::kIsIterationInvariantRate);
  fs::remove_all(options.folder);
}
BENCHMARK(EmptyJobs)->Unit(benchmark::kMillisecond)->UseRealTime();

// A folder in which all jobs are done, with results as long as those of a fit.
class DoneJobs {
 public:
  explicit DoneJobs(int count) : folder_(NewFolder()) {
    JobFolderContents contents;
    contents.list = {"study squares", nullptr, Jobs(count)};
    contents.file = "study.json";
    PrepareJobFolder(folder_, contents, Existing::kRefuse);
    const std::vector<double> history(250, 0.123456789);
    for (const Job& job : contents.list.jobs) {
      const nlohmann::json result = {
          {"output", {{"history", history}}}, {"problem", ""}, {"seconds", 1.0}};
      PartFile part(folder_ / kResultFolder / (job.name + ".json"));
      std::FILE* const file = std::fopen(part.path().c_str(), "w");
      std::fputs(result.dump(1).c_str(), file);
      std::fclose(file);
      part.MoveToPlace();
    }
  }
  ~DoneJobs() { fs::remove_all(folder_); }
  DoneJobs(const DoneJobs&) = delete;
  DoneJobs& operator=(const DoneJobs&) = delete;

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

// What each task does before its work.
void ReadTheList(benchmark::State& state) {
  const DoneJobs done(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ReadJobList(done.folder()));
}
BENCHMARK(ReadTheList)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

void ListWhatIsDone(benchmark::State& state) {
  const DoneJobs done(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(NamesOfResults(done.folder() / kResultFolder));
}
BENCHMARK(ListWhatIsDone)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

void GatherWhatIsDone(benchmark::State& state) {
  const DoneJobs done(static_cast<int>(state.range(0)));
  const JobList list = ReadJobList(done.folder());
  for (auto _ : state)
    benchmark::DoNotOptimize(ReadJobResults(done.folder() / kResultFolder, list.jobs));
}
BENCHMARK(GatherWhatIsDone)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace clothfit
