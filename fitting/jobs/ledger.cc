// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/ledger.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::string HostName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

std::string ReadAll(const fs::path& file) {
  try {
    return ReadInputFile(file);
  } catch (const InputError&) {  // somebody else has removed it, say
    return "";
  }
}

// s since some moment, of the file system's clock, which may be another machine's.
std::optional<double> ModifiedAt(const fs::path& file) {
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0) return std::nullopt;
  return static_cast<double>(status.st_mtim.tv_sec) +
         1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

double Seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int CountLines(const fs::path& file) {
  const std::string text = ReadAll(file);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

JobLedger::JobLedger(fs::path folder, double patience, int worker)
    : folder_(std::move(folder)),
      patience_(patience),
      token_(fmt::format("{} {} {}", HostName(), getpid(), worker)) {
  MakeFolder(folder_);
}

fs::path JobLedger::File(const std::string& name, const char* ending) const {
  return folder_ / (name + ending);
}

std::vector<std::string> JobLedger::FilesOf(const std::string& name) {
  return {name + ".json", name + ".lease", name + ".lost"};
}

bool JobLedger::HasResult(const std::string& name) const { return fs::exists(File(name, ".json")); }

std::optional<JobResult> JobLedger::Read(const std::string& name) const {
  const fs::path file = File(name, ".json");
  if (!fs::exists(file)) return std::nullopt;
  try {
    const nlohmann::json json = nlohmann::json::parse(ReadAll(file));
    return JobResult{name, json.at("output"), json.at("problem").get<std::string>(),
                     json.at("seconds").get<double>()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string(), std::string("no result of a job: ") + error.what());
  }
}

// A holder on this machine is asked for directly; others show that they live.
bool JobLedger::IsVoid(const fs::path& lease) const {
  const std::optional<double> sign = ModifiedAt(lease);
  if (!sign) return false;  // released meanwhile
  std::istringstream holder(ReadAll(lease));
  std::string host;
  pid_t process = 0;
  if (holder >> host >> process && host == HostName() && kill(process, 0) != 0 && errno == ESRCH)
    return true;
  const PartFile clock(lease);
  const std::optional<double> now = ModifiedAt(clock.path());
  return now && *now - *sign > patience_;
}

// Of many that break the same lease one does. Should another lease be in its place by then, that
// job is done twice, with the same outcome.
void JobLedger::Break(const std::string& name) {
  const fs::path lease = File(name, ".lease");
  const PartFile broken(lease);
  const std::string holder = ReadAll(lease);
  std::error_code error;
  fs::rename(lease, broken.path(), error);
  if (error) return;
  AppendLine(File(name, ".lost"), holder);
}

bool JobLedger::Take(const std::string& name) {
  const fs::path lease = File(name, ".lease");
  if (fs::exists(lease)) {
    if (!IsVoid(lease)) return false;
    Break(name);
  }
  if (HasResult(name)) return false;
  if (const int lost = CountLines(File(name, ".lost")); lost >= kMostLosses) {
    Record({name, nullptr, fmt::format("given up: {} workers died or hung in it", lost), 0.0});
    return false;
  }
  if (!WriteNewFile(lease, token_)) return false;
  if (!HasResult(name)) return true;  // or it came while we were looking
  Release(name);
  return false;
}

bool JobLedger::IsOurs(const std::string& name) const {
  return ReadAll(File(name, ".lease")) == token_;
}

void JobLedger::Alive(const std::string& name) {
  const double now = Seconds();
  if (now - last_sign_ < 1.0 || !IsOurs(name)) return;
  last_sign_ = now;
  utimensat(AT_FDCWD, File(name, ".lease").c_str(), nullptr, 0);
}

void JobLedger::Release(const std::string& name) {
  std::error_code ignored;
  if (IsOurs(name)) fs::remove(File(name, ".lease"), ignored);
}

void JobLedger::Record(const JobResult& result) {
  if (HasResult(result.name)) return;
  const nlohmann::json json = {
      {"output", result.output}, {"problem", result.problem}, {"seconds", result.seconds}};
  WriteWholeFile(File(result.name, ".json"), json.dump(1) + "\n");
}

}  // namespace clothfit
