// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which one of many processes this is, as mpirun (Open MPI, MPICH and their kin) and Slurm's srun
// tell those that they launch.
#pragma once

#include <string>

namespace clothfit {

struct Ranks {
  int rank = 0, size = 1;
  std::string launch;  // the same for all processes of a launch; empty where there is one alone
};

// From the environment. Alone where nobody says otherwise, or what they say is no rank.
Ranks FindRanks();

}  // namespace clothfit
