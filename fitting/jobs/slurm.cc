// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/slurm.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/jobs/results.h"
#include "fitting/jobs/shell.h"
#include "tracking/files/output_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/json_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// An array of tasks; task t does the jobs from first + t * jobs_a_task on.
struct SlurmArray {
  std::string id;  // Slurm's
  int first = 0, last = 0, jobs_a_task = 1;
  std::vector<int> tasks;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SlurmArray, id, first, last, jobs_a_task, tasks)

fs::path SubmittedFile(const fs::path& folder) { return folder / kSlurmFolder / "submitted.json"; }

// Whether it is of jobs of the list, each in one task; its id becomes the name of logs.
bool IsPossible(const SlurmArray& array, const JobList& list) {
  const int jobs = static_cast<int>(list.jobs.size());
  const std::vector<int>& tasks = array.tasks;
  return ParseInteger(array.id) && array.first >= 0 && array.first <= array.last &&
         array.last < jobs && array.jobs_a_task >= 1 && array.jobs_a_task <= jobs &&
         std::adjacent_find(tasks.begin(), tasks.end(), std::greater_equal<>()) == tasks.end() &&
         (tasks.empty() ||
          (tasks.front() >= 0 && tasks.back() <= (array.last - array.first) / array.jobs_a_task));
}

std::vector<SlurmArray> ReadSubmitted(const fs::path& folder, const JobList& list) {
  const fs::path file = SubmittedFile(folder);
  if (!fs::exists(file)) return {};
  return ReadJson(file, "does not say what was submitted", [&](const nlohmann::json& json) {
    auto arrays = json.get<std::vector<SlurmArray>>();
    for (const SlurmArray& array : arrays) {
      if (IsPossible(array, list)) continue;
      throw InputError(file.string(), "array " + Quoted(array.id) +
                                          ": expected a number, and tasks of jobs in " +
                                          kJobListFile);
    }
    return arrays;
  });
}

std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

// Tasks in the queue, as "array_task", with their states.
std::map<std::string, std::string> ReadQueue(const std::vector<SlurmArray>& arrays,
                                             std::string* problem) {
  std::map<std::string, std::string> states;
  if (arrays.empty()) return states;
  std::string ids;
  for (const SlurmArray& array : arrays) ids += (ids.empty() ? "" : ",") + array.id;
  const ShellResult queue =
      RunProgram({"squeue", "--noheader", "--array", "--format=%F_%K %T", "--jobs=" + ids});
  // Slurm forgets jobs that have ended, minutes later.
  if (queue.output.find("Invalid job id") != std::string::npos) return states;
  if (queue.status != 0) {
    *problem = "squeue: " + OneLine(queue.output);
    return states;
  }
  std::istringstream lines(queue.output);
  for (std::string task, state; lines >> task >> state;) states[task] = state;
  return states;
}

SlurmArray OpenTasks(const fs::path& folder, const JobList& list, int first, int array_size) {
  const std::set<std::string> done = NamesOfResults(folder / kResultFolder);
  SlurmArray array;
  array.first = array.last = first;
  const int stage = list.jobs[static_cast<std::size_t>(first)].stage;
  for (int i = first; i < static_cast<int>(list.jobs.size()); ++i)
    if (list.jobs[static_cast<std::size_t>(i)].stage == stage) array.last = i;
  array.jobs_a_task = (array.last - first + array_size) / array_size;
  for (int i = first; i <= array.last; ++i) {
    const int task = (i - first) / array.jobs_a_task;
    if (done.count(list.jobs[static_cast<std::size_t>(i)].name) > 0) continue;
    if (array.tasks.empty() || array.tasks.back() != task) array.tasks.push_back(task);
  }
  return array;
}

// As sbatch takes them: "0-3,7".
std::string AsRanges(const std::vector<int>& tasks) {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t end = i;
    while (end + 1 < tasks.size() && tasks[end + 1] == tasks[end] + 1) ++end;
    text += (text.empty() ? "" : ",") + std::to_string(tasks[i]);
    if (end > i) text += "-" + std::to_string(tasks[end]);
    i = end + 1;
  }
  return text;
}

class Submission {
 public:
  Submission(const fs::path& folder, const JobList& list, const SlurmOptions& options)
      : folder_(fs::canonical(folder)), options_(options), submitted_(ReadSubmitted(folder, list)) {
    name_ = "clothfit-" + list.command;
    std::replace(name_.begin(), name_.end(), ' ', '-');
  }

