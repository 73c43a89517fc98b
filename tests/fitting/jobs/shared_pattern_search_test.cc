// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/jobs/shared_pattern_search.h"

#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

// Rosenbrock 1960, which bends, with a wall that has no value.
double Valley(const Eigen::VectorXd& x) {
  if (x[1] > 3.0) return std::numeric_limits<double>::infinity();
  const double a = 1.0 - x[0], b = x[1] - x[0] * x[0];
  return a * a + 10.0 * b * b;
}

Objective MakeObjective(int delay_ms, double* spent) {
  Objective objective;
  objective.start = Eigen::Vector2d(-1.0, 1.5);
  objective.lower = Eigen::Vector2d(-5.0, -5.0);
  objective.upper = Eigen::Vector2d(5.0, 5.0);
  objective.step = Eigen::Vector2d(0.5, 0.5);
  objective.value = [=](const Eigen::VectorXd& x, int) {
    if (delay_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    *spent += 1.0;
    return Valley(x);
  };
  return objective;
}

SharedMinimum Search(const TestFolder& folder, int worker, int delay_ms) {
  double spent = 0.0;
  SharedSearchOptions options;
  options.folder = folder.path();
  options.worker = worker;
  options.slots = 4;
  options.most_spent = 60.0;
  options.spent = [&] { return spent; };
  return SearchPatternTogether(MakeObjective(delay_ms, &spent), options);
}

void ExpectSame(const SharedMinimum& one, const SharedMinimum& other) {
  EXPECT_EQ(one.minimum.x, other.minimum.x);
  EXPECT_EQ(one.minimum.value, other.minimum.value);
  EXPECT_EQ(one.minimum.evaluations, other.minimum.evaluations);
  EXPECT_EQ(one.spent, other.spent);
}

TEST(SearchPatternTogether, FindsTheMinimum) {
  const TestFolder folder;
  double spent = 0.0;
  SharedSearchOptions options;
  options.folder = folder.path();
  options.slots = 3;
  options.tolerance = 0.001;
  options.spent = [&] { return spent; };
  options.most_spent = 300.0;
  const SharedMinimum found = SearchPatternTogether(MakeObjective(0, &spent), options);
  EXPECT_LT(found.minimum.value, 0.1 * Valley(Eigen::Vector2d(-1.0, 1.5)));
}

TEST(SearchPatternTogether, GivesEveryWorkerTheSameAsOneAlone) {
  const TestFolder alone, together;
  const SharedMinimum expected = Search(alone, 0, 0);
  EXPECT_EQ(expected.spent, expected.minimum.evaluations);
  std::vector<SharedMinimum> found(3);
  std::vector<std::thread> threads;
  for (int w = 0; w < 3; ++w)
    threads.emplace_back([&, w] { found[static_cast<std::size_t>(w)] = Search(together, w, w); });
  for (std::thread& thread : threads) thread.join();
  for (const SharedMinimum& one : found) ExpectSame(one, expected);
}

TEST(SearchPatternTogether, SurvivesTheDeathOfAProcess) {
  const TestFolder alone, together;
  const SharedMinimum expected = Search(alone, 0, 0);
  const pid_t other = fork();
  if (other == 0) {
    Search(together, 1, 20);
    _exit(0);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(70));  // it has a point in hand
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  ExpectSame(Search(together, 0, 0), expected);
}

}  // namespace
}  // namespace clothfit
