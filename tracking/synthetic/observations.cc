// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/observations.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/base/normal_numbers.h"
#include "tracking/synthetic/cameras.h"
#include "tracking/synthetic/room.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMicrometre = 1e-6;  // m
constexpr double kMillipixel = 1e-3;  // px

// To the nearest multiple, as the nearest double to its decimal.
template <class Vector>
Vector Rounded(const Vector& vector, double unit) {
  const double per_one = std::round(1.0 / unit);
  return vector.unaryExpr([per_one](double value) {
    return std::round(value * per_one) / per_one + 0.0;  // no minus zero
  });
}

// Points of a grid over the cloth: with both edges, or in the middle of equal fields.
std::vector<Vector2d> GridOnCloth(const Eigen::Vector2i& count, const Vector2d& size,
                                  bool with_edges) {
  const double offset = with_edges ? 0.0 : 0.5;
  std::vector<Vector2d> points;
  for (int j = 0; j < count.y(); ++j) {
    for (int i = 0; i < count.x(); ++i) {
      const Eigen::Array2d fields =
          (count.cast<double>().array() - (with_edges ? 1.0 : 0.0)).max(1.0);
      const Vector2d uv = ((Eigen::Array2d(i, j) + offset) / fields * size.array()).matrix();
      points.push_back(Rounded(uv, kMicrometre));
    }
  }
  return points;
}

std::vector<Camera> RoomCamerasFor(const SyntheticOptions& options,
                                   const std::vector<Eigen::VectorXd>& frames,
                                   const Recording& recording) {
  std::vector<Vector3d> region;
  double lowest = frames[0].z();
  for (const Eigen::VectorXd& x : frames) {
    for (Eigen::Index i = 0; i < x.size(); i += 3) {
      region.emplace_back(x.segment<3>(i));
      lowest = std::min(lowest, region.back().z());
    }
  }
  const double scale = RoomScale(options.size);
  RoomCameras room;
  room.count = options.num_cameras;
  room.size = options.pictures.size;
  room.distortion = options.pictures.distortion;
  for (double* const length : {&room.distance, &room.height, &room.ceiling}) *length *= scale;
  return MakeRoomCameras(room, region, FloorHeight(recording.ground_height, lowest, options.size));
}

// As far off as a layout that was measured by hand, on the cloth all the same.
std::vector<Vector2d> ToldPlaces(const SyntheticOptions& options, std::vector<Vector2d> uv) {
  if (options.layout_sigma == 0.0) return uv;
  NormalNumbers noise(options.seed, 3);
  for (Vector2d& place : uv) {
    const Vector2d told = place + options.layout_sigma * noise.NextVector<2>();
    place = told.cwiseMax(0.0).cwiseMin(options.size);
  }
  return uv;
}

}  // namespace

void AddCameras(const SyntheticOptions& options, const std::vector<Eigen::VectorXd>& frames,
                Recording* recording) {
  if (options.num_cameras < 1) return;
  if (options.images) {
    recording->cameras = RoomCamerasFor(options, frames, *recording);
    return;
  }
  Vector3d middle = Vector3d::Zero();
  for (Eigen::Index i = 0; i < frames[0].size(); i += 3) middle += frames[0].segment<3>(i);
  middle /= static_cast<double>(frames[0].size() / 3);
  if (recording->ground_height) middle.z() += 0.3 * options.size.maxCoeff();
  recording->cameras = MakeCameraRing(options.num_cameras, middle, 2.6 * options.size.maxCoeff());
}

Vector3d RoundedPosition(const Vector3d& position) { return Rounded(position, kMicrometre); }

