// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/discretisation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/correlation_time.h"
#include "fitting/fit/finer_mesh.h"
#include "fitting/optimise/checked_factor.h"
#include "fitting/rollout/nudging.h"
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

// One frame of so many, so that the Jacobian of a long recording stays small.
std::size_t ThinningOf(const Scene& scene) {
  constexpr Eigen::Index kMostRows = 50000;
  Eigen::Index rows = 0;
  for (const auto& [first, count] : OutlineRows(scene)) rows += count + scene.mesh.num_particles();
  return static_cast<std::size_t>(1 + rows / kMostRows);
}

Scene EveryFitted(const Scene& scene, std::size_t every) {
  Scene some = scene;
  for (std::size_t frame = 0; frame < some.is_fitted.size(); ++frame)
    if (frame % every != 0) some.is_fitted[frame] = false;
  return some;
}

double RootMeanSquare(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(std::max<double>(1.0, static_cast<double>(values.size())));
}

// How much of the error is there, 0 or more: the amount found of its visible part (`squares`: of
// its rows), which no entry makes up for, or the amount of it that explains the residual beyond
// noise, whichever is larger. Of the other part nothing is seen, so that it is taken to be as much;
// where residuals are more than noise, something between none of it and all that Richardson's
// estimate says: the visible part of a motion that is chaotic is out of step and seems less.
double Amplitude(const Misfit& misfit, double squares, double found) {
  if (!(squares > 0.0)) return 1.0;
  const double beyond_noise = std::max(0.0, misfit.chi_square - misfit.limit);
  return std::max(std::abs(found), std::sqrt(beyond_noise * misfit.observed / squares));
}

void AddDiscretisation(const MeshRows& own, const MeshRows& finer,
                       const Eigen::MatrixXd& prior_jacobian, PointFit* fit) {
  constexpr double kOfDifference = 1.0 / (1.0 - 1.0 / (kFiner * kFiner));
  const Eigen::VectorXd error = kOfDifference * (own.residuals - finer.residuals);
  Misfit& misfit = fit->misfit;
  misfit.discretisation = RootMeanSquare(error);
  const Eigen::MatrixXd information =
      own.jacobian.transpose() * own.jacobian + prior_jacobian.transpose() * prior_jacobian;
  const auto factor = TrySemidefinite(information);
  if (!factor) return;
  fit->errors.shift = factor->solve(own.jacobian.transpose() * error);
  const Eigen::VectorXd visible = error - own.jacobian * fit->errors.shift;
  const double squares = visible.squaredNorm();
  const double found = squares > 0.0 ? visible.dot(own.residuals) / squares : 0.0;
  misfit.amplitude = fit->errors.amplitude = Amplitude(misfit, squares, found);
  if (!misfit.IsNoise()) {
    fit->errors.mean = 0.5;
    fit->errors.amplitude = std::max(0.5, fit->errors.amplitude);
  }
  misfit.without_discretisation =
      (own.residuals - found * visible).squaredNorm() /
      std::max(1, misfit.observed - static_cast<int>(information.rows()));
}

// ModelErrors::lasting: with weights that fall to zero at an eighth of the frames (Bartlett's).
Eigen::MatrixXd LastingGradients(const std::vector<SeenResidual>& seen, const MeshRows& rows) {
  int frames = 0;
  for (const SeenResidual& one : seen) frames = std::max(frames, one.frame + 1);
  Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(rows.jacobian.cols(), frames);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    gradients.col(seen[i].frame) += rows.residuals[row] * rows.jacobian.row(row).transpose();
  }
  const int reach = std::max(1, frames / 8);
  Eigen::MatrixXd lasting = gradients * gradients.transpose();
  for (int lag = 1; lag < reach; ++lag) {
    const Eigen::MatrixXd products =
        gradients.leftCols(frames - lag) * gradients.rightCols(frames - lag).transpose();
    lasting += (1.0 - static_cast<double>(lag) / reach) * (products + products.transpose());
  }
  return lasting;
}

