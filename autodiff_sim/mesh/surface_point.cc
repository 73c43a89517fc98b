// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Locating (u, v) in the mesh.
#include "autodiff_sim/mesh/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/LU>

namespace clothfit {
namespace {

Eigen::Vector3d Barycentric(const ClothMesh& mesh, const std::array<int, 3>& t,
                            const Eigen::Vector2d& uv) {
  Eigen::Matrix2d sides;
  sides.col(0) = mesh.uv[t[1]] - mesh.uv[t[0]];
  sides.col(1) = mesh.uv[t[2]] - mesh.uv[t[0]];
  const Eigen::Vector2d b = sides.inverse() * (uv - mesh.uv[t[0]]);
  return {1.0 - b.x() - b.y(), b.x(), b.y()};
}

// How far (m) the point with these weights lies outside the triangle, 0 inside.
double DistanceOutside(const ClothMesh& mesh, const std::array<int, 3>& t, const Eigen::Vector3d& b,
                       const Eigen::Vector2d& uv) {
  if (b.minCoeff() >= 0.0) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d a = mesh.uv[t[k]], side = mesh.uv[t[(k + 1) % 3]] - a;
    const double s = std::clamp((uv - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (uv - a - s * side).norm());
  }
  return nearest;
}

SurfacePoint Locate(const ClothMesh& mesh, const Eigen::Vector2d& uv) {
  double best = std::numeric_limits<double>::infinity();
  SurfacePoint point;
  for (const std::array<int, 3>& t : mesh.triangles) {
    Eigen::Vector3d b = Barycentric(mesh, t, uv);
    constexpr double kRound = 1e-9;
    for (double& w : b) {
      if (std::abs(w) < kRound) w = 0.0;
      if (std::abs(w - 1.0) < kRound) w = 1.0;
    }
    const double outside = DistanceOutside(mesh, t, b, uv);
    if (outside < best) {
      best = outside;
      point.nodes = t;
      point.weights = {b[0], b[1], b[2]};
    }
    if (best == 0.0) break;
  }
  return point;
}

}  // namespace

std::vector<SurfacePoint> LocateOnCloth(const ClothMesh& mesh,
                                        const std::vector<Eigen::Vector2d>& uv) {
  std::vector<SurfacePoint> points;
  points.reserve(uv.size());
  std::map<std::pair<double, double>, std::size_t> known;  // a marker is seen in many frames
  for (const Eigen::Vector2d& p : uv) {
    const auto [first, is_new] = known.try_emplace({p.x(), p.y()}, points.size());
    points.push_back(is_new ? Locate(mesh, p) : points[first->second]);
  }
  return points;
}

}  // namespace clothfit
