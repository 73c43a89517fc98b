// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// `clothfit` where it is installed for every processor: starts the program of the highest
// instruction set that this one has, ../lib/clothfit/x86-64-v3/clothfit for example. The
// environment variable CLOTHFIT_INSTRUCTION_SET asks for another.
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <unistd.h>

#include "apps/launcher/instruction_set.h"

namespace {

constexpr int kExitBadInput = 2;

int Fail(const std::string& problem) {
  std::fprintf(stderr, "clothfit: error: %s\n", problem.c_str());
  return kExitBadInput;
}

// Of this program's own file, links followed.
std::string OwnFolder() {
  char path[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
  const std::string file(path, length > 0 ? static_cast<size_t>(length) : 0);
  return file.substr(0, file.rfind('/'));
}

}  // namespace

int main(int /*argc*/, char** argv) {
  const std::string programs = OwnFolder() + "/../lib/clothfit/";
  const char* const wanted = std::getenv("CLOTHFIT_INSTRUCTION_SET");
  for (const char* const instruction_set : clothfit::kInstructionSets) {
    if (wanted != nullptr && std::string(wanted) != instruction_set) continue;
    if (!clothfit::ProcessorHas(instruction_set)) {
      if (wanted == nullptr) continue;
      return Fail("CLOTHFIT_INSTRUCTION_SET: this processor has no " + std::string(wanted));
    }
    execv((programs + instruction_set + "/clothfit").c_str(), argv);
  }
  if (wanted != nullptr) {
    return Fail(
        "CLOTHFIT_INSTRUCTION_SET: expected x86-64-v2, x86-64-v3 or x86-64-v4 that is "
        "installed, found '" +
        std::string(wanted) + "'");
  }
  return Fail(programs + ": no program that this processor can run");
}
