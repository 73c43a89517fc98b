// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "autodiff_sim/contact/obstacle_body.h"
#include "autodiff_sim/term/tilted_down.h"
#include "autodiff_sim/terms/obstacle.h"
#include "autodiff_sim/terms/obstacle_contact.h"
#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

struct Surface {
  Eigen::VectorXd points;  // 3M, m, in the body's frame or the world
  std::vector<std::array<int, 3>> triangles;
  bool is_cut = false;
};

// What is within the radius (m) of the z axis from low to high (m): rings of vertices.
Surface RoundSurface(double radius, double low, double high) {
  constexpr int kHalf = 8, kRings = 2 * kHalf, kAround = 32;  // two rings where the ends part
  Surface surface;
  surface.points.resize(3 * kRings * kAround);
  for (int ring = 0; ring < kRings; ++ring) {
    const bool upper = ring >= kHalf;
    const double angle = M_PI_2 * (upper ? ring - kHalf : ring - kHalf + 1) / (kHalf - 1);
    for (int i = 0; i < kAround; ++i) {
      const double around = 2.0 * M_PI * i / kAround;
      surface.points.segment<3>(3 * (ring * kAround + i)) = Eigen::Vector3d(
          radius * std::cos(angle) * std::cos(around), radius * std::cos(angle) * std::sin(around),
          (upper ? high : low) + radius * std::sin(angle));
    }
  }
  for (int ring = 0; ring + 1 < kRings; ++ring) {
    for (int i = 0; i < kAround; ++i) {
      const int a = ring * kAround + i, b = ring * kAround + (i + 1) % kAround;
      surface.triangles.push_back({a, b, b + kAround});
      surface.triangles.push_back({a, b + kAround, a + kAround});
    }
  }
  return surface;
}

Surface SurfaceOf(const Obstacle& obstacle, double growth) {
  if (obstacle.IsMesh()) return {obstacle.points, obstacle.features.triangles, false};
  return RoundSurface(GrownRadius(obstacle.radius, growth), obstacle.points[2],
                      obstacle.points[obstacle.points.size() - 1]);
}

// A flat face from `origin` along two unit vectors, as far as a box reaches along them, but from no
// less than `least` along the second. It faces where their cross product points.
Surface FlatSurface(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin,
                    const Eigen::Vector3d& along_1, const Eigen::Vector3d& along_2,
                    double least = -HUGE_VAL) {
  constexpr int kSide = 13;          // vertices
  constexpr double kShortest = 0.1;  // m
  const auto reach = [&](const Eigen::Vector3d& along) {
    const double middle = along.dot(box.center() - origin);
    const double half = 0.5 * along.cwiseAbs().dot(box.sizes());
    return Eigen::Vector2d(middle - half, middle + half);
  };
  const Eigen::Vector2d of_1 = reach(along_1);
  Eigen::Vector2d of_2 = reach(along_2).cwiseMax(least);
  of_2[1] = std::max(of_2[1], of_2[0] + kShortest);
  Surface surface;
  surface.is_cut = true;
  surface.points.resize(3 * kSide * kSide);
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const int a = j * kSide + i;
      const double s = static_cast<double>(i) / (kSide - 1),
                   t = static_cast<double>(j) / (kSide - 1);
      surface.points.segment<3>(3 * a) = origin + (of_1[0] + s * (of_1[1] - of_1[0])) * along_1 +
                                         (of_2[0] + t * (of_2[1] - of_2[0])) * along_2;
      if (i + 1 == kSide || j + 1 == kSide) continue;
      surface.triangles.push_back({a, a + 1, a + 1 + kSide});
      surface.triangles.push_back({a, a + 1 + kSide, a + kSide});
    }
  }
  return surface;
}

Surface Joined(Surface first, const Surface& second) {
  const auto before = static_cast<int>(first.points.size() / 3);
  Eigen::VectorXd points(first.points.size() + second.points.size());
  points << first.points, second.points;
  first.points = std::move(points);
  for (const std::array<int, 3>& t : second.triangles)
    first.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  return first;
}

// The terms' own parameters in their order; see terms/obstacle.h for what they mean.
using Values = Eigen::VectorXd;

Surface PlaneSurface(const Values& p, const Eigen::Vector3d& gravity,
                     const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d down = TiltedDown<double>(MakeDownFrame(gravity), p[2], p[3]);
  const Eigen::Vector3d along = down.unitOrthogonal();
  return FlatSurface(box, -p[1] * down, along, along.cross(down));
}