  // After what was submitted last, where that was done well.
  void SubmitArray(SlurmArray array, int stage) {
    const std::string jobs = fmt::format(
        "first=$(({} + SLURM_ARRAY_TASK_ID * {}))\n"
        "last=$((first + {}))\n"
        "{} job {} \"$first-$((last < {} ? last : {}))\" --threads "
        "\"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
        array.first, array.jobs_a_task, array.jobs_a_task - 1, ShellWord(options_.program),
        ShellWord(folder_.string()), array.last, array.last);
    array.id = Submit(fmt::format("stage-{}.sh", stage), jobs, "%A_%a.log",
                      "afterok:", {"--array=" + AsRanges(array.tasks)});
    submitted_.push_back(array);
    WriteWholeFile(SubmittedFile(folder_), nlohmann::json(submitted_).dump() + "\n");
    told_ += fmt::format("array {}: {} {}, {} {} each\n", array.id, array.tasks.size(),
                         array.tasks.size() == 1 ? "task" : "tasks", array.jobs_a_task,
                         array.jobs_a_task == 1 ? "job" : "jobs");
  }
  // However the arrays end.
  void SubmitGathering() {
    const std::string gather = fmt::format("{} jobs {} --gather\n", ShellWord(options_.program),
                                           ShellWord(folder_.string()));
    told_ += "tables: job " + Submit("gather.sh", gather, "%j.log", "afterany:", {}) + "\n";
  }
  const std::string& told() const { return told_; }

 private:
  std::string Submit(const std::string& script, const std::string& work, const char* log,
                     const std::string& after, std::vector<std::string> more) {
    const fs::path own = folder_ / kSlurmFolder;
    WriteWholeFile(own / script, "#!/bin/bash\n#SBATCH " + options_.sbatch + "\n" + work);
    std::vector<std::string> words = {"sbatch", "--parsable", "--open-mode=append",
                                      "--job-name=" + name_, "--chdir=" + folder_.string()};
    std::string escaped = own.string();  // % begins a field
    for (std::size_t i = 0; (i = escaped.find('%', i)) != std::string::npos; i += 2)
      escaped.insert(i, 1, '%');
    words.push_back("--output=" + escaped + "/" + log);
    if (!last_.empty()) {
      words.push_back("--dependency=" + after + last_);
      words.emplace_back("--kill-on-invalid-dep=yes");
    }
    words.insert(words.end(), more.begin(), more.end());
    words.push_back((own / script).string());
    last_ = IdOf(RunProgram(words));
    ids_.push_back(last_);
    return last_;
  }

  // "12" or "12;cluster" stands on a line of its own, warnings perhaps beside it.
  std::string IdOf(const ShellResult& submitted) {
    std::istringstream lines(submitted.output);
    for (std::string line; submitted.status == 0 && std::getline(lines, line);) {
      const std::string id = line.substr(0, line.find(';'));
      if (ParseInteger(id)) return id;
    }
    for (const std::string& id : ids_) RunProgram({"scancel", id});
    throw InputError("--slurm", "sbatch refuses: " + OneLine(submitted.output));
  }

  fs::path folder_;
  const SlurmOptions& options_;
  std::vector<SlurmArray> submitted_;
  std::string name_, last_, told_;
  std::vector<std::string> ids_;
};

void RefuseWhereJobsAreQueued(const fs::path& folder, const JobList& list) {
  std::string problem;
  const std::map<std::string, std::string> queue = ReadQueue(ReadSubmitted(folder, list), &problem);
  if (!problem.empty()) throw InputError("--slurm", problem);
  if (queue.empty()) return;
  const std::string task = queue.begin()->first;
  throw InputError("--slurm", fmt::format("{} jobs of the folder are still in the queue; wait for "
                                          "them, or scancel {}",
                                          queue.size(), task.substr(0, task.find('_'))));
}

}  // namespace

std::string SubmitToSlurm(const fs::path& folder, const JobList& list,
                          const SlurmOptions& options) {
  // Locked until all is submitted. That of the jobs is not, since they may begin before.
  OutputFolder own(folder / kSlurmFolder, FolderKind::kSlurm, list.command, Existing::kResume);
  own.Begin({});
  RefuseWhereJobsAreQueued(folder, list);
  Submission submission(folder, list, options);
  for (int first = 0; first < static_cast<int>(list.jobs.size());) {
    const SlurmArray array = OpenTasks(folder, list, first, options.array_size);
    if (!array.tasks.empty())
      submission.SubmitArray(array, list.jobs[static_cast<std::size_t>(first)].stage);
    first = array.last + 1;
  }
  submission.SubmitGathering();
  return submission.told();
}

std::map<int, SlurmTask> FindSlurmTasks(const fs::path& folder, const JobList& list,
                                        std::string* problem) {
  const std::vector<SlurmArray> arrays = ReadSubmitted(folder, list);
  const std::map<std::string, std::string> queue = ReadQueue(arrays, problem);
  std::map<int, SlurmTask> tasks;
  for (const SlurmArray& array : arrays) {
    for (const int task : array.tasks) {
      const std::string id = array.id + "_" + std::to_string(task);
      const auto state = queue.find(id);
      const int first = array.first + task * array.jobs_a_task;
      for (int i = first; i < first + array.jobs_a_task && i <= array.last; ++i)
        tasks[i] = {folder / kSlurmFolder / (id + ".log"),
                    state == queue.end() ? "" : state->second};
    }
  }
  return tasks;
}

}  // namespace clothfit