void AddMarkers(const SyntheticOptions& options, const ClothMesh& mesh,
                const std::vector<Eigen::VectorXd>& frames, Recording* recording) {
  if (options.markers.minCoeff() < 1) return;
  if (options.marker_sigma > 0.0) recording->noise.marker = options.marker_sigma;
  const std::vector<Vector2d> uv = GridOnCloth(options.markers, options.size, false);
  const std::vector<SurfacePoint> points = LocateOnCloth(mesh, uv);
  const std::vector<Vector2d> told = ToldPlaces(options, uv);
  if (options.layout_sigma > 0.0) recording->noise.layout = options.layout_sigma;
  NormalNumbers noise(options.seed, 0);
  for (int f = 0; f < options.frame_count; ++f) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3d measured =
          points[i].At(frames[f]) + options.marker_sigma * noise.NextVector<3>();
      recording->markers.push_back(
          {f, static_cast<int>(i), told[i], Rounded(measured, kMicrometre)});
    }
  }
}

void AddTracks(const SyntheticOptions& options, const ClothMesh& mesh,
               const std::vector<Eigen::VectorXd>& frames, Recording* recording) {
  if (options.num_cameras < 1 || !options.tracks) return;
  if (options.track_sigma > 0.0) recording->noise.track = options.track_sigma;
  const Eigen::Vector2i count =
      options.markers.minCoeff() < 1 ? Eigen::Vector2i(5, 5) : options.markers;
  const std::vector<Vector2d> uv = GridOnCloth(count, options.size, false);
  const std::vector<SurfacePoint> points = LocateOnCloth(mesh, uv);
  NormalNumbers noise(options.seed, 1);
  for (int f = 0; f < options.frame_count; ++f) {
    for (int c = 0; c < options.num_cameras; ++c) {
      const Camera& camera = recording->cameras[c];
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d point = points[i].At(frames[f]);
        const Vector2d error = options.track_sigma * noise.NextVector<2>();
        if (!IsInFront(camera, point)) continue;
        const Vector2d pixel = Rounded(Vector2d(ProjectPoint(camera, point) + error), kMillipixel);
        if (IsInImage(camera, pixel)) {
          recording->tracks.push_back({f, c, static_cast<int>(i), uv[i], pixel});
        }
      }
    }
  }
}

std::vector<std::vector<Vector3d>> MakeClouds(const SyntheticOptions& options,
                                              const ClothMesh& mesh,
                                              const std::vector<Eigen::VectorXd>& frames,
                                              Recording* recording) {
  std::vector<std::vector<Vector3d>> clouds;
  if (options.cloud_points < 1) return clouds;
  if (options.cloud_sigma > 0.0) recording->noise.cloud = options.cloud_sigma;
  recording->noise.cloud_spacing = kMicrometre;  // their errors have nothing to do with each other
  NormalNumbers noise(options.seed, 2);
  constexpr std::size_t kSteps = std::size_t{1} << 20;
  for (const Eigen::VectorXd& x : frames) {
    std::vector<Vector3d>& cloud = clouds.emplace_back();
    for (int i = 0; i < options.cloud_points; ++i) {
      const std::size_t triangle = noise.Index(mesh.triangles.size());  // they are of one size
      double first = static_cast<double>(noise.Index(kSteps)) / kSteps;
      double second = static_cast<double>(noise.Index(kSteps)) / kSteps;
      if (first + second > 1.0) {
        first = 1.0 - first;
        second = 1.0 - second;
      }
      const SurfacePoint point{mesh.triangles[triangle], {1.0 - first - second, first, second}};
      cloud.push_back(point.At(x) + options.cloud_sigma * noise.NextVector<3>());
    }
  }
  return clouds;
}

std::vector<TruthPoint> TruthPoints(const SyntheticOptions& options, const ClothMesh& mesh,
                                    const std::vector<Eigen::VectorXd>& frames) {
  const std::vector<Vector2d> uv = GridOnCloth(options.truth_points, options.size, true);
  const std::vector<SurfacePoint> points = LocateOnCloth(mesh, uv);
  std::vector<TruthPoint> truth;
  for (int f = 0; f < options.frame_count; ++f) {
    for (std::size_t i = 0; i < points.size(); ++i)
      truth.push_back({f, uv[i], Rounded(points[i].At(frames[f]), kMicrometre)});
  }
  return truth;
}

}  // namespace clothfit
