// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/shell.h"

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

namespace clothfit {

namespace fs = std::filesystem;

std::string ShellWord(const std::string& word) {
  bool is_plain = !word.empty();
  for (const char one : word) {
    const auto byte = static_cast<unsigned char>(one);
    is_plain = is_plain && (std::isalnum(byte) != 0 || byte >= 0x80 ||
                            std::strchr("_-./:=,@%+", one) != nullptr);
  }
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char one : word) quoted += one == '\'' ? "'\\''" : std::string(1, one);
  return quoted + "'";
}

ShellResult RunProgram(const std::vector<std::string>& words) {
  // The limit to this machine's free memory is of this program alone; sbatch would pass it on.
  std::string line = "ulimit -S -d \"$(ulimit -H -d)\"; ";
  for (const std::string& word : words) line += ShellWord(word) + " ";
  ShellResult result;
  std::FILE* const pipe = popen((line + "2>&1").c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe))
    result.output.append(part.data(), size);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

std::string OwnProgram() {
  const std::string name = program_invocation_name;
  if (name.find('/') != std::string::npos) return fs::absolute(name).lexically_normal().string();
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::absolute(fs::path(folder) / name);
    if (access(file.c_str(), X_OK) == 0) return file.string();
  }
  return fs::read_symlink("/proc/self/exe").string();
}

}  // namespace clothfit
