// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/run_jobs.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "autodiff_sim/base/parallel.h"
#include "fitting/jobs/ledger.h"

namespace clothfit {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kShortestPause(5),
    kLongestPause(500);  // between looks at the folder

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// What threads share, those that hang included: nothing here lives on anybody's stack.
struct Shared {
  std::vector<Job> jobs;
  JobWork work;
  JobRunOptions options;
  std::vector<std::atomic<bool>> done;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::exception_ptr failure;  // of the ledger, not of a job

  Shared(const std::vector<Job>& all, JobWork do_one, JobRunOptions run_options)
      : jobs(all), work(std::move(do_one)), options(std::move(run_options)), done(all.size()) {}
  bool IsStopped() const { return failed || (options.stop != nullptr && *options.stop); }
  int CountDone() const {
    int count = 0;
    for (const std::atomic<bool>& one : done) count += one ? 1 : 0;
    return count;
  }
};

// One thread's.
struct Worker {
  std::atomic<double> last_sign = 0.0;  // s since `begin`; of the job in hand
  std::atomic<bool> is_busy = false, has_ended = false;
  Clock::time_point begin = Clock::now();
  std::thread thread;
};

JobResult DoJob(const Shared& shared, const Job& job, const JobContext& context) {
  const Clock::time_point start = Clock::now();
  JobResult result;
  result.name = job.name;
  try {
    result.output = shared.work(job, context);
  } catch (const std::exception& error) {
    result.problem = error.what();
    if (result.problem.empty()) result.problem = "failed";
  }
  result.seconds = SecondsSince(start);
  return result;
}

void TakeAndDo(const Shared& shared, const Job& job, JobLedger* ledger, Worker* worker) {
  JobContext context;
  context.stop = shared.options.stop;
  context.alive = [ledger, worker, &job] {
    worker->last_sign = SecondsSince(worker->begin);
    ledger->Alive(job.name);
  };
  worker->last_sign = SecondsSince(worker->begin);
  worker->is_busy = true;
  const JobResult result = DoJob(shared, job, context);
  worker->is_busy = false;
  if (!shared.IsStopped()) ledger->Record(result);
  ledger->Release(job.name);
}

void WorkThroughList(Shared* shared, Worker* worker, int number) {
  JobLedger ledger(shared->options.folder, shared->options.patience, number);
  auto pause = kShortestPause;
  while (!shared->IsStopped()) {
    bool is_open = false, has_worked = false;
    for (std::size_t i = 0; i < shared->jobs.size() && !shared->IsStopped(); ++i) {
      if (shared->done[i]) continue;
      const Job& job = shared->jobs[i];
      if (!ledger.HasResult(job.name) && ledger.Take(job.name)) {
        TakeAndDo(*shared, job, &ledger, worker);
        has_worked = true;
      }
      if (ledger.HasResult(job.name)) shared->done[i] = true;
      is_open = is_open || !shared->done[i];
    }
    if (!is_open) return;
    pause = has_worked ? kShortestPause : std::min(kLongestPause, 2 * pause);
    if (!has_worked) std::this_thread::sleep_for(pause);
  }
}

void RunWorker(Shared* shared, Worker* worker, int number) {
  const InsideParallelWork inside;  // a job has one core
  try {
    WorkThroughList(shared, worker, number);
  } catch (...) {
    const std::lock_guard<std::mutex> lock(shared->mutex);
    if (shared->failure == nullptr) shared->failure = std::current_exception();
    shared->failed = true;
  }
  worker->has_ended = true;
}

// The threads of this process, those that were given up included.
class Crew {
 public:
  explicit Crew(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {}

  void Hire() {
    auto worker = std::make_shared<Worker>();
    const int number = static_cast<int>(workers_.size());
    worker->thread = std::thread(
        [shared = shared_, worker, number] { RunWorker(shared.get(), worker.get(), number); });
    workers_.push_back(worker);
    replaced_.push_back(false);
  }
  // Another thread for each that has been silent for too long.
  void ReplaceSilent() {
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      if (replaced_[i] || !IsSilent(*workers_[i])) continue;
      replaced_[i] = true;
      Hire();
      return;
    }
  }
  bool HaveEnded() const {
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      if (!replaced_[i] && !workers_[i]->has_ended) return false;
    }
    return true;
  }
  // Returns how many cannot be waited for.
  int Dismiss() {
    int hanging = 0;
    for (const std::shared_ptr<Worker>& worker : workers_) {
      if (worker->has_ended) {
        worker->thread.join();
      } else {
        worker->thread.detach();
        ++hanging;
      }
    }
    return hanging;
  }

 private:
  bool IsSilent(const Worker& worker) const {
    return worker.is_busy &&
           SecondsSince(worker.begin) - worker.last_sign > shared_->options.patience;
  }

  std::shared_ptr<Shared> shared_;
  std::vector<std::shared_ptr<Worker>> workers_;
  std::vector<bool> replaced_;
};

}  // namespace

std::string JobRunResult::FirstProblem() const {
  for (const JobResult& result : results) {
    if (!result.IsDone()) return result.name + ": " + result.problem;
  }
  return "";
}

int JobRunResult::CountProblems() const {
  int count = 0;
  for (const JobResult& result : results) count += result.IsDone() ? 0 : 1;
  return count;
}

JobRunResult RunJobs(const std::vector<Job>& jobs, const JobWork& work,
                     const JobRunOptions& options) {
  const auto shared = std::make_shared<Shared>(jobs, work, options);
  Crew crew(shared);
  const int num_threads =
      std::min(NumThreads(options.num_threads), std::max(1, static_cast<int>(jobs.size())));
  for (int i = 0; i < num_threads; ++i) crew.Hire();
  auto pause = kShortestPause;
  int shown = -1;
  while (!crew.HaveEnded()) {
    std::this_thread::sleep_for(pause);
    pause = std::min(kLongestPause / 5, 2 * pause);
    crew.ReplaceSilent();
    const int done = shared->CountDone();
    if (options.progress && done != shown) options.progress(done, static_cast<int>(jobs.size()));
    shown = done;
  }
  JobRunResult result;
  result.num_hanging = crew.Dismiss();
  if (shared->failure != nullptr) std::rethrow_exception(shared->failure);
  const JobLedger ledger(options.folder, options.patience, -1);
  for (const Job& job : jobs) {
    if (const std::optional<JobResult> one = ledger.Read(job.name)) result.results.push_back(*one);
  }
  result.complete = result.results.size() == jobs.size();
  return result;
}

JobRunResult RunReport(const std::function<std::string()>& write, const JobRunOptions& options) {
  JobRunOptions alone = options;
  alone.num_threads = 1;
  alone.progress = nullptr;
  return RunJobs(
      {{"report", nullptr}},
      [write](const Job&, const JobContext&) -> nlohmann::json { return write(); }, alone);
}

}  // namespace clothfit
