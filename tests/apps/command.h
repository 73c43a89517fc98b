// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the clothfit command as a user does, in a folder of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>

#include "tests/support/test_folder.h"

namespace clothfit {

struct CommandResult {
  int status = -1;  // exit status; -signal where a signal ended it
  std::string out, err;
  double most_memory = 0.0;  // bytes at any moment
};

// A command under way. Its working folder is `folder`.
class RunningCommand {
 public:
  RunningCommand(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::function<void()>& before_start = {});
  void Signal(int signal) const;
  // Has it a handler of its own for this signal by now? False once it has ended.
  bool Handles(int signal) const;
  bool HasEnded();  // without waiting
  CommandResult Wait();

 private:
  TestFolder output_;
  pid_t process_ = -1;
  int wait_status_ = 0;
  rusage usage_ = {};
  bool has_ended_ = false;
};

// `before_start` runs in the new process.
CommandResult RunCommand(const std::vector<std::string>& arguments,
                         const std::filesystem::path& folder,
                         const std::function<void()>& before_start = {});

// Expects exit status 2, nothing but one line on the standard error, and returns that line.
std::string BadInputLine(const CommandResult& result);

}  // namespace clothfit
