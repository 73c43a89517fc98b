// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/triangulation.h"

#include <cmath>
#include <limits>

#include <ceres/autodiff_cost_function.h>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

namespace clothfit {
namespace {

using Eigen::Vector3d;

// Reprojection of one point in the sightings that agree.
struct Reprojection {
  using Scalar = double;
  template <class T>
  bool operator()(const T* const point, T* residuals) const {
    const Eigen::Matrix<T, 3, 1> p(point[0], point[1], point[2]);
    int row = 0;
    for (std::size_t i = 0; i < sightings->size(); ++i) {
      if (!(*agrees)[i]) continue;
      const Sighting& s = (*sightings)[i];
      const Eigen::Matrix<T, 2, 1> pixel = ProjectPoint<T>((*cameras)[s.camera], p);
      residuals[row++] = pixel.x() - s.pixel.x();
      residuals[row++] = pixel.y() - s.pixel.y();
    }
    return true;
  }
  int NumResiduals() const { return 2 * count; }

  const std::vector<Camera>* cameras;
  const std::vector<Sighting>* sightings;
  const std::vector<bool>* agrees;
  int count = 0;
};

struct Agreement {
  std::vector<bool> agrees;
  int count = 0;
  double sum = 0.0;  // of squared errors, px^2
};

Agreement FindAgreement(const std::vector<double>& errors, double gate) {
  Agreement result;
  for (const double e : errors) {
    result.agrees.push_back(e <= gate);
    if (e > gate) continue;
    ++result.count;
    result.sum += e * e;
  }
  return result;
}

Vector3d Refine(const std::vector<Camera>& cameras, const std::vector<Sighting>& sightings,
                const Agreement& agreement, const Vector3d& start) {
  const Reprojection reprojection{&cameras, &sightings, &agreement.agrees, agreement.count};
  using Function = ceres::TinySolverAutoDiffFunction<Reprojection, Eigen::Dynamic, 3>;
  const Function function(reprojection);
  ceres::TinySolver<Function> solver;
  Vector3d position = start;
  solver.Solve(function, &position);
  return position.allFinite() ? position : start;
}

// The pair whose point most sightings agree with; among equals the one with the least errors.
std::optional<Vector3d> BestPair(const std::vector<Camera>& cameras,
                                 const std::vector<Sighting>& sightings,
                                 const TriangulationOptions& options) {
  std::vector<std::optional<PluckerRay<double>>> rays;
  for (const Sighting& s : sightings) rays.push_back(RayThroughPixel(cameras[s.camera], s.pixel));
  std::optional<Vector3d> best;
  Agreement best_agreement;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t j = i + 1; j < rays.size(); ++j) {
      if (!rays[i] || !rays[j]) continue;
      if (rays[i]->direction.cross(rays[j]->direction).norm() < std::sin(options.min_angle))
        continue;
      const std::optional<Vector3d> point = MeanClosestPoint({*rays[i], *rays[j]});
      if (!point) continue;
      const std::vector<double> errors = ReprojectionErrors(cameras, sightings, *point);
      // The pair has to agree with itself.
      if (errors[i] > options.gate || errors[j] > options.gate) continue;
      const Agreement agreement = FindAgreement(errors, options.gate);
      if (!best || agreement.count > best_agreement.count ||
          (agreement.count == best_agreement.count && agreement.sum < best_agreement.sum)) {
        best = point;
        best_agreement = agreement;
      }
    }
  }
  return best;
}

}  // namespace

std::optional<Vector3d> MeanClosestPoint(const std::vector<PluckerRay<double>>& rays) {
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t j = 0; j < rays.size(); ++j) {
      if (i == j) continue;
      const std::optional<Vector3d> closest = ClosestPointOnRay<double>(rays[i], rays[j]);
      if (!closest) continue;
      sum += *closest;
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return Vector3d(sum / count);
}

std::vector<double> ReprojectionErrors(const std::vector<Camera>& cameras,
                                       const std::vector<Sighting>& sightings,
                                       const Vector3d& position) {
  std::vector<double> errors;
  for (const Sighting& s : sightings) {
    const Camera& camera = cameras[s.camera];
    errors.push_back(IsInFront(camera, position) ? (ProjectPoint(camera, position) - s.pixel).norm()
                                                 : std::numeric_limits<double>::infinity());
  }
  return errors;
}

std::optional<Triangulation> TriangulateRobustly(const std::vector<Camera>& cameras,
                                                 const std::vector<Sighting>& sightings,
                                                 const TriangulationOptions& options) {
  std::optional<Vector3d> position = BestPair(cameras, sightings, options);
  if (!position) return std::nullopt;
  Agreement agreement =
      FindAgreement(ReprojectionErrors(cameras, sightings, *position), options.gate);
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d refined = Refine(cameras, sightings, agreement, *position);
    Agreement next = FindAgreement(ReprojectionErrors(cameras, sightings, refined), options.gate);
    if (next.count < agreement.count) break;
    const bool same = next.agrees == agreement.agrees;
    position = refined;
    agreement = std::move(next);
    if (same) break;
  }
  if (agreement.count < options.min_sightings) return std::nullopt;
  Triangulation result;
  result.position = *position;
  result.agrees = agreement.agrees;
  result.num_agreeing = agreement.count;
  result.reprojection_rms = std::sqrt(agreement.sum / agreement.count);
  return result;
}

}  // namespace clothfit
