// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/finer_mesh.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/nudging.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

void KeepRows(const std::vector<std::pair<Eigen::Index, Eigen::Index>>& kept, MeshRows* rows) {
  Eigen::Index to = 0;
  for (const auto& [first, count] : kept) {
    rows->residuals.segment(to, count) = rows->residuals.segment(first, count).eval();
    if (rows->jacobian.cols() > 0)
      rows->jacobian.middleRows(to, count) = rows->jacobian.middleRows(first, count).eval();
    to += count;
  }
  rows->residuals.conservativeResize(to);
  if (rows->jacobian.cols() > 0) rows->jacobian.conservativeResize(to, Eigen::NoChange);
}

std::optional<MeshRows> EvaluateFiner(const Scene& scene, FitConfig config,
                                      const Eigen::VectorXd& theta) {
  if (!scene.mesh.is_grid()) return std::nullopt;
  const std::array<int, 2> grid = scene.mesh.grid;
  config.resolution = GridWithSide(grid, FinerSide(LongerSide(grid)));
  config.max_step = 0.5 * scene.step;
  Scene finer = MakeScene(scene.recording, config, &scene);
  finer.is_fitted = scene.is_fitted;
  return EvaluateRows(finer, config, theta, false);
}

}  // namespace

bool SeesOutlinesAlone(const Scene& scene) {
  return scene.silhouettes && !scene.clouds && !HasPoints(scene);
}

std::vector<std::pair<Eigen::Index, Eigen::Index>> OutlineRows(const Scene& scene) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> rows;
  Eigen::Index row = 0;
  for (const SilhouetteObservation& s : scene.silhouettes->observations) {
    const bool is_seen = s.field && s.frame <= scene.last_fitted_frame &&
                         scene.is_fitted[static_cast<std::size_t>(s.frame)];
    if (!is_seen) continue;
    const auto count = static_cast<Eigen::Index>(s.outline.size());
    rows.emplace_back(row, count);
    row += count + scene.mesh.num_particles();
  }
  return rows;
}

std::optional<MeshRows> EvaluateRows(const Scene& scene, const FitConfig& config,
                                     const Eigen::VectorXd& theta, bool derivatives) {
  const FreeParameters free(config, scene, MakeParameterTable());
  WindowSimulator simulator(scene, config, free, false, nullptr);
  const ObservationResiduals observations(scene, config);
  MeshRows rows;
  const auto outcome = EvaluateWindow(&simulator, observations, simulator.FirstStart(theta), theta,
                                      0, scene.last_fitted_frame, WindowRows::kAll, &rows.residuals,
                                      derivatives ? &rows.jacobian : nullptr);
  if (outcome != WindowSimulator::Outcome::kComplete) return std::nullopt;
  if (SeesOutlinesAlone(scene)) KeepRows(OutlineRows(scene), &rows);
  return rows;
}

void EvaluateBoth(const JointVector& free, const Eigen::VectorXd& theta,
                  std::vector<SceneOnMeshes>* scenes) {
  ParallelFor(2 * static_cast<int>(scenes->size()), NumThreads(0), [&](int piece, int) {
    const auto i = static_cast<std::size_t>(piece / 2);
    const Eigen::VectorXd own = free.Of(i, theta);
    SceneOnMeshes& one = (*scenes)[i];
    if (piece % 2 == 0) one.finer = EvaluateFiner(one.scene, one.config, own);
    if (piece % 2 == 1) one.own = EvaluateRows(one.scene, one.config, own, true);
  });
}

std::optional<MeshRows> Stack(const JointVector& free, const std::vector<SceneOnMeshes>& scenes,
                              std::optional<MeshRows> SceneOnMeshes::*rows) {
  MeshRows all;
  Eigen::Index count = 0;
  for (const SceneOnMeshes& one : scenes) {
    if (!(one.*rows)) return std::nullopt;
    count += (one.*rows)->residuals.size();
  }
  all.residuals.resize(count);
  all.jacobian.setZero((scenes.front().*rows)->jacobian.cols() > 0 ? count : 0, free.size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const MeshRows& one = *(scenes[i].*rows);
    const double root = std::sqrt(scenes[i].weight);
    all.residuals.segment(row, one.residuals.size()) = root * one.residuals;
    if (one.jacobian.cols() > 0) free.PutColumns(i, root * one.jacobian, row, &all.jacobian);
    row += one.residuals.size();
  }
  return all;
}

}  // namespace clothfit
