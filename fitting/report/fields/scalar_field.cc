// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/fields/scalar_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "fitting/report/fields/spread_values.h"
#include "tracking/camera/plucker_ray.h"

namespace clothfit {
namespace {

// Calls add(frame, point on the cloth, distance in m) for each marker.
template <class Add>
void ForMarkers(const Scene& scene, const Motion& motion, const Add& add) {
  for (const MarkerObservation& marker : scene.markers) {
    const auto frame = static_cast<std::size_t>(marker.frame);
    if (frame >= motion.positions.size()) continue;
    add(frame, marker.on_cloth,
        (marker.on_cloth.At(motion.positions[frame]) - marker.position).norm());
  }
}

template <class Add>
void ForTracks(const Scene& scene, const Motion& motion, const Add& add) {
  for (const TrackObservation& track : scene.tracks) {
    const auto frame = static_cast<std::size_t>(track.frame);
    if (frame >= motion.positions.size()) continue;
    const Camera& camera = scene.recording.cameras[track.camera];
    const std::optional<Eigen::Vector3d> ray = PixelDirection(camera, track.pixel);
    if (!ray) continue;
    const Eigen::Vector3d from_camera =
        track.on_cloth.At(motion.positions[frame]) - CameraCentre(camera);
    add(frame, track.on_cloth, from_camera.cross(*ray).norm());
  }
}

// Largest singular value of a triangle's deformation gradient (3 x 2), minus 1.
double Strain(const ClothMesh& mesh, const std::array<int, 3>& nodes, const Eigen::VectorXd& x) {
  Eigen::Matrix2d rest;
  Eigen::Matrix<double, 3, 2> now;
  for (int k = 0; k < 2; ++k) {
    rest.col(k) = mesh.uv[nodes[k + 1]] - mesh.uv[nodes[0]];
    now.col(k) = x.segment<3>(3 * nodes[k + 1]) - x.segment<3>(3 * nodes[0]);
  }
  const Eigen::Matrix<double, 3, 2> gradient = now * rest.inverse();
  const Eigen::Matrix2d c = gradient.transpose() * gradient;
  const double mean = 0.5 * c.trace();
  return std::sqrt(mean + std::sqrt(std::max(0.0, mean * mean - c.determinant()))) - 1.0;
}

Eigen::VectorXd StrainOfParticles(const ClothMesh& mesh, const std::vector<RestTriangle>& triangles,
                                  const Eigen::VectorXd& x) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.num_particles()), area = sum;
  for (const RestTriangle& triangle : triangles) {
    const double strain = Strain(mesh, triangle.nodes, x);
    for (const int node : triangle.nodes) {
      sum[node] += triangle.area * strain;
      area[node] += triangle.area;
    }
  }
  return sum.cwiseQuotient(area);
}

}  // namespace

std::vector<ScalarField> ResidualField(const ReportScene& report) {
  const Scene& scene = report.scene();
  if (scene.markers.empty() && scene.tracks.empty()) return {};
  ScalarField field{"residual", "Distance from what was seen", "m", false, {}};
  for (const Motion& motion : report.motions) {
    SpreadValues spread(scene.mesh, motion.positions.size());
    const auto add = [&](std::size_t frame, const SurfacePoint& point, double distance) {
      spread.Add(frame, point, distance);
    };
    ForMarkers(scene, motion, add);
    ForTracks(scene, motion, add);
    field.values[motion.name] = spread.Values();
  }
  return {field};
}

ScalarField StrainField(const ReportScene& report) {
  const ClothMesh& mesh = report.scene().mesh;
  const std::vector<RestTriangle> triangles = RestTriangles(mesh);
  ScalarField field{"strain", "Largest strain", "1", true, {}};
  for (const Motion& motion : report.motions) {
    std::vector<Eigen::VectorXd>& frames = field.values[motion.name];
    for (const Eigen::VectorXd& x : motion.positions) {
      frames.push_back(StrainOfParticles(mesh, triangles, x));
    }
  }
  return field;
}

ScalarField SpeedField(const ReportScene& report) {
  const double rate = report.scene().recording.frame_rate;
  ScalarField field{"speed", "Speed", "m/s", false, {}};
  for (const Motion& motion : report.motions) {
    const std::size_t count = motion.positions.size();
    for (std::size_t f = 0; f < count; ++f) {
      const std::size_t before = f > 0 ? f - 1 : 0, after = std::min(f + 1, count - 1);
      const double time = static_cast<double>(std::max<std::size_t>(1, after - before)) / rate;
      const Eigen::VectorXd v = (motion.positions[after] - motion.positions[before]) / time;
      field.values[motion.name].push_back(
          Eigen::Map<const Eigen::Matrix3Xd>(v.data(), 3, v.size() / 3).colwise().norm());
    }
  }
  return field;
}

std::vector<ScalarField> TruthField(const ReportScene& report) {
  if (report.truth.empty()) return {};
  std::vector<Eigen::Vector2d> uv;
  for (const TruthPoint& point : report.truth) uv.push_back(point.uv);
  const std::vector<SurfacePoint> on_cloth = LocateOnCloth(report.scene().mesh, uv);
  ScalarField field{"truth", "Distance from the truth", "m", false, {}};
  for (const Motion& motion : report.motions) {
    SpreadValues spread(report.scene().mesh, motion.positions.size());
    for (std::size_t i = 0; i < on_cloth.size(); ++i) {
      const auto frame = static_cast<std::size_t>(report.truth[i].frame);
      if (frame >= motion.positions.size()) continue;
      spread.Add(frame, on_cloth[i],
                 (on_cloth[i].At(motion.positions[frame]) - report.truth[i].position).norm());
    }
    field.values[motion.name] = spread.Values();
  }
  return {field};
}

std::vector<ScalarField> CommonFields(const ReportScene& report) {
  std::vector<ScalarField> fields = ResidualField(report);
  for (ScalarField& field : OutlineField(report)) fields.push_back(std::move(field));
  for (ScalarField& field : TruthField(report)) fields.push_back(std::move(field));
  fields.push_back(StrainField(report));
  fields.push_back(SpeedField(report));
  return fields;
}

}  // namespace clothfit
