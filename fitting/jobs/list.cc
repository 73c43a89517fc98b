// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/list.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/files/version.h"
#include "tracking/text/json_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJobListFormat = "clothfit-jobs/1";

// Files and folders are named by it.
void CheckJobName(const std::string& name, const fs::path& file) {
  if (!name.empty() && name.front() != '.' && name.find('/') == std::string::npos &&
      Printable(name) == name)
    return;
  throw InputError(file.string(), "jobs: name " + Quoted(name) +
                                      ": expected one without slashes and control characters that "
                                      "does not start with a dot");
}

}  // namespace

std::string JobListAsText(const JobList& list) {
  nlohmann::json jobs = nlohmann::json::array();
  for (const Job& job : list.jobs)
    jobs.push_back({{"name", job.name}, {"stage", job.stage}, {"input", job.input}});
  const nlohmann::json json = {{"format", kJobListFormat},
                               {"clothfit", Version()},
                               {"command", list.command},
                               {"options", list.options},
                               {"jobs", std::move(jobs)}};
  return json.dump(1) + "\n";
}

JobList ReadJobList(const fs::path& folder) {
  const fs::path file = folder / kJobListFile;
  if (!fs::is_regular_file(file)) {
    throw InputError(folder.string(), std::string("has no ") + kJobListFile +
                                          "; expected the folder of a study, trials or a batch");
  }
  JobList list;
  ReadJson(file, "is no list of jobs", [&](const nlohmann::json& json) {
    if (json.at("format") != kJobListFormat)
      throw InputError(file.string(), std::string("format: expected ") + kJobListFormat);
    const auto version = json.at("clothfit").get<std::string>();
    if (version != Version()) {
      throw InputError(file.string(),
                       fmt::format("clothfit: '{}'; this is '{}', whose numbers may be others",
                                   version, Version()));
    }
    list.command = json.at("command").get<std::string>();
    list.options = json.at("options");
    for (const nlohmann::json& job : json.at("jobs")) {
      list.jobs.push_back({job.at("name"), job.at("input"), job.at("stage")});
      CheckJobName(list.jobs.back().name, file);
    }
  });
  return list;
}

JobRange ParseJobRange(const std::string& text, const JobList& list) {
  const std::size_t dash = text.find('-');
  const std::optional<int> first = ParseInteger(text.substr(0, dash)),
                           last = dash == std::string::npos ? first
                                                            : ParseInteger(text.substr(dash + 1));
  const int count = static_cast<int>(list.jobs.size());
  if (!first || !last || *first < 0 || *first >= count || *last < *first) {
    throw InputError("JOBS", fmt::format("'{}': expected a number from 0 to {}, or two as in 0-{}",
                                         text, count - 1, count - 1));
  }
  return {*first, std::min(*last, count - 1)};
}

}  // namespace clothfit
