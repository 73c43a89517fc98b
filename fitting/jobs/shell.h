// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Other programs, by the shell.
#pragma once

#include <string>
#include <vector>

namespace clothfit {

// The word as a shell reads it back, in quotes where it needs some.
std::string ShellWord(const std::string& word);

struct ShellResult {
  int status = -1;     // the exit status; 127 where there is no such program
  std::string output;  // of both streams
};
ShellResult RunProgram(const std::vector<std::string>& words);

// The file of this program that others are to start: a link or a launcher, as it was called, rather
// than what stands behind it. Absolute.
std::string OwnProgram();

}  // namespace clothfit
