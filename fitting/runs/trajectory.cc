// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One simulation of a recording, as trajectory.npy, mesh.obj and residuals.csv.
#include <fmt/format.h>

#include "fitting/files/npy_file.h"
#include "fitting/residuals/cloud_residuals.h"
#include "fitting/runs/run_folder.h"
#include "tracking/camera/camera.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::string MeshAsObj(const ClothMesh& mesh, const Eigen::VectorXd& x) {
  std::string text = "# the cloth at frame 0, m; vt are its (u, v), m\n";
  for (int i = 0; i < mesh.num_particles(); ++i) {
    text += fmt::format("v {} {} {}\n", FormatNumber(x[3 * i]), FormatNumber(x[3 * i + 1]),
                        FormatNumber(x[3 * i + 2]));
  }
  for (const Eigen::Vector2d& uv : mesh.uv) {
    text += fmt::format("vt {} {}\n", FormatNumber(uv.x()), FormatNumber(uv.y()));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", a + 1, b + 1, c + 1);
  }
  return text;
}

Eigen::Vector2d ClothCoordinates(const ClothMesh& mesh, const SurfacePoint& point) {
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  for (size_t k = 0; k < 3; ++k) {
    uv += point.weights[k] * mesh.uv[static_cast<size_t>(point.nodes[k])];
  }
  return uv;
}

// Everything of a row but the residual.
std::string RowBegin(const Scene& scene, const char* kind, int frame, const std::string& camera,
                     int id, bool is_fitted, bool is_held_out, const SurfacePoint& point) {
  const Eigen::Vector2d uv = ClothCoordinates(scene.mesh, point);
  return fmt::format("{},{},{},{},{:d},{:d},{},{}", kind, frame, camera, id, is_fitted, is_held_out,
                     FormatNumber(uv.x()), FormatNumber(uv.y()));
}

std::string MarkerRow(const Scene& scene, const MarkerObservation& marker,
                      const Eigen::VectorXd* x) {
  const std::string begin = RowBegin(scene, "marker", marker.frame, "", marker.id,
                                     scene.is_fitted[static_cast<size_t>(marker.frame)],
                                     scene.IsHeldOut(marker.frame), marker.on_cloth);
  if (x == nullptr) return begin + ",,,,,\n";
  const Eigen::Vector3d d = marker.on_cloth.At(*x) - marker.position;
  return begin + fmt::format(",{},{},{},,\n", FormatNumber(d.x()), FormatNumber(d.y()),
                             FormatNumber(d.z()));
}

std::string TrackRow(const Scene& scene, const TrackObservation& track, const Eigen::VectorXd* x) {
  const Camera& camera = scene.recording.cameras[static_cast<size_t>(track.camera)];
  const bool is_held_out =
      scene.IsHeldOut(track.frame) || IsHeldOutCamera(scene.recording, track.camera);
  const std::string begin = RowBegin(scene, "track", track.frame, camera.name, track.id,
                                     scene.IsFitted(track), is_held_out, track.on_cloth);
  if (x == nullptr) return begin + ",,,,,\n";
  const Eigen::Vector3d point = track.on_cloth.At(*x);
  if (!IsInFront(camera, point)) return begin + ",,,,,\n";
  const Eigen::Vector2d d = ProjectPoint(camera, point) - track.pixel;
  return begin + fmt::format(",,,,{},{}\n", FormatNumber(d.x()), FormatNumber(d.y()));
}

// A row a point: from there to the closest of the surface, whose (u, v) it is.
std::string CloudRows(const Scene& scene, const CloudResiduals& to_surface,
                      const CloudObservation& cloud, const Eigen::VectorXd& x) {
  const bool is_held_out = scene.IsHeldOut(cloud.frame) ||
                           (cloud.camera && IsHeldOutCamera(scene.recording, *cloud.camera));
  const std::string camera =
      cloud.camera ? scene.recording.cameras[static_cast<size_t>(*cloud.camera)].name : "";
  const std::vector<PointResidual> distances = to_surface.OfPoints(cloud, x);
  std::string text;
  for (size_t i = 0; i < distances.size(); ++i) {
    const Eigen::Vector3d d = distances[i].point.At(x) - cloud.points[i];
    text +=
        RowBegin(scene, "cloud", cloud.frame, camera, static_cast<int>(i), scene.IsFitted(cloud),
                 is_held_out, distances[i].point) +
        fmt::format(",{},{},{},,\n", FormatNumber(d.x()), FormatNumber(d.y()), FormatNumber(d.z()));
  }
  return text;
}

// One row an observation: predicted minus observed, m for markers and clouds and px for tracks. A
// residual is empty where the simulation did not reach the frame, or the point lies behind the
// camera.
std::string ResidualsAsCsv(const Scene& scene, const std::vector<Eigen::VectorXd>& positions) {
  std::string text = "kind,frame,camera,id,fitted,held_out,u,v,dx,dy,dz,dx_px,dy_px\n";
  const auto at = [&](int frame) {
    return frame < static_cast<int>(positions.size()) ? &positions[static_cast<size_t>(frame)]
                                                      : nullptr;
  };
  for (const MarkerObservation& marker : scene.markers) {
    text += MarkerRow(scene, marker, at(marker.frame));
  }
  for (const TrackObservation& track : scene.tracks) {
    text += TrackRow(scene, track, at(track.frame));
  }
  const CloudResiduals to_surface(scene, 0.0);
  for (size_t i = 0; scene.clouds && i < scene.clouds->observations.size(); ++i) {
    const CloudObservation& cloud = scene.clouds->observations[i];
    if (const Eigen::VectorXd* const x = at(cloud.frame))
      text += CloudRows(scene, to_surface, cloud, *x);
  }
  return text;
}

}  // namespace

void RunFolder::WriteTrajectory(const Scene& scene,
                                const std::vector<Eigen::VectorXd>& positions) const {
  const Eigen::VectorXd& first = positions.empty() ? scene.initial : positions.front();
  WriteWholeFile(path_ / "mesh.obj", MeshAsObj(scene.mesh, first));
  WriteWholeFile(path_ / "trajectory.npy", PointsAsNpy(positions));
  WriteWholeFile(path_ / "residuals.csv", ResidualsAsCsv(scene, positions));
}

}  // namespace clothfit
