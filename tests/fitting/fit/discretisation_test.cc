// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The discretisation error of a fit, against fits and simulations on finer meshes.
#include "fitting/fit/discretisation.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/finer_mesh.h"
#include "fitting/fit/search.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/studies/recovery_study.h"
#include "tests/support/silhouette_scene.h"

namespace clothfit {
namespace {

// Of a cloth that was simulated on a mesh much finer than those it is fitted with.
Recording FinelyMeshed() {
  SyntheticOptions options = DemoRecording();
  options.resolution = {25, 25};
  options.markers = {7, 7};
  options.frame_count = 24;
  return MakeSyntheticRecording(options).recording;
}

FitConfig ConfigOf(const Recording& recording, int side) {
  FitConfig config = DefaultConfig(recording);
  config.resolution = {side, side};
  config.coarse_resolution = 0;
  return config;
}

std::optional<PointFit> MeasureAtStart(const Scene& scene, const FitConfig& config) {
  const JointScenes scenes({{"", &scene, &config}});
  const auto points = MeasurePoints(scenes, scenes.free().start());
  return points ? std::make_optional(points->all) : std::nullopt;
}

std::optional<PointFit> MeasureAtStart(const Recording& recording, int side) {
  const FitConfig config = ConfigOf(recording, side);
  return MeasureAtStart(MakeScene(recording, config), config);
}

Eigen::VectorXd ResidualsOnMesh(const Recording& recording, int side, double step) {
  FitConfig config = ConfigOf(recording, side);
  config.max_step = step;
  const Scene scene = MakeScene(recording, config);
  const FreeParameters free(config, scene, MakeParameterTable());
  Eigen::VectorXd residuals;
  EXPECT_TRUE(EvaluateResiduals(scene, config, free, free.start(), scene.last_fitted_frame,
                                &residuals, nullptr));
  return residuals.head(ObservationResiduals(scene, config).Count(0, scene.last_fitted_frame));
}

// Springs have no clean order of convergence, so that the error is estimated to a factor of two.
TEST(Discretisation, IsEstimatedToAFactorOfTwo) {
  const Recording recording = FinelyMeshed();
  const Eigen::VectorXd truth = ResidualsOnMesh(recording, 41, 1.0 / 960.0);
  for (const int side : {9, 13}) {
    const Eigen::VectorXd own = ResidualsOnMesh(recording, side, 1.0 / 120.0);
    const double error = (own - truth).norm() / std::sqrt(static_cast<double>(own.size()));
    const auto points = MeasureAtStart(recording, side);
    ASSERT_TRUE(points && points->misfit.discretisation);
    EXPECT_LT(*points->misfit.discretisation, 2.0 * error) << side;
    EXPECT_GT(*points->misfit.discretisation, 0.5 * error) << side;
  }
}

// Of a recording whose truth has a finer mesh the error is found in the residuals; of one whose
// truth has the fit's own mesh it is not.
TEST(Discretisation, IsFoundWhereItIs) {
  const auto amplitude = [](const Recording& recording) {
    const FitConfig config = ConfigOf(recording, 9);
    const FitResult fit = FitByStrategy(MakeScene(recording, config), config);
    EXPECT_TRUE(fit.misfit && fit.misfit->amplitude);
    EXPECT_LE(*fit.misfit->without_discretisation, fit.misfit->chi_square * (1.0 + 1e-3));
    return *fit.misfit->amplitude;
  };
  SyntheticOptions own = DemoRecording();
  own.resolution = {9, 9};
  own.markers = {7, 7};
  own.frame_count = 24;
  EXPECT_LT(std::abs(amplitude(MakeSyntheticRecording(own).recording)), 0.25);
  EXPECT_GT(amplitude(FinelyMeshed()), 0.3);
}

// Intervals on a coarse mesh hold more of what a finer one finds than those that do not know of it.
// How often they hold the truth is measured by `clothfit study recovery --finite-elements`.
TEST(Discretisation, WidensIntervals) {
  const Recording recording = FinelyMeshed();
  const FitConfig coarse = ConfigOf(recording, 9), fine = ConfigOf(recording, 17);
  const FitResult on_coarse = FitByStrategy(MakeScene(recording, coarse), coarse);
  const FitResult on_fine = FitByStrategy(MakeScene(recording, fine), fine);
  const FitResult plain = RunFit(MakeScene(recording, coarse), coarse);
  int checked = 0, held = 0, held_by_plain = 0;
  std::string missed;
  for (std::size_t i = 0; i < on_fine.estimates.size(); ++i) {
    const ParameterEstimate& found = on_coarse.estimates[i];
    if (!found.free || !found.determined || !on_fine.estimates[i].determined) continue;
    const double value = on_fine.estimates[i].value;
    ++checked;
    const bool is_held = value >= found.lower95 && value <= found.upper95;
    if (is_held) ++held;
    if (!is_held) {
      missed += fmt::format("{} {:.4g} .. {:.4g}, on the finer mesh {:.4g}; ", found.name,
                            found.lower95, found.upper95, value);
    }
    if (value >= plain.estimates[i].lower95 && value <= plain.estimates[i].upper95) ++held_by_plain;
    EXPECT_LE(found.lower95, plain.estimates[i].lower95 * (1.0 + 1e-9)) << found.name;
    EXPECT_GE(found.upper95, plain.estimates[i].upper95 * (1.0 - 1e-9)) << found.name;
  }
  EXPECT_GE(checked, 4);
  EXPECT_GT(held, held_by_plain) << missed;
}

TEST(Discretisation, IsNotKnownOfMeshesThatAreNoGrid) {
  const Recording recording = FinelyMeshed();
  const FitConfig config = ConfigOf(recording, 7);
  Scene scene = MakeScene(recording, config);
  scene.mesh.grid = {0, 0};
  const auto points = MeasureAtStart(scene, config);
  ASSERT_TRUE(points);
  EXPECT_FALSE(points->misfit.discretisation);
  EXPECT_EQ(points->errors.shift.size(), 0);
}

// Neighbours along an outline and the 0.2 s that hang together.
TEST(Outlines, SayLessThanTheyHaveRows) {
  std::vector<std::vector<double>> outlines(200);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (std::vector<double>& outline : outlines) {
    for (int i = 0; i < 40; ++i) outline.push_back(i % 4 == 0 ? normal(random) : outline.back());
  }
  // Of runs of four 1 + 2 (3/4 + 2/4 + 1/4) say as much as one.
  EXPECT_NEAR(OutlineCorrelation(outlines, 5.0), 4.0, 0.3);
  EXPECT_NEAR(OutlineCorrelation(outlines, 50.0), 40.0, 3.0);
}

// Of a mesh's particles there are no rows, so that those of two meshes can be told apart.
TEST(Outlines, HaveTheSameRowsOnEveryMesh) {
  const SilhouetteScene known = MakeSilhouetteScene();
  FitConfig finer = known.config;
  finer.resolution = {10, 10};
  const auto count = [](const Scene& scene) {
    Eigen::Index rows = 0;
    for (const RowsOfOutline& outline : OutlineRows(scene)) rows += outline.count;
    return rows;
  };
  const Eigen::Index rows = count(known.scene);
  EXPECT_GT(rows, 0);
  EXPECT_EQ(rows, count(MakeScene(known.scene.recording, finer, &known.scene)));
  EXPECT_EQ(rows, ObservationResiduals(known.scene, known.config)
                      .NumObserved(0, known.scene.last_fitted_frame));
}

// By their correlation and by what a finer mesh makes of them.
TEST(Outlines, HaveIntervalsWithMeshAndCorrelation) {
  const SilhouetteScene known = MakeSilhouetteScene();
  const JointScenes scenes({{"", &known.scene, &known.config}});
  const Eigen::VectorXd at = scenes.free().start();
  const std::optional<ModelErrors> errors = MeasureOutlines(scenes, at);
  ASSERT_TRUE(errors);
  EXPECT_GT(errors->correlation, 2.0);
  EXPECT_GT(errors->amplitude, 0.0);
  const SceneOnMeshes one{known.scene, known.config};
  std::vector<SceneOnMeshes> both = {one};
  EvaluateOnMeshes(scenes.free(), at, &both);
  ASSERT_TRUE(both[0].own && both[0].finer);
  EXPECT_EQ(both[0].own->residuals.size(), both[0].finer->residuals.size());
  const MeshRows& own = *both[0].own;
  const auto sigma = [&](const ModelErrors& with) {
    return QuantifyUncertainty(scenes.free(), static_cast<int>(own.residuals.size()), own.residuals,
                               own.jacobian, with)
        .sigma;
  };
  ModelErrors of_mesh = *errors;
  of_mesh.correlation = 1.0;
  const Eigen::VectorXd plain = sigma({}), with_mesh = sigma(of_mesh), with_both = sigma(*errors);
  EXPECT_TRUE((with_mesh.array() >= plain.array() * (1.0 - 1e-9)).all());
  EXPECT_GT((with_mesh - plain).maxCoeff(), 0.0);
  EXPECT_TRUE((with_both.array() >= with_mesh.array() * (1.0 - 1e-9)).all());
  EXPECT_GT((with_both - with_mesh).maxCoeff(), 0.0);
}

// Errors that last four times as long as one residual are four correlated ones.
TEST(Uncertainty, HoldsErrorsThatLast) {
  const Recording recording = FinelyMeshed();
  const FitConfig config = ConfigOf(recording, 7);
  const Scene scene = MakeScene(recording, config);
  const JointScenes scenes({{"", &scene, &config}});
  const std::optional<MeshRows> rows = EvaluateRows(scene, config, scenes.free().start(), true);
  ASSERT_TRUE(rows);
  const auto quantify = [&](const ModelErrors& with) {
    return QuantifyUncertainty(scenes.free(), static_cast<int>(rows->residuals.size()),
                               rows->residuals, rows->jacobian, with);
  };
  const Uncertainty plain = quantify({});
  ModelErrors four, lasting, half;
  four.correlation = 4.0;
  lasting.lasting =
      3.0 * plain.noise_factor * plain.noise_factor * rows->jacobian.transpose() * rows->jacobian;
  const Eigen::VectorXd expected = quantify(four).sigma, found = quantify(lasting).sigma;
  EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
  EXPECT_GT((expected - plain.sigma).maxCoeff(), 0.0);
  // Half of an error that moves an entry by ten of its sigmas moves its interval by five of them,
  // where the data say nothing of how much of it there is.
  half.shift = Eigen::VectorXd::Zero(scenes.free().size());
  half.shift[0] = 10.0 * plain.sigma[0];
  half.mean = half.amplitude = 0.5;
  const Uncertainty moved = quantify(half);
  const double middle = 0.5 * (moved.lower95[0] + moved.upper95[0]);
  EXPECT_NEAR(middle, 5.0 * plain.sigma[0], 1.5 * plain.sigma[0]);
  EXPECT_LT(moved.lower95[0], 0.0);
  EXPECT_GT(moved.upper95[0], 10.0 * plain.sigma[0]);
}

TEST(Outlines, AreMeasuredWhereNothingElseIsSeen) {
  const Recording recording = FinelyMeshed();
  const FitConfig config = ConfigOf(recording, 7);
  const Scene scene = MakeScene(recording, config);
  const JointScenes scenes({{"", &scene, &config}});
  EXPECT_FALSE(MeasureOutlines(scenes, scenes.free().start()));
}

}  // namespace
}  // namespace clothfit
