// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "autodiff_sim/base/sanitized.h"

namespace clothfit {
namespace {

TEST(ParallelFor, DoesEachPieceOnce) {
  for (const int threads : {1, 3, 8}) {
    std::vector<std::atomic<int>> done(50);
    std::atomic<int> most = 0;
    ParallelFor(50, threads, [&](int piece, int worker) {
      ++done[static_cast<std::size_t>(piece)];
      for (int seen = most; seen < worker && !most.compare_exchange_weak(seen, worker);) {
      }
      EXPECT_EQ(NumThreads(8), threads == 1 ? 8 : 1);
    });
    for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
    EXPECT_LT(most, threads);
  }
}

TEST(ParallelFor, NestsWithoutMoreThreads) {
  std::vector<std::atomic<int>> done(40);
  ParallelFor(8, 3, [&](int outer, int) {
    EXPECT_EQ(NumThreads(0), 1);
    ParallelFor(5, NumThreads(0), [&](int inner, int worker) {
      EXPECT_EQ(worker, 0);
      ++done[static_cast<std::size_t>(5 * outer + inner)];
    });
  });
  for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
  EXPECT_GE(NumThreads(0), 1);
}

TEST(ParallelFor, ThrowsWhatAPieceThrew) {
  const auto fail = [](int piece, int) {
    if (piece == 7) throw std::runtime_error("seven");
  };
  for (const int threads : {1, 4}) {
    try {
      ParallelFor(20, threads, fail);
      ADD_FAILURE();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "seven");
    }
  }
}

// Leaves no room in the address space for the stack of one more thread.
void RefuseThreads() {
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  constexpr rlim_t kRoom = 1 << 20;  // bytes; a stack takes eight times as much
  const rlim_t size = static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE)) + kRoom;
  const rlimit limit = {size, size};
  setrlimit(RLIMIT_AS, &limit);
}

// Exits with the number of pieces that were not done; 100 where threads can be had after all.
void WorkWithoutThreads() {
  RefuseThreads();
  std::array<int, 20> done = {};
  try {
    std::thread([] {}).join();
    std::exit(100);
  } catch (const std::system_error&) {
  }
  ParallelFor(20, 4, [&](int piece, int) { ++done[static_cast<std::size_t>(piece)]; });
  std::exit(static_cast<int>(20 - std::count(done.begin(), done.end(), 1)));
}

// As on a node of a cluster that limits them.
TEST(ParallelForDeathTest, GoesOnWithTheThreadsThatThereAre) {
  if (kIsSanitized) GTEST_SKIP() << "the sanitizer's own memory knows no limit";
  EXPECT_EXIT(WorkWithoutThreads(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace clothfit
