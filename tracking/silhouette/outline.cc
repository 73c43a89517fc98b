// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

constexpr double kLeastDepth = 1e-6;  // m

// Twice the signed area of a triangle in the picture; its sign says which side of it is seen.
double Facing(const Eigen::Matrix3Xd& in_camera, const std::array<int, 3>& nodes) {
  return in_camera.col(nodes[0]).cross(in_camera.col(nodes[1])).dot(in_camera.col(nodes[2]));
}

// Which edges can be outline: rims, and those whose triangles turn different sides to the camera.
bool CanBeOutline(const MeshEdge& edge, const std::vector<double>& facing) {
  if (edge.triangles[1] < 0) return true;
  return (facing[edge.triangles[0]] > 0.0) != (facing[edge.triangles[1]] > 0.0);
}

// Adds the pieces of one edge whose outward side is free.
void AddPieces(const Camera& camera, const MeshEdge& edge, const Eigen::Matrix3Xd& in_camera,
               const BitMask& covered, double longest, std::vector<OutlinePiece>* outline) {
  const Eigen::Vector3d a = in_camera.col(edge.nodes[0]), b = in_camera.col(edge.nodes[1]);
  const Eigen::Vector3d inside = in_camera.col(edge.opposite[0]);
  if (!(a.z() > kLeastDepth && b.z() > kLeastDepth && inside.z() > kLeastDepth)) return;
  const auto project = [&](const Eigen::Vector3d& p) {
    return ProjectCameraPoint<double>(camera, p);
  };
  const double length = (project(b) - project(a)).norm();
  if (!(length < 1e5)) return;
  const int parts = std::max(1, static_cast<int>(std::ceil(length / longest)));
  const Eigen::Vector2d inner = project(inside);
  OutlinePiece piece;
  piece.nodes = edge.nodes;
  for (int i = 0; i < parts; ++i) {
    for (int end = 0; end < 2; ++end) {
      piece.shares[end] = static_cast<double>(i + end) / parts;
      const Eigen::Vector3d point = a + piece.shares[end] * (b - a);
      piece.pixels[end] = project(point);
      piece.depths[end] = point.z();
    }
    const Eigen::Vector2d along = piece.pixels[1] - piece.pixels[0];
    if (along.norm() < 1e-9) continue;
    piece.outward = Eigen::Vector2d(along.y(), -along.x()).normalized();
    if (piece.outward.dot(inner - piece.pixels[0]) > 0.0) piece.outward = -piece.outward;
    // A pixel further out than half its diagonal: the edge's own triangles do not reach it.
    const Eigen::Vector2d beyond = 0.5 * (piece.pixels[0] + piece.pixels[1]) + piece.outward;
    if (!covered.AtPoint(beyond.x(), beyond.y())) outline->push_back(piece);
  }
}

}  // namespace

std::vector<MeshEdge> FindEdges(const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::pair<int, int>, MeshEdge> edges;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      const auto [place, is_new] = edges.try_emplace(
          std::minmax(a, b), MeshEdge{{std::min(a, b), std::max(a, b)}, {-1, -1}, {-1, -1}});
      const int side = is_new ? 0 : 1;
      place->second.opposite[side] = triangles[t][(k + 2) % 3];
      place->second.triangles[side] = t;
    }
  }
  std::vector<MeshEdge> result;
  result.reserve(edges.size());
  for (const auto& [nodes, edge] : edges) result.push_back(edge);
  return result;
}

std::vector<OutlinePiece> FindOutline(const Camera& camera, const std::vector<MeshEdge>& edges,
                                      const std::vector<std::array<int, 3>>& triangles,
                                      const Eigen::VectorXd& x, const BitMask& covered,
                                      double longest) {
  const Eigen::Map<const Eigen::Matrix3Xd> world(x.data(), 3, x.size() / 3);
  const Eigen::Matrix3Xd in_camera =
      (camera.camera_from_world_rotation * world).colwise() + camera.camera_from_world_translation;
  std::vector<double> facing(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) facing[t] = Facing(in_camera, triangles[t]);
  std::vector<OutlinePiece> outline;
  for (const MeshEdge& edge : edges) {
    if (CanBeOutline(edge, facing)) AddPieces(camera, edge, in_camera, covered, longest, &outline);
  }
  return outline;
}

std::optional<OutlinePoint> NearestOnOutline(const std::vector<OutlinePiece>& outline,
                                             const Eigen::Vector2d& pixel) {
  double nearest2 = std::numeric_limits<double>::infinity();
  double most_normal = 0.0;
  const OutlinePiece* best = nullptr;
  double best_share = 0.0;
  for (const OutlinePiece& piece : outline) {
    const Eigen::Vector2d along = piece.pixels[1] - piece.pixels[0];
    const Eigen::Vector2d from = pixel - piece.pixels[0];
    const double share = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance2 = (from - share * along).squaredNorm();
    constexpr double kSame = 1e-9;  // px^2: at a corner the piece that says more about the side
    if (distance2 > nearest2 + kSame) continue;
    const double normal = (from - share * along).dot(piece.outward);
    if (distance2 > nearest2 - kSame && std::abs(normal) <= std::abs(most_normal)) continue;
    nearest2 = std::min(nearest2, distance2);
    most_normal = normal;
    best = &piece;
    best_share = share;
  }
  if (best == nullptr) return std::nullopt;
  // What is linear in the picture is not on the edge: the nearer end's half is the longer.
  const double weight = (1.0 - best_share) * best->depths[1] + best_share * best->depths[0];
  const double share3d = best_share * best->depths[0] / weight;
  OutlinePoint point;
  point.nodes = best->nodes;
  point.share = best->shares[0] + share3d * (best->shares[1] - best->shares[0]);
  point.distance = std::copysign(std::sqrt(nearest2), most_normal);
  point.side = best->outward;
  return point;
}

}  // namespace clothfit
