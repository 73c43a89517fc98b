// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/apps/command.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

void RedirectTo(const fs::path& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  dup2(opened, descriptor);
  close(opened);
}

}  // namespace

RunningCommand::RunningCommand(const std::vector<std::string>& arguments, const fs::path& folder,
                               const std::function<void()>& before_start) {
  // Another program than the one of this build may be tried.
  const char* const other = std::getenv("CLOTHFIT_COMMAND");
  std::vector<std::string> words = {other != nullptr ? other : CLOTHFIT_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  // There from the beginning, however early the process is ended.
  for (const char* name : {"out", "err"}) std::ofstream(output_.path() / name).flush();
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no new process");
  if (process_ > 0) return;
  RedirectTo("/dev/null", STDIN_FILENO);
  RedirectTo(output_.path() / "out", STDOUT_FILENO);
  RedirectTo(output_.path() / "err", STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(127);
  if (before_start) before_start();
  execv(pointers[0], pointers.data());
  _exit(127);
}

void RunningCommand::Signal(int signal) const { kill(process_, signal); }

bool RunningCommand::Handles(int signal) const {
  std::ifstream status(fmt::format("/proc/{}/status", process_));
  for (std::string key, value; status >> key && std::getline(status, value);) {
    if (key == "SigCgt:") return (std::stoull(value, nullptr, 16) >> (signal - 1) & 1) != 0;
  }
  return false;
}

bool RunningCommand::HasEnded() {
  if (!has_ended_) has_ended_ = wait4(process_, &wait_status_, WNOHANG, &usage_) == process_;
  return has_ended_;
}

CommandResult RunningCommand::Wait() {
  if (!has_ended_) wait4(process_, &wait_status_, 0, &usage_);
  has_ended_ = true;
  const int status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -WTERMSIG(wait_status_);
  constexpr double kKilobyte = 1024.0;
  return {status, ReadTextFile(output_.path() / "out"), ReadTextFile(output_.path() / "err"),
          kKilobyte * static_cast<double>(usage_.ru_maxrss)};
}

CommandResult RunCommand(const std::vector<std::string>& arguments, const fs::path& folder,
                         const std::function<void()>& before_start) {
  return RunningCommand(arguments, folder, before_start).Wait();
}

std::string BadInputLine(const CommandResult& result) {
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("clothfit: error: ", 0), 0u) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  return result.err;
}

}  // namespace clothfit
