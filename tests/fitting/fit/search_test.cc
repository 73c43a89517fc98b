// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/search.h"

#include <cmath>
#include <limits>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/residuals/synthesis_error.h"
#include "tests/support/silhouette_scene.h"

namespace clothfit {
namespace {

FitConfig With(FitConfig config, const std::string& optimiser, Strategy loops) {
  config.optimiser = optimiser;
  config.loops = loops;
  return config;
}

// SynthesisError of a free vector, simulated by other means than the search's.
double HardError(const SilhouetteScene& known, const FitConfig& config,
                 const Eigen::VectorXd& theta) {
  const FreeParameters free(config, known.scene, MakeParameterTable());
  const SynthesisError error(known.scene, config);
  double sum = 0.0;
  SimulateFrames(known.scene, config, free, theta, known.scene.last_fitted_frame,
                 [&](int frame, const State& state) { sum += error.OfFrame(frame, state.x); });
  return sum;
}

void ExpectFallingHistory(const SearchResult& found) {
  ASSERT_FALSE(found.history.empty());
  for (std::size_t i = 1; i < found.history.size(); ++i) {
    EXPECT_LT(found.history[i].error, found.history[i - 1].error);
    EXPECT_GE(found.history[i].simulations, found.history[i - 1].simulations);
    EXPECT_GE(found.history[i].seconds, found.history[i - 1].seconds);
  }
  EXPECT_LE(found.history.back().simulations, found.simulations);
}

struct Reach {
  const char* optimiser;
  double share;  // of the error at the start, to get below
};
void PrintTo(const Reach& reach, std::ostream* out) { *out << reach.optimiser; }

class JointSearch : public testing::TestWithParam<Reach> {};

TEST_P(JointSearch, FindsAFabricThatExplainsTheSilhouettesBetter) {
  const SilhouetteScene known = MakeSilhouetteScene();
  const FitConfig config = With(known.config, GetParam().optimiser, Strategy::kJoint);
  const FreeParameters free(config, known.scene, MakeParameterTable());
  SearchOptions options;
  options.budget.evaluations = 100.0;
  options.num_threads = 2;
  const SearchResult found = Search(known.scene, config, options);
  const double at_start = HardError(known, config, free.start());
  EXPECT_LT(found.error, GetParam().share * at_start);
  EXPECT_EQ(found.error, HardError(known, config, found.theta));
  EXPECT_EQ(found.error, found.open_loop_error);
  EXPECT_EQ(static_cast<int>(found.positions.size()), known.scene.last_fitted_frame + 1);
  ExpectFallingHistory(found);
  constexpr double kUnderWay = 6.0;  // an iteration with derivatives, what the threads began
  EXPECT_LE(found.simulations, 100.0 + kUnderWay);
}

INSTANTIATE_TEST_SUITE_P(ByOptimiser, JointSearch,
                         testing::Values(Reach{"lm", 0.7}, Reach{"pattern", 0.7},
                                         Reach{"bobyqa", 0.7}, Reach{"nelder-mead", 0.7},
                                         Reach{"sbplx", 0.9}));

TEST(Search, DerivativesNeedFewerSimulations) {
  const SilhouetteScene known = MakeSilhouetteScene();
  SearchOptions options;
  options.budget.evaluations = 300.0;
  options.derivative_cost = 4.0;  // about what is measured; measured here it would time the machine
  const SearchResult lm = Search(known.scene, With(known.config, "lm", Strategy::kJoint), options);
  const SearchResult pattern =
      Search(known.scene, With(known.config, "pattern", Strategy::kJoint), options);
  EXPECT_LE(lm.error, pattern.error);
  // What each had spent when it was as low as pattern search ever got.
  const auto reached = [&](const SearchResult& found) {
    for (const SearchPoint& point : found.history) {
      if (point.error <= pattern.error) return point.simulations;
    }
    return found.simulations;
  };
  EXPECT_LT(reached(lm), 0.5 * reached(pattern));
}

class TwoLoops : public testing::TestWithParam<const char*> {};

TEST_P(TwoLoops, SearchFabricOutsideAndHandlesInside) {
  const SilhouetteScene known = MakeSilhouetteScene(true, 8);
  SearchOptions options;
  options.num_threads = 2;
  options.derivative_cost = 4.0;     // as above
  options.budget.evaluations = 1.0;  // one pass begins, however long it takes
  FitConfig config = With(known.config, GetParam(), Strategy::kTwoLoop);
  // Few, so that pattern search comes to each of them.
  for (auto& [name, setting] : config.parameters)
    setting.free = name == "air_drag.normal" || name == "bending.stiffness";
  const SearchResult first = Search(known.scene, config, options);
  options.budget.evaluations = GetParam() == std::string("lm") ? 200.0 : 150.0;
  const SearchResult found = Search(known.scene, config, options);
  EXPECT_LT(found.error, first.error)
      << found.reason << ", " << found.simulations << " of " << first.simulations;
  ExpectFallingHistory(found);
  EXPECT_EQ(static_cast<int>(found.positions.size()), known.scene.last_fitted_frame + 1);
  EXPECT_TRUE(std::isfinite(found.open_loop_error));
}

INSTANTIATE_TEST_SUITE_P(ByOptimiser, TwoLoops, testing::Values("lm", "pattern"));

TEST(Search, OneLoopIsOnePass) {
  const SilhouetteScene known = MakeSilhouetteScene(true);
  const SearchResult found =
      Search(known.scene, With(known.config, "lm", Strategy::kOneLoop), SearchOptions());
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.history.size(), 1U);
  EXPECT_TRUE(std::isfinite(found.error));
}

TEST(Search, SaysWhatDoesNotGoTogether) {
  const SilhouetteScene known = MakeSilhouetteScene(true);
  EXPECT_THROW(
      Search(known.scene, With(known.config, "direct", Strategy::kTwoLoop), SearchOptions()),
      InputError);
}

TEST(Search, EndsWhenStopped) {
  const SilhouetteScene known = MakeSilhouetteScene();
  std::atomic<bool> stop = false;
  SearchOptions options;
  options.stop = &stop;
  int evaluations = 0;
  options.progress = [&](const SearchPoint&) { stop = ++evaluations >= 5; };
  const SearchResult found =
      Search(known.scene, With(known.config, "pattern", Strategy::kJoint), options);
  EXPECT_FALSE(found.converged);
  EXPECT_LE(evaluations, 7);
}

TEST(FitByStrategy, ReportsWhatASearchFound) {
  const SilhouetteScene known = MakeSilhouetteScene();
  FitConfig config = With(known.config, "bobyqa", Strategy::kJoint);
  config.max_simulations = 40.0;
  FitCallbacks callbacks;
  int checkpoints = 0;
  callbacks.checkpoint = [&](const FitCheckpoint& checkpoint) {
    ++checkpoints;
    EXPECT_GT(checkpoint.theta.size(), 0);
  };
  const FitResult fit = FitByStrategy(known.scene, config, callbacks);
  EXPECT_LT(*fit.after.silhouette_error, 0.7 * *fit.before.silhouette_error);
  EXPECT_GT(checkpoints, 1);
  EXPECT_GE(fit.simulations, 40);
  EXPECT_LE(fit.simulations, 43);
}

// A fit that may not iterate has stalled.
TEST(FitByStrategy, PolishesAStalledFitOnTheHardError) {
  const SilhouetteScene known = MakeSilhouetteScene();
  FitConfig config = known.config;
  config.max_iterations = 2;
  std::string log;
  FitCallbacks callbacks;
  callbacks.log = [&](const std::string& line) { log += line + "\n"; };
  const FitResult polished = FitByStrategy(known.scene, config, callbacks);
  EXPECT_THAT(log, testing::HasSubstr("stalled on the soft silhouette error"));
  config.polish_hard = false;
  const FitResult stalled = FitByStrategy(known.scene, config, {});
  EXPECT_EQ(stalled.status, FitStatus::kNotConverged);
  EXPECT_LE(HardError(known, config, polished.theta), HardError(known, config, stalled.theta));
  EXPECT_GT(polished.simulations, stalled.simulations);
  EXPECT_LE(polished.simulations, 2 * stalled.simulations + 3);
}

}  // namespace
}  // namespace clothfit
