// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/status.h"

#include <deque>
#include <sstream>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/jobs/results.h"
#include "fitting/jobs/slurm.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLastLines = 3;  // of a log

std::string EndOfLog(const fs::path& log) {
  std::istringstream stream;
  try {
    if (IsThere(log)) stream.str(ReadInputFile(log));
  } catch (const InputError& error) {
    return std::string(error.what()) + "\n";
  }
  std::deque<std::string> last;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty()) continue;
    last.push_back(line);
    if (last.size() > kLastLines) last.pop_front();
  }
  std::string text = log.string() + (last.empty() ? " says nothing\n" : " ends\n");
  for (const std::string& line : last) text += "      " + Printable(line) + "\n";
  return text;
}

struct JobCounts {
  int done = 0, running = 0, waiting = 0, open = 0, failed = 0;
  std::string failures;
};

void CountWithoutResult(const SlurmTask& task, JobCounts* counts, const std::string& name) {
  if (task.log.empty()) {
    ++counts->open;
  } else if (task.state.empty()) {
    ++counts->failed;
    counts->failures += "  " + name + " was lost: " + EndOfLog(task.log);
  } else {
    const bool waits = task.state == "PENDING" || task.state == "REQUEUED";
    ++(waits ? counts->waiting : counts->running);
  }
}

}  // namespace

JobStatus StatusOfJobs(const fs::path& folder, const JobList& list) {
  std::string problem;
  std::map<int, SlurmTask> tasks = FindSlurmTasks(folder, list, &problem);
  // Looked at afterwards, so that who has just ended has a result.
  const fs::path results = folder / kResultFolder;
  const std::set<std::string> ended = NamesOfResults(results);
  JobCounts counts;
  int without_result = 0;
  for (int i = 0; i < static_cast<int>(list.jobs.size()); ++i) {
    const Job& job = list.jobs[static_cast<std::size_t>(i)];
    const std::string name = fmt::format("{} (job {})", job.name, i);
    if (ended.count(job.name) == 0) {
      ++without_result;
      CountWithoutResult(problem.empty() ? tasks[i] : SlurmTask(), &counts, name);
      continue;
    }
    const JobResult result = ReadJobResult(results, job.name).value();
    ++(result.IsDone() ? counts.done : counts.failed);
    if (!result.IsDone()) counts.failures += "  " + name + ": " + result.problem + "\n";
  }
  std::string text = fmt::format(
      "{} jobs: {} done, {} running, {} in the queue, {} not begun, {} failed\n", list.jobs.size(),
      counts.done, counts.running, counts.waiting, counts.open, counts.failed);
  if (!problem.empty()) text += "not known what runs: " + problem + "\n";
  return {text + counts.failures, counts.running + counts.waiting > 0 || !problem.empty(),
          without_result == 0};
}

}  // namespace clothfit
