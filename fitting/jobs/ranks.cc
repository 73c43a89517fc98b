// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/ranks.h"

#include <cstdlib>
#include <optional>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::string Variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Who launches, and under which names it tells rank, number and launch.
struct Launcher {
  const char *rank, *size, *launch, *part;
};
constexpr Launcher kLaunchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE", ""},
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_JOB_ID", "SLURM_STEP_ID"},
    {"PMI_RANK", "PMI_SIZE", "PMI_FD", ""},
};

}  // namespace

Ranks FindRanks() {
  for (const Launcher& launcher : kLaunchers) {
    const std::optional<int> rank = ParseInteger(Variable(launcher.rank));
    const std::optional<int> size = ParseInteger(Variable(launcher.size));
    if (!rank || !size || *rank < 0 || *size <= *rank || *size == 1) continue;
    return {*rank, *size, Variable(launcher.launch) + "." + Variable(launcher.part)};
  }
  return {};
}

}  // namespace clothfit