PointFit PointFitOf(const std::vector<SeenResidual>& seen, const FreeVector& free,
                    const MeshRows& own, const std::optional<MeshRows>& finer) {
  PointFit fit;
  fit.misfit = MeasureMisfit(seen, free.size());
  fit.errors.correlation = fit.misfit.correlation;
  if (!fit.misfit.IsNoise()) fit.errors.lasting = LastingGradients(seen, own);
  if (finer && finer->residuals.size() == own.residuals.size())
    AddDiscretisation(own, *finer, free.prior_jacobian(), &fit);
  return fit;
}

}  // namespace

std::optional<Misfit> MisfitOfPoints(const Scene& scene, const FitConfig& config,
                                     const Eigen::VectorXd& theta) {
  if (!HasPoints(scene)) return {};
  const Scene points = PointsOf(scene);
  const FitConfig of_points = ConfigOfPoints(config);
  const std::optional<MeshRows> rows = EvaluateRows(points, of_points, theta, false);
  if (!rows) return {};
  const FreeParameters free(of_points, points, MakeParameterTable());
  return MeasureMisfit(SeenResiduals(points, rows->residuals), free.size());
}

std::optional<JointPointFit> MeasurePoints(const JointScenes& scenes,
                                           const Eigen::VectorXd& theta) {
  std::vector<SceneOnMeshes> points;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    points.push_back({PointsOf(scenes[i].scene), ConfigOfPoints(scenes[i].config), 1.0, {}, {}});
  std::vector<NamedScene> named;
  for (std::size_t i = 0; i < points.size(); ++i)
    named.push_back({scenes.named(i).name, &points[i].scene, &points[i].config});
  const JointScenes of_points(std::move(named));
  if (of_points.NumResiduals() == 0) return {};
  EvaluateBoth(scenes.free(), theta, &points);
  const auto own = Stack(scenes.free(), points, &SceneOnMeshes::own);
  if (!own) return {};
  JointPointFit fit;
  fit.all = PointFitOf(SeenResiduals(of_points, own->residuals), scenes.free(), *own,
                       Stack(scenes.free(), points, &SceneOnMeshes::finer));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SceneOnMeshes& one = points[i];
    fit.of_each.push_back(PointFitOf(SeenResiduals(one.scene, one.own->residuals), scenes[i].free,
                                     *one.own, one.finer));
  }
  return fit;
}

double OutlineCorrelation(const std::vector<std::vector<double>>& outlines, double frame_rate) {
  constexpr double kHangTogether = 0.2;  // s
  return CorrelationTime(outlines) * std::max(1.0, kHangTogether * frame_rate);
}

std::optional<ModelErrors> MeasureOutlines(const JointScenes& scenes,
                                           const Eigen::VectorXd& theta) {
  std::vector<SceneOnMeshes> outlines;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto& [scene, config, free, observations] = scenes[i];
    if (!SeesOutlinesAlone(scene)) return {};
    const std::size_t every = ThinningOf(scene);
    outlines.push_back({EveryFitted(scene, every), config, static_cast<double>(every), {}, {}});
  }
  EvaluateBoth(scenes.free(), theta, &outlines);
  const auto own = Stack(scenes.free(), outlines, &SceneOnMeshes::own);
  if (!own) return {};
  const std::optional<MeshRows> finer = Stack(scenes.free(), outlines, &SceneOnMeshes::finer);
  std::vector<std::vector<double>> residuals;
  double frame_rate = 0.0, observed = 0.0;
  const double* next = own->residuals.data();
  for (const SceneOnMeshes& one : outlines) {
    for (const auto& [first, count] : OutlineRows(one.scene)) {
      residuals.emplace_back(next, next + count);
      next += count;
    }
    frame_rate = std::max(frame_rate, one.scene.recording.frame_rate);
    observed += one.weight * static_cast<double>(one.own->residuals.size());
  }
  PointFit fit;
  fit.misfit.observed = static_cast<int>(observed);
  fit.misfit.chi_square =
      own->residuals.squaredNorm() / std::max(1, fit.misfit.observed - scenes.free().size());
  fit.misfit.correlation = OutlineCorrelation(residuals, frame_rate);
  fit.misfit.limit = ChiSquareLimit(observed / fit.misfit.correlation);
  fit.errors.correlation = fit.misfit.correlation;
  if (finer && finer->residuals.size() == own->residuals.size())
    AddDiscretisation(*own, *finer, scenes.free().prior_jacobian(), &fit);
  return fit.errors;
}

}  // namespace clothfit
