// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/results.h"

#include "autodiff_sim/base/error.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResultEnding = ".json";

fs::path ResultFile(const fs::path& folder, const std::string& name) {
  return folder / (name + kResultEnding);
}

}  // namespace

std::set<std::string> NamesOfResults(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path file = entry->path().filename();
    if (file.extension() == kResultEnding) names.insert(file.stem().string());
  }
  if (error && error != std::errc::no_such_file_or_directory)
    throw InputError(folder.string(), "cannot be read: " + error.message());
  return names;
}

std::optional<JobResult> ReadJobResult(const fs::path& folder, const std::string& name) {
  const fs::path file = ResultFile(folder, name);
  if (!fs::exists(file)) return std::nullopt;
  return ReadJson(file, "no result of a job", [&](const nlohmann::json& json) {
    return JobResult{name, json.at("output"), json.at("problem").get<std::string>(),
                     json.at("seconds").get<double>()};
  });
}

std::vector<JobResult> ReadJobResults(const fs::path& folder, const std::vector<Job>& jobs) {
  const std::set<std::string> names = NamesOfResults(folder);
  std::vector<JobResult> results;
  for (const Job& job : jobs)
    if (names.count(job.name) > 0) results.push_back(ReadJobResult(folder, job.name).value());
  return results;
}

std::string WhatStageWaitsFor(const fs::path& folder, const std::vector<Job>& jobs, int stage) {
  for (const Job& job : jobs) {
    if (job.stage >= stage) break;
    const std::optional<JobResult> result = ReadJobResult(folder, job.name);
    if (!result) return job.name + " has no result yet";
    if (!result->IsDone()) return job.name + " failed: " + result->problem;
  }
  return "";
}

void WriteJobResult(const fs::path& folder, const JobResult& result) {
  const nlohmann::json json = {
      {"output", result.output}, {"problem", result.problem}, {"seconds", result.seconds}};
  WriteNewFile(ResultFile(folder, result.name), json.dump(1) + "\n");
}

}  // namespace clothfit
