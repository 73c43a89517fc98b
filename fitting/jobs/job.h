// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One of many pieces of work, such as the fits of a study.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

namespace clothfit {

// What comes of a job depends on this alone, seeds included: never on a clock, on the number of
// workers, or on who does it. So it does not matter who does it again.
struct Job {
  std::string name;  // of its files: letters, digits, '-', '_' and '.'
  nlohmann::json input;
  int stage = 0;  // a job begins when all of earlier stages are done; they do not fall in a list
};

struct JobResult {
  std::string name;
  nlohmann::json output;
  std::string problem;   // what went wrong, in words; empty where it is done
  double seconds = 0.0;  // wall-clock: told, but no part of the outcome

  bool IsDone() const { return problem.empty(); }
};

struct JobContext {
  const std::atomic<bool>* stop = nullptr;  // set: what the job returns is not used
  int num_threads = 1;                      // that the job may use
};

// Does a job; exceptions are its problem. Called from several threads at once.
using JobWork = std::function<nlohmann::json(const Job& job, const JobContext& context)>;

}  // namespace clothfit
