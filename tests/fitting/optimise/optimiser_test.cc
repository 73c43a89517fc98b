// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/optimiser.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "fitting/optimise/pattern_search.h"

namespace clothfit {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Objective Over(int n, double start, std::function<double(const Eigen::VectorXd&)> value) {
  Objective objective;
  objective.start = Eigen::VectorXd::Constant(n, start);
  objective.lower = Eigen::VectorXd::Constant(n, -5.0);
  objective.upper = Eigen::VectorXd::Constant(n, 5.0);
  objective.step = Eigen::VectorXd::Constant(n, 0.5);
  objective.value = [value](const Eigen::VectorXd& x, int) { return value(x); };
  return objective;
}

// One coordinate a hundred times as steep as the others.
double Bowl(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (int i = 0; i < x.size(); ++i) {
    const double d = x[i] - 0.3 * (i + 1);
    sum += (i == 0 ? 100.0 : 1.0) * d * d;
  }
  return sum;
}
// A bent valley.
double Rosenbrock(const Eigen::VectorXd& x) {
  const double a = 1.0 - x[0], b = x[1] - x[0] * x[0];
  return a * a + 100.0 * b * b;
}
// Kinks along the coordinates.
double Kinked(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (int i = 0; i < x.size(); ++i) sum += std::abs(x[i] - 0.7 + 0.2 * i);
  return sum;
}
// Steps, as counted pixels make them.
double Stairs(const Eigen::VectorXd& x) { return std::floor(50.0 * Bowl(x)) / 50.0; }

OptimiserOptions Precisely(double tolerance = 1e-4) {
  OptimiserOptions options;
  options.tolerance = tolerance;
  options.budget.evaluations = 200000;
  return options;
}

class DerivativeFree : public testing::TestWithParam<std::string> {};

TEST_P(DerivativeFree, FindsTheMinimumOfABowl) {
  const Minimum minimum = Minimise(GetParam(), Over(4, -1.0, Bowl), Precisely());
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(minimum.x[i], 0.3 * (i + 1), 0.02);
  EXPECT_NEAR(minimum.value, Bowl(minimum.x), 1e-15);
  EXPECT_TRUE(minimum.converged) << minimum.reason;
}

TEST_P(DerivativeFree, FollowsABentValley) {
  const Minimum minimum = Minimise(GetParam(), Over(2, -1.0, Rosenbrock), Precisely(1e-5));
  EXPECT_LT(minimum.value, GetParam() == "direct" ? 0.05 : 2e-3);
}

TEST_P(DerivativeFree, StaysWithinTheBounds) {
  Objective objective = Over(3, 0.0, Bowl);
  objective.upper[1] = 0.25;  // the minimum lies at 0.6
  bool outside = false;
  const auto value = objective.value;
  objective.value = [&](const Eigen::VectorXd& x, int worker) {
    outside = outside || (x.array() < objective.lower.array()).any() ||
              (x.array() > objective.upper.array()).any();
    return value(x, worker);
  };
  const Minimum minimum = Minimise(GetParam(), objective, Precisely());
  EXPECT_FALSE(outside);
  EXPECT_NEAR(minimum.x[1], 0.25, 1e-3);
  EXPECT_NEAR(minimum.x[2], 0.9, 0.03);
}

// A simulation that diverges has no value; it must not end the search, nor be taken.
TEST_P(DerivativeFree, GoesAroundWhatHasNoValue) {
  const auto value = [](const Eigen::VectorXd& x) {
    if (x[0] > 1.0) return std::numeric_limits<double>::quiet_NaN();
    if (x[1] < -2.0) return kInfinity;
    return Bowl(x);
  };
  const Minimum minimum = Minimise(GetParam(), Over(2, 0.9, value), Precisely());
  EXPECT_LT(minimum.value, 0.01);
}

TEST_P(DerivativeFree, KeepsToItsBudgetAndCanBeStopped) {
  OptimiserOptions options = Precisely();
  options.budget.evaluations = 12;
  int evaluations = 0, improvements = 0;
  Objective objective = Over(4, -1.0, Bowl);
  objective.value = [&](const Eigen::VectorXd& x, int) {
    ++evaluations;
    return Bowl(x);
  };
  options.improved = [&](const Eigen::VectorXd& x, double value, int) {
    EXPECT_EQ(value, Bowl(x));
    ++improvements;
  };
  const Minimum minimum = Minimise(GetParam(), objective, options);
  EXPECT_FALSE(minimum.converged);
  EXPECT_EQ(minimum.evaluations, evaluations);
  EXPECT_LE(evaluations, 12);
  EXPECT_GE(improvements, 1);
  const std::atomic<bool> stop = true;
  options.stop = &stop;
  EXPECT_EQ(Minimise(GetParam(), objective, options).reason, "stopped");
}

TEST_P(DerivativeFree, FindsTheSameAgain) {
  const Minimum once = Minimise(GetParam(), Over(3, -1.0, Kinked), Precisely(0.01));
  const Minimum again = Minimise(GetParam(), Over(3, -1.0, Kinked), Precisely(0.01));
  EXPECT_EQ(once.x, again.x);
  EXPECT_EQ(once.evaluations, again.evaluations);
}

INSTANTIATE_TEST_SUITE_P(All, DerivativeFree,
                         testing::Values("pattern", "annealing", "bobyqa", "nelder-mead", "sbplx",
                                         "direct"),
                         [](const auto& instance) {
                           return instance.param == "nelder-mead" ? "nelder_mead" : instance.param;
                         });

TEST(PatternSearch, FindsTheMinimaOfFunctionsWithoutDerivatives) {
  const Minimum kinked = Minimise("pattern", Over(5, -1.0, Kinked), Precisely());
  EXPECT_LT(kinked.value, 1e-3);
  const Minimum stairs = Minimise("pattern", Over(3, -1.0, Stairs), Precisely(0.01));
  EXPECT_LT(stairs.value, 0.05);
}

// What it finds depends on the order in which values come, and on nothing else.
TEST(PatternSearch, IsDeterministicGivenTheOrderOfReports) {
  const auto run = [](unsigned seed, bool check_points) {
    const Objective objective = Over(3, -1.0, Bowl);
    PatternSearch search(objective, Bowl(objective.start), {});
    std::mt19937 random(seed);
    std::vector<PatternSearch::Trial> under_way;
    std::vector<Eigen::VectorXd> asked;
    while (!search.HasConverged()) {
      while (under_way.size() < 4) {
        const auto trial = search.Next();
        if (!trial) break;
        if (check_points) {
          for (const Eigen::VectorXd& x : asked) EXPECT_GT((x - trial->x).norm(), 1e-9);
        }
        asked.push_back(trial->x);
        under_way.push_back(*trial);
      }
      const std::size_t k = random() % under_way.size();
      search.Report(under_way[k].id, Bowl(under_way[k].x));
      under_way.erase(under_way.begin() + static_cast<std::ptrdiff_t>(k));
    }
    EXPECT_LT(search.best_value(), 0.01) << seed;
    return asked;
  };
  EXPECT_EQ(run(1, true), run(1, false));
  EXPECT_NE(run(1, false), run(2, false));
  for (unsigned seed = 3; seed < 10; ++seed) run(seed, false);
}

// Nobody waits: a value that never comes holds up nothing but itself.
TEST(PatternSearch, DoesNotWaitForTheSlowest) {
  const Objective objective = Over(2, -1.0, Bowl);
  PatternSearch search(objective, Bowl(objective.start), {});
  const auto slow = search.Next();
  ASSERT_TRUE(slow.has_value());
  for (auto trial = search.Next(); trial; trial = search.Next()) {
    search.Report(trial->id, Bowl(trial->x));
  }
  EXPECT_LT(search.best_value(), 0.01);
  EXPECT_EQ(search.num_under_way(), 1);
  EXPECT_FALSE(search.HasConverged());
  search.Report(slow->id, kInfinity);
  for (auto trial = search.Next(); trial; trial = search.Next()) {
    search.Report(trial->id, Bowl(trial->x));
  }
  EXPECT_TRUE(search.HasConverged());
}

// Two evaluations wait for one another: with two workers they meet.
TEST(PatternSearch, EvaluatesOnAllThreadsAtOnce) {
  Objective objective = Over(3, -1.0, Bowl);
  objective.num_workers = 2;
  std::mutex mutex;
  std::condition_variable changed;
  int inside = 0, most = 0, calls = 0;
  objective.value = [&](const Eigen::VectorXd& x, int worker) {
    std::unique_lock<std::mutex> lock(mutex);
    EXPECT_TRUE(worker == 0 || worker == 1);
    ++inside;
    most = std::max(most, inside);
    changed.notify_all();
    // The first value is asked for alone, the last ones may be.
    if (++calls > 1 && most < 2) {
      changed.wait_for(lock, std::chrono::seconds(20), [&] { return most >= 2; });
    }
    --inside;
    return Bowl(x);
  };
  const Minimum minimum = Minimise("pattern", objective, Precisely(0.01));
  EXPECT_EQ(most, 2);
  EXPECT_LT(minimum.value, 0.05);
}

// The course is that of the points under way, whoever evaluates them and however long that takes.
TEST(PatternSearch, TakesTheSameCourseForAnyNumberOfThreads) {
  const auto run = [](int workers) {
    Objective objective = Over(3, -1.0, Rosenbrock);
    objective.num_workers = workers;
    std::vector<double> costs(static_cast<std::size_t>(workers));
    objective.value = [&](const Eigen::VectorXd& x, int worker) {
      const double value = Rosenbrock(x);
      costs[static_cast<std::size_t>(worker)] = std::fmod(std::abs(value), 2.0);
      if (workers > 1)
        std::this_thread::sleep_for(std::chrono::microseconds(worker == 1 ? 300 : 20));
      return value;
    };
    objective.cost = [&](int worker) { return costs[static_cast<std::size_t>(worker)]; };
    OptimiserOptions options = Precisely(0.01);
    options.under_way = 5;
    double spent = 0.0;
    options.taken = [&](double cost) { return (spent += cost) < 100.0; };
    std::vector<double> course;
    options.improved = [&](const Eigen::VectorXd&, double value, int evaluations) {
      course.insert(course.end(), {value, spent, static_cast<double>(evaluations)});
    };
    const Minimum minimum = Minimise("pattern", objective, options);
    course.push_back(minimum.evaluations);
    EXPECT_FALSE(minimum.converged);
    EXPECT_GE(spent, 100.0);
    return course;
  };
  const std::vector<double> course = run(1);
  EXPECT_GT(course.size(), 10U);
  EXPECT_EQ(run(3), course);
  EXPECT_EQ(run(5), course);
}

TEST(PatternSearch, PassesOnWhatTheObjectiveThrows) {
  Objective objective = Over(3, -1.0, Bowl);
  objective.num_workers = 2;
  std::atomic<int> calls = 0;
  objective.value = [&](const Eigen::VectorXd& x, int) {
    if (++calls > 5) throw std::runtime_error("broken");
    return Bowl(x);
  };
  EXPECT_THROW(Minimise("pattern", objective, Precisely()), std::runtime_error);
}

TEST(LevenbergMarquardt, NeedsResidualsAndFewEvaluations) {
  Objective objective = Over(2, -1.0, Rosenbrock);
  EXPECT_THROW(Minimise("lm", objective, Precisely()), InputError);
  objective.num_residuals = 2;
  objective.residuals = [](const Eigen::VectorXd& x, Eigen::VectorXd* residuals,
                           RowMajorMatrix* jacobian) {
    residuals->resize(2);
    *residuals << 1.0 - x[0], 10.0 * (x[1] - x[0] * x[0]);
    if (jacobian != nullptr) {
      jacobian->resize(2, 2);
      *jacobian << -1.0, 0.0, -20.0 * x[0], 10.0;
    }
    return true;
  };
  const Minimum minimum = Minimise("lm", objective, Precisely());
  EXPECT_TRUE(minimum.converged);
  EXPECT_LT(minimum.value, 1e-8);
  EXPECT_LT(minimum.evaluations, 60);
  OptimiserOptions few = Precisely();
  few.budget.evaluations = 3;
  EXPECT_FALSE(Minimise("lm", objective, few).converged);
}

// Where an unknown is at its bound the others find the minimum of what is left, whatever the pull
// beyond it; without derivatives where a step is not taken.
TEST(LevenbergMarquardt, FindsTheMinimumWithinBounds) {
  Objective objective = Over(2, -1.0, Rosenbrock);
  objective.upper[0] = 0.5;
  objective.num_residuals = 3;
  int tried = 0, differentiated = 0;
  objective.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    EXPECT_LE(x[0], 0.5);
    ++(jacobian != nullptr ? differentiated : tried);
    residuals->resize(3);
    *residuals << 1.0 - x[0], 10.0 * (x[1] - x[0] * x[0]), 3.0 * (2.0 - x[0]);
    if (jacobian != nullptr) {
      jacobian->resize(3, 2);
      *jacobian << -1.0, 0.0, -20.0 * x[0], 10.0, -3.0, 0.0;
    }
    return true;
  };
  const Minimum minimum = Minimise("lm", objective, Precisely());
  EXPECT_TRUE(minimum.converged);
  EXPECT_EQ(minimum.x[0], 0.5);
  // It ends where the cost of about 10 falls by less than 1e-5.
  EXPECT_NEAR(minimum.x[1], 0.25, 2e-3);
  EXPECT_EQ(minimum.evaluations, tried + 1);  // the start is differentiated at once
  EXPECT_LE(differentiated, tried + 1);
}

TEST(Minimise, RefusesUnknownNamesAndMissingBounds) {
  EXPECT_THROW(Minimise("newton", Over(2, 0.0, Bowl), {}), InputError);
  Objective objective = Over(2, 0.0, Bowl);
  objective.lower[0] = -kInfinity;
  EXPECT_THROW(Minimise("direct", objective, Precisely()), InputError);
  EXPECT_THROW(Minimise("bobyqa", Over(1, 0.0, Bowl), Precisely()), InputError);
  for (const std::string& name : OptimiserNames()) {
    EXPECT_EQ(NeedsDerivatives(name), name == "lm");
  }
}

}  // namespace
}  // namespace clothfit
