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
  for (const auto& [first, count, frame] : OutlineRows(scene))
    rows += count + scene.mesh.num_particles();
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

// By how much the residuals are off, by the step and by the mesh.
struct DiscretisationError {
  Eigen::VectorXd of_step, of_mesh;

  Eigen::VectorXd Sum() const { return of_step + of_mesh; }
};

std::optional<DiscretisationError> ErrorOf(const MeshRows& own,
                                           const std::optional<MeshRows>& half_step,
                                           const std::optional<MeshRows>& finer) {
  constexpr double kOfStep = 1.0 / (1.0 - 1.0 / 4.0);
  constexpr double kOfMesh = 1.0 / (1.0 - 1.0 / (kFiner * kFiner));
  const auto fits = [&own](const std::optional<MeshRows>& rows) {
    return rows && rows->residuals.size() == own.residuals.size();
  };
  if (!fits(half_step) || !fits(finer)) return {};
  return DiscretisationError{kOfStep * (own.residuals - half_step->residuals),
                             kOfMesh * (half_step->residuals - finer->residuals)};
}

// What the gradient J' r may be by residuals that last: the sum of the products of the frames'
// gradients with those of frames before and after, with weights that fall to zero at an eighth of
// the frames (Bartlett's, as in Newey and West 1987). frames: of each row.
Eigen::MatrixXd LastingGradient(const std::vector<int>& frames, const RowMajorMatrix& jacobian,
                                const Eigen::VectorXd& residuals) {
  const int count = frames.empty() ? 0 : 1 + *std::max_element(frames.begin(), frames.end());
  Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(jacobian.cols(), count);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    gradients.col(frames[i]) += residuals[row] * jacobian.row(row).transpose();
  }
  const int reach = std::max(1, count / 8);
  Eigen::MatrixXd lasting = gradients * gradients.transpose();
  for (int lag = 1; lag < reach; ++lag) {
    const Eigen::MatrixXd products =
        gradients.leftCols(count - lag) * gradients.rightCols(count - lag).transpose();
    lasting += (1.0 - static_cast<double>(lag) / reach) * (products + products.transpose());
  }
  return lasting;
}

// A fit's rows, and the frame of each.
struct FittedRows {
  const MeshRows& own;
  const std::vector<int>& frames;
  Eigen::MatrixXd prior_jacobian;
};

// What residuals and error tell of how many times the error is there. Its visible part is that
// which no entry makes up for. Where it is there and in step, the residuals follow it, as many
// times as `found`. Of a motion that is chaotic it is out of step, and seen in the chi-square
// alone: what is left may be errors of this size of either sign in each part of the recording, of
// mesh and step each, as many times as explain the chi-square.
void AddDiscretisation(const FittedRows& rows, const DiscretisationError& error, PointFit* fit) {
  const MeshRows& own = rows.own;
  const Eigen::VectorXd sum = error.Sum();
  Misfit& misfit = fit->misfit;
  ModelErrors& errors = fit->errors;
  misfit.discretisation = RootMeanSquare(sum);
  const Eigen::MatrixXd information = own.jacobian.transpose() * own.jacobian +
                                      rows.prior_jacobian.transpose() * rows.prior_jacobian;
  const auto factor = TrySemidefinite(information);
  if (!factor) return;
  errors.shift = factor->solve(own.jacobian.transpose() * sum);
  const Eigen::VectorXd visible = sum - own.jacobian * errors.shift;
  const double squares = visible.squaredNorm();
  const double found = squares > 0.0 ? visible.dot(own.residuals) / squares : 1.0;
  const auto explaining = [&](double chi_square) {
    if (!(squares > 0.0)) return 1.0;
    return std::sqrt(std::max(0.0, chi_square) * misfit.observed / squares);
  };
  misfit.amplitude = std::max(std::abs(found), explaining(misfit.chi_square - misfit.limit));
  errors.mean = std::clamp(found, 0.0, 1.0);
  errors.amplitude = std::max(std::abs(found), explaining(misfit.chi_square - 1.0));
  if (errors.lasting.size() == 0) errors.lasting.setZero(own.jacobian.cols(), own.jacobian.cols());
  for (const Eigen::VectorXd& one : {error.of_step, error.of_mesh}) {
    errors.lasting +=
        errors.amplitude * errors.amplitude * LastingGradient(rows.frames, own.jacobian, one);
  }
  misfit.without_discretisation =
      (own.residuals - found * visible).squaredNorm() /
      std::max(1, misfit.observed - static_cast<int>(information.rows()));
}

PointFit PointFitOf(const std::vector<SeenResidual>& seen, const FreeVector& free,
                    const MeshRows& own, const std::optional<MeshRows>& half_step,
                    const std::optional<MeshRows>& finer) {
  PointFit fit;
  fit.misfit = MeasureMisfit(seen, free.size());
  fit.errors.correlation = fit.misfit.correlation;
  std::vector<int> frames;
  for (const SeenResidual& one : seen) frames.push_back(one.frame);
  if (!fit.misfit.IsNoise())
    fit.errors.lasting = LastingGradient(frames, own.jacobian, own.residuals);
  if (const auto error = ErrorOf(own, half_step, finer))
    AddDiscretisation({own, frames, free.prior_jacobian()}, *error, &fit);
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
    points.push_back({PointsOf(scenes[i].scene), ConfigOfPoints(scenes[i].config)});
  std::vector<NamedScene> named;
  for (std::size_t i = 0; i < points.size(); ++i)
    named.push_back({scenes.named(i).name, &points[i].scene, &points[i].config});
  const JointScenes of_points(std::move(named));
  if (of_points.NumResiduals() == 0) return {};
  EvaluateOnMeshes(scenes.free(), theta, &points);
  const auto own = Stack(scenes.free(), points, &SceneOnMeshes::own);
  if (!own) return {};
  JointPointFit fit;
  fit.all = PointFitOf(SeenResiduals(of_points, own->residuals), scenes.free(), *own,
                       Stack(scenes.free(), points, &SceneOnMeshes::half_step),
                       Stack(scenes.free(), points, &SceneOnMeshes::finer));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SceneOnMeshes& one = points[i];
    fit.of_each.push_back(PointFitOf(SeenResiduals(one.scene, one.own->residuals), scenes[i].free,
                                     *one.own, one.half_step, one.finer));
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
    outlines.push_back({EveryFitted(scene, every), config, static_cast<double>(every)});
  }
  EvaluateOnMeshes(scenes.free(), theta, &outlines);
  const auto own = Stack(scenes.free(), outlines, &SceneOnMeshes::own);
  if (!own) return {};
  std::vector<std::vector<double>> residuals;
  std::vector<int> frames;
  double frame_rate = 0.0, observed = 0.0;
  const double* next = own->residuals.data();
  for (const SceneOnMeshes& one : outlines) {
    for (const auto& [first, count, frame] : OutlineRows(one.scene)) {
      residuals.emplace_back(next, next + count);
      frames.insert(frames.end(), static_cast<std::size_t>(count), frame);
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
  const auto error = ErrorOf(*own, Stack(scenes.free(), outlines, &SceneOnMeshes::half_step),
                             Stack(scenes.free(), outlines, &SceneOnMeshes::finer));
  if (error) AddDiscretisation({*own, frames, scenes.free().prior_jacobian()}, *error, &fit);
  return fit.errors;
}

}  // namespace clothfit
