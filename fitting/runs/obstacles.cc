// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/obstacles.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "autodiff_sim/contact/obstacle_body.h"
#include "autodiff_sim/terms/obstacle_contact.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/files/npy_file.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

struct Surface {
  Eigen::VectorXd points;  // 3M, m, in the body's frame
  std::vector<std::array<int, 3>> triangles;
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
  if (obstacle.IsMesh()) return {obstacle.points, obstacle.features.triangles};
  return RoundSurface(GrownRadius(obstacle.radius, growth), obstacle.points[2],
                      obstacle.points[obstacle.points.size() - 1]);
}

}  // namespace

std::vector<ObstacleSurface> ObstacleSurfaces(const Scene& scene, const Eigen::VectorXd& values) {
  ObstacleChange change;
  if (values.size() > 0) {
    change = ObstacleBarrier::Change(
        values, FindParameter(MakeParameterTable(), FullName<ObstacleBarrier>()));
  }
  std::vector<ObstacleSurface> surfaces;
  for (const auto& obstacle : scene.world.obstacles) {
    const Surface surface = SurfaceOf(*obstacle, change.growth);
    ObstacleSurface moving{obstacle->name, {}, {}};
    for (int frame = 0; frame < scene.recording.frame_count; ++frame) {
      RigidPose pose = obstacle->PoseAt(scene.FrameTime(frame));
      pose.origin_in_world += change.shift;
      moving.positions.push_back(PlaceInWorld(pose, surface.points));
    }
    for (const std::array<int, 3>& triangle : surface.triangles)
      moving.triangles.insert(moving.triangles.end(), triangle.begin(), triangle.end());
    surfaces.push_back(std::move(moving));
  }
  return surfaces;
}

void WriteObstacles(const Scene& scene, const Eigen::VectorXd& values, const RunFolder& run) {
  const std::vector<ObstacleSurface> surfaces = ObstacleSurfaces(scene, values);
  if (surfaces.empty()) return;
  std::vector<std::string> files = {"report/obstacles.json"};
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    files.push_back(fmt::format("report/obstacle_{}.npy", i));
  run.Add(files);
  std::string json;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ObstacleSurface& surface = surfaces[i];
    const std::string file = fmt::format("obstacle_{}.npy", i);
    WriteWholeFile(run.path() / "report" / file, PointsAsNpy(surface.positions));
    std::string triangles, name;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
      triangles += fmt::format("{}[{},{},{}]", t == 0 ? "" : ",", surface.triangles[t],
                               surface.triangles[t + 1], surface.triangles[t + 2]);
    }
    // A name has no control characters and no backslash.
    for (const char c : surface.name) name += c == '"' ? std::string("\\\"") : std::string(1, c);
    json += fmt::format(R"({}{{"name":"{}","positions":"{}","triangles":[{}]}})",
                        json.empty() ? "" : ",\n", name, file, triangles);
  }
  WriteWholeFile(run.path() / "report" / "obstacles.json", "{\"obstacles\":[" + json + "]}\n");
}

}  // namespace clothfit
