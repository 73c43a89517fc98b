// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/ledger.h"

#include <chrono>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr double kLeasePatience = 60.0;  // s, longer than any of these tests

std::string ThisHost() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

// No process has this number: the kernel's are at most 2^22.
constexpr int kNoProcess = 1 << 29;

TEST(JobLedger, GivesAJobToOneWorkerAtATime) {
  const TestFolder folder;
  JobLedger one(folder.path(), kLeasePatience, 0), other(folder.path(), kLeasePatience, 1);
  EXPECT_TRUE(one.Take("a"));
  EXPECT_FALSE(other.Take("a"));
  EXPECT_TRUE(other.Take("b"));
  other.Release("a");  // not its own
  EXPECT_FALSE(other.Take("a"));
  one.Release("a");
  EXPECT_TRUE(other.Take("a"));
}

TEST(JobLedger, KeepsTheFirstResult) {
  const TestFolder folder;
  JobLedger ledger(folder.path(), kLeasePatience, 0);
  EXPECT_FALSE(ledger.Read("a"));
  ledger.Record({"a", 0.1, "", 2.5});
  ledger.Record({"a", 7.0, "", 3.5});
  const std::optional<JobResult> read = ledger.Read("a");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->output.get<double>(), 0.1);
  EXPECT_EQ(read->seconds, 2.5);
  EXPECT_TRUE(read->IsDone());
  EXPECT_FALSE(ledger.Take("a"));
  folder.Write("b.json", "{}");
  EXPECT_THROW(ledger.Read("b"), InputError);
}

TEST(JobLedger, TakesWhatADeadWorkerHad) {
  const TestFolder folder;
  JobLedger ledger(folder.path(), kLeasePatience, 0);
  folder.Write("a.lease", fmt::format("{} {} 0", ThisHost(), kNoProcess));
  EXPECT_TRUE(ledger.Take("a"));
  folder.Write("b.lease", "some-other-machine 17 0");  // cannot be asked, but was alive just now
  EXPECT_FALSE(ledger.Take("b"));
}

TEST(JobLedger, TakesWhatASilentWorkerHad) {
  const TestFolder folder;
  JobLedger patient(folder.path(), kLeasePatience, 0), impatient(folder.path(), 0.05, 1);
  folder.Write("a.lease", "some-other-machine 17 0");
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(patient.Take("a"));
  EXPECT_TRUE(impatient.Take("a"));
}

TEST(JobLedger, GivesUpAJobThatKillsItsWorkers) {
  const TestFolder folder;
  JobLedger ledger(folder.path(), kLeasePatience, 0);
  for (int i = 0; i < JobLedger::kMostLosses; ++i) {
    EXPECT_FALSE(ledger.HasResult("a"));
    folder.Write("a.lease", fmt::format("{} {} 0", ThisHost(), kNoProcess));
    EXPECT_EQ(ledger.Take("a"), i + 1 < JobLedger::kMostLosses);
  }
  ASSERT_TRUE(ledger.Read("a"));
  EXPECT_THAT(ledger.Read("a")->problem, testing::HasSubstr("3 workers died"));
}

}  // namespace
}  // namespace clothfit