Surface TableSurface(const Values& p, const Eigen::Vector3d& gravity,
                     const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d first = p.segment<3>(1);
  const Eigen::Vector3d edge = (Eigen::Vector3d(p.segment<3>(4)) - first).normalized();
  const Eigen::Vector3d over = edge.cross(-MakeDownFrame(gravity).down).normalized();
  const Eigen::Vector3d top = over.cross(edge);
  return Joined(FlatSurface(box, first, edge, -over, 0.0),
                FlatSurface(box, first, -edge, -top, 0.0));
}

Surface SphereSurface(const Values& p, const Eigen::Vector3d& /*gravity*/,
                      const Eigen::AlignedBox3d& /*box*/) {
  Surface surface = RoundSurface(p[4], 0.0, 0.0);
  Eigen::Map<Eigen::Matrix3Xd>(surface.points.data(), 3, surface.points.size() / 3).colwise() +=
      Eigen::Vector3d(p.segment<3>(1));
  return surface;
}

Surface CapsuleSurface(const Values& p, const Eigen::Vector3d& /*gravity*/,
                       const Eigen::AlignedBox3d& /*box*/) {
  const Eigen::Vector3d end = p.segment<3>(1), axis = Eigen::Vector3d(p.segment<3>(4)) - end;
  Surface surface = RoundSurface(p[7], 0.0, axis.norm());
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
  Eigen::Map<Eigen::Matrix3Xd> points(surface.points.data(), 3, surface.points.size() / 3);
  points = (turn * points).colwise() + end;
  return surface;
}

ObstacleSurface Named(std::string name, std::vector<Eigen::VectorXd> positions,
                      const Surface& surface) {
  ObstacleSurface named{std::move(name), std::move(positions), {}, surface.is_cut};
  for (const std::array<int, 3>& triangle : surface.triangles)
    named.triangles.insert(named.triangles.end(), triangle.begin(), triangle.end());
  return named;
}

template <class Term>
void AddUnseen(const Scene& scene, const Eigen::VectorXd& values, const Eigen::AlignedBox3d& box,
               Surface (*surface_of)(const Values&, const Eigen::Vector3d&,
                                     const Eigen::AlignedBox3d&),
               std::vector<ObstacleSurface>* surfaces) {
  const Values own = values.segment(FindParameter(MakeParameterTable(), FullName<Term>()),
                                    static_cast<Eigen::Index>(Term::kParameters.size()));
  if (!(own[0] > 0.0)) return;  // the stiffness
  const Surface surface = surface_of(own, scene.world.gravity, box);
  surfaces->push_back(Named(Term::kTitle, {surface.points}, surface));
}

}  // namespace

std::vector<ObstacleSurface> ObstacleSurfaces(const Scene& scene, const Eigen::VectorXd& values,
                                              const std::vector<Eigen::VectorXd>& cloth) {
  const ObstacleChange change = ObstacleBarrier::Change(
      values, FindParameter(MakeParameterTable(), FullName<ObstacleBarrier>()));
  std::vector<ObstacleSurface> surfaces;
  for (const auto& obstacle : scene.world.obstacles) {
    const Surface surface = SurfaceOf(*obstacle, change.growth);
    std::vector<Eigen::VectorXd> positions;
    for (int frame = 0; frame < scene.recording.frame_count; ++frame) {
      RigidPose pose = obstacle->PoseAt(scene.FrameTime(frame));
      pose.origin_in_world += change.shift;
      positions.push_back(PlaceInWorld(pose, surface.points));
    }
    surfaces.push_back(Named(obstacle->name, std::move(positions), surface));
  }
  Eigen::AlignedBox3d box;
  for (const Eigen::VectorXd& x : cloth)
    for (Eigen::Index i = 0; i < x.size(); i += 3) box.extend(Eigen::Vector3d(x.segment<3>(i)));
  if (box.isEmpty()) return surfaces;
  constexpr double kAround = 0.05;  // m, of the cloth
  box.min().array() -= kAround;
  box.max().array() += kAround;
  AddUnseen<ObstaclePlane>(scene, values, box, PlaneSurface, &surfaces);
  AddUnseen<ObstacleTable>(scene, values, box, TableSurface, &surfaces);
  AddUnseen<ObstacleSphere>(scene, values, box, SphereSurface, &surfaces);
  AddUnseen<ObstacleCapsule>(scene, values, box, CapsuleSurface, &surfaces);
  return surfaces;
}

}  // namespace clothfit
