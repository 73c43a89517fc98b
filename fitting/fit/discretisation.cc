// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/discretisation.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/optimise/checked_factor.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

// A scene's markers and tracks alone.
Scene PointsOf(const Scene& scene) {
  Scene points = scene;
  points.silhouettes.reset();
  points.clouds.reset();
  return points;
}

FitConfig ConfigOfPoints(const FitConfig& config) {
  FitConfig of_points = config;
  of_points.use_silhouettes = false;
  of_points.use_clouds = false;
  of_points.beta = 1.0;  // sigmas, not shares of a cost
  of_points.attract = false;
  return of_points;
}

struct PointRows {
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
};

std::optional<PointRows> Evaluate(const Scene& scene, const FitConfig& config,
                                  const Eigen::VectorXd& theta, bool derivatives) {
  const FreeParameters free(config, scene, MakeParameterTable());
  WindowSimulator simulator(scene, config, free, false, nullptr);
  const ObservationResiduals observations(scene, config);
  PointRows rows;
  const auto outcome = EvaluateWindow(&simulator, observations, simulator.FirstStart(theta), theta,
                                      0, scene.last_fitted_frame, WindowRows::kAll, &rows.residuals,
                                      derivatives ? &rows.jacobian : nullptr);
  if (outcome != WindowSimulator::Outcome::kComplete) return std::nullopt;
  return rows;
}

std::optional<PointRows> EvaluateFiner(const Scene& scene, FitConfig config,
                                       const Eigen::VectorXd& theta) {
  if (!scene.mesh.is_grid()) return std::nullopt;
  const std::array<int, 2> grid = scene.mesh.grid;
  config.resolution = GridWithSide(grid, FinerSide(std::max(grid[0], grid[1])));
  config.max_step = 0.5 * scene.step;
  return Evaluate(MakeScene(scene.recording, config), config, theta, false);
}

double RootMeanSquare(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(std::max<double>(1.0, static_cast<double>(values.size())));
}

// How much of the error is there, 0 or more: what is found of its visible part (`squares`: of its
// rows), which no entry makes up for, or as much of that as explains what is left beyond noise,
// whichever is larger. Of the other part nothing is seen, so that it is taken to be as much.
double Amplitude(const Misfit& misfit, double squares, double found) {
  if (!(squares > 0.0)) return 1.0;
  const double beyond_noise = std::max(0.0, misfit.chi_square - misfit.limit);
  return std::max(std::abs(found), std::sqrt(beyond_noise * misfit.observed / squares));
}

void AddDiscretisation(const PointRows& own, const PointRows& finer,
                       const Eigen::MatrixXd& prior_jacobian, PointFit* fit) {
  constexpr double kOfDifference = 1.0 / (1.0 - 1.0 / (kFiner * kFiner));
  const Eigen::VectorXd error = kOfDifference * (own.residuals - finer.residuals);
  Misfit& misfit = fit->misfit;
  misfit.discretisation = RootMeanSquare(error);
  const Eigen::MatrixXd information =
      own.jacobian.transpose() * own.jacobian + prior_jacobian.transpose() * prior_jacobian;
  const auto factor = TrySemidefinite(information);
  if (!factor) return;
  const Eigen::VectorXd made_up = own.jacobian * factor->solve(own.jacobian.transpose() * error);
  const Eigen::VectorXd visible = error - made_up;
  const double squares = visible.squaredNorm();
  const double found = squares > 0.0 ? visible.dot(own.residuals) / squares : 0.0;
  misfit.amplitude = fit->errors.amplitude = Amplitude(misfit, squares, found);
  fit->errors.by_entries = own.jacobian.transpose() * made_up;
  fit->errors.squares = made_up.squaredNorm();
  misfit.without_discretisation =
      (own.residuals - found * visible).squaredNorm() /
      std::max(1, misfit.observed - static_cast<int>(information.rows()));
}

}  // namespace

std::optional<PointFit> MeasurePoints(const Scene& scene, const FitConfig& config,
                                      const FreeParameters& free, const Eigen::VectorXd& theta) {
  const Scene points = PointsOf(scene);
  const FitConfig of_points = ConfigOfPoints(config);
  if (ObservationResiduals(points, of_points).Count(0, points.last_fitted_frame) == 0) return {};
  std::optional<PointRows> own, finer;
  ParallelFor(2, NumThreads(0), [&](int i, int) {
    if (i == 0) finer = EvaluateFiner(points, of_points, theta);
    if (i == 1) own = Evaluate(points, of_points, theta, true);
  });
  if (!own) return {};
  PointFit fit;
  fit.misfit = MeasureMisfit(SeenResiduals(points, own->residuals), free.size());
  fit.errors.correlation = fit.misfit.correlation;
  if (finer && finer->residuals.size() == own->residuals.size())
    AddDiscretisation(*own, *finer, free.prior_jacobian(), &fit);
  return fit;
}

}  // namespace clothfit
