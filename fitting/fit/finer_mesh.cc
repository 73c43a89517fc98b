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

void KeepRows(const std::vector<RowsOfOutline>& kept, MeshRows* rows) {
  Eigen::Index to = 0;
  for (const auto& [first, count, frame] : kept) {
    rows->residuals.segment(to, count) = rows->residuals.segment(first, count).eval();
    if (rows->jacobian.cols() > 0)
      rows->jacobian.middleRows(to, count) = rows->jacobian.middleRows(first, count).eval();
    to += count;
  }
  rows->residuals.conservativeResize(to);
  if (rows->jacobian.cols() > 0) rows->jacobian.conservativeResize(to, Eigen::NoChange);
}

// On a grid with so many particles along its longer side, with half the step.
std::optional<MeshRows> EvaluateWithHalfStep(const Scene& scene, FitConfig config, int side,
                                             const Eigen::VectorXd& theta) {
  config.resolution = GridWithSide(scene.mesh.grid, side);
  config.max_step = 0.5 * scene.step;
  Scene other = MakeScene(scene.recording, config, &scene);
  other.is_fitted = scene.is_fitted;
  return EvaluateRows(other, config, theta, false);
}

}  // namespace

bool SeesOutlinesAlone(const Scene& scene) {
  return scene.silhouettes && !scene.clouds && !HasPoints(scene);
}

std::vector<RowsOfOutline> OutlineRows(const Scene& scene) {
  std::vector<RowsOfOutline> rows;
  Eigen::Index row = 0;
  for (const SilhouetteObservation& s : scene.silhouettes->observations) {
    const bool is_seen = s.field && s.frame <= scene.last_fitted_frame &&
                         scene.is_fitted[static_cast<std::size_t>(s.frame)];
    if (!is_seen) continue;
    const auto count = static_cast<Eigen::Index>(s.outline.size());
    rows.push_back({row, count, s.frame});
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

void EvaluateOnMeshes(const JointVector& free, const Eigen::VectorXd& theta,
                      std::vector<SceneOnMeshes>* scenes) {
  constexpr int kPieces = 3;  // the longest first
  ParallelFor(kPieces * static_cast<int>(scenes->size()), NumThreads(0), [&](int k, int) {
    const auto i = static_cast<std::size_t>(k / kPieces);
    const Eigen::VectorXd own = free.Of(i, theta);
    SceneOnMeshes& one = (*scenes)[i];
    const int piece = k % kPieces, side = LongerSide(one.scene.mesh.grid);
    if (piece == 1) one.own = EvaluateRows(one.scene, one.config, own, true);
    if (piece == 1 || !one.scene.mesh.is_grid()) return;
    std::optional<MeshRows>& rows = piece == 0 ? one.finer : one.half_step;
    rows = EvaluateWithHalfStep(one.scene, one.config, piece == 0 ? FinerSide(side) : side, own);
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
