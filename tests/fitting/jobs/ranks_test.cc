// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/ranks.h"

#include <cstdlib>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// Only these variables are set while it lives.
class Environment {
 public:
  explicit Environment(const std::map<std::string, std::string>& values) {
    Clear();
    for (const auto& [name, value] : values) setenv(name.c_str(), value.c_str(), 1);
  }
  ~Environment() { Clear(); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  static void Clear() {
    for (const char* name :
         {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE", "SLURM_PROCID",
          "SLURM_STEP_NUM_TASKS", "SLURM_JOB_ID", "SLURM_STEP_ID", "PMI_RANK", "PMI_SIZE"})
      unsetenv(name);
  }
};

TEST(Ranks, AreThoseOfTheLauncher) {
  {
    const Environment open_mpi(
        {{"OMPI_COMM_WORLD_RANK", "2"}, {"OMPI_COMM_WORLD_SIZE", "3"}, {"PMIX_NAMESPACE", "77"}});
    const Ranks ranks = FindRanks();
    EXPECT_EQ(ranks.rank, 2);
    EXPECT_EQ(ranks.size, 3);
    EXPECT_EQ(ranks.launch, "77.");
  }
  const Environment slurm({{"SLURM_PROCID", "0"},
                           {"SLURM_STEP_NUM_TASKS", "4"},
                           {"SLURM_JOB_ID", "12"},
                           {"SLURM_STEP_ID", "1"}});
  EXPECT_EQ(FindRanks().size, 4);
  EXPECT_EQ(FindRanks().launch, "12.1");
}

TEST(Ranks, AreOneWhereNobodySaysOtherwise) {
  for (const auto& [rank, size] : std::map<std::string, std::string>{
           {"", ""}, {"0", "1"}, {"3", "3"}, {"-1", "2"}, {"one", "two"}}) {
    const Environment values({{"OMPI_COMM_WORLD_RANK", rank}, {"OMPI_COMM_WORLD_SIZE", size}});
    EXPECT_EQ(FindRanks().size, 1) << rank << " of " << size;
    EXPECT_EQ(FindRanks().rank, 0);
  }
}

}  // namespace
}  // namespace clothfit
