// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/validation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/LU>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr int kMaxFrameCount = 10'000'000;  // more is a slip of the keyboard
constexpr double kOnClothSlack = 1e-6;      // m; decimals in the file are rounded

std::string YamlPlace(const Recording& recording, const std::string& key) {
  return PlaceInRecording(recording, "recording.yaml", key);
}

void CheckFinite(const Eigen::Vector3d& vector, const std::string& place) {
  if (!vector.allFinite()) throw InputError(place, "expected finite numbers");
}

void CheckPlacement(const Recording& recording, const FlatPlacement& flat) {
  constexpr double kTolerance =
      1e-3;  // a millimetre a metre; more would stretch or shear the cloth
  CheckFinite(flat.origin, YamlPlace(recording, "cloth.initial.origin"));
  const auto check_unit = [&](const Eigen::Vector3d& axis, const std::string& key) {
    if (std::abs(axis.norm() - 1.0) <= kTolerance) return;
    throw InputError(YamlPlace(recording, key),
                     fmt::format("expected unit length, found {}", axis.norm()));
  };
  check_unit(flat.u_axis, "cloth.initial.u_axis");
  check_unit(flat.v_axis, "cloth.initial.v_axis");
  const double cosine = flat.u_axis.dot(flat.v_axis);
  if (std::abs(cosine) <= kTolerance) return;
  throw InputError(
      YamlPlace(recording, "cloth.initial.v_axis"),
      fmt::format("expected a direction perpendicular to u_axis, found u_axis . v_axis = {}",
                  cosine));
}

void CheckPlacement(const Recording& recording, const PointPlacement& placement) {
  const std::string place = YamlPlace(recording, "cloth.initial.points");
  const std::vector<PlacedPoint>& points = placement.points;
  constexpr size_t kMaxPoints = 3000;  // a dense system is solved to interpolate them: seconds
  if (points.size() < 3 || points.size() > kMaxPoints) {
    throw InputError(place,
                     fmt::format("expected 3..{} points, found {}", kMaxPoints, points.size()));
  }
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::set<std::pair<double, double>> seen;
  for (size_t i = 0; i < points.size(); ++i) {
    const PlacedPoint& point = points[i];
    const std::string point_place = fmt::format("{}: point {}", place, i + 1);
    CheckOnCloth(recording, point.uv, point_place);
    CheckFinite(point.position, point_place);
    if (!seen.emplace(point.uv.x(), point.uv.y()).second) {
      throw InputError(point_place,
                       fmt::format("(u, v) = ({}, {}) appears twice", point.uv.x(), point.uv.y()));
    }
    mean += point.uv / double(points.size());
  }
  // On one line the covariance has no determinant: the product of its two variances is zero.
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const PlacedPoint& point : points) {
    const Eigen::Vector2d centred = point.uv - mean;
    covariance += centred * centred.transpose();
  }
  constexpr double kCollinear = 1e-3;  // standard deviation across, of that along
  if (!(covariance.determinant() > std::pow(kCollinear * covariance.trace(), 2))) {
    throw InputError(place, "the points lie on one line in (u, v); expected some on either side");
  }
}

void CheckPlacement(const Recording& recording, const MeshPlacement& mesh) {
  if (std::filesystem::is_regular_file(mesh.file)) return;
  throw InputError(YamlPlace(recording, "cloth.mesh"),
                   fmt::format("no such file: {}", mesh.file.string()));
}

// Names become file names and fields of CSV.
void CheckName(const std::string& name, std::set<std::string>* seen, const std::string& place) {
  const bool usable = !name.empty() && name.front() != '.' && TrimBlanks(name) == name &&
                      std::none_of(name.begin(), name.end(), [](unsigned char c) {
                        return std::iscntrl(c) != 0 || c == '/' || c == '\\' || c == ',';
                      });
  if (!usable) {
    throw InputError(place, fmt::format("'{}' cannot name a file; expected a name without slashes "
                                        "or commas that does not start with a dot",
                                        name));
  }
  if (!seen->insert(name).second) throw InputError(place, "'" + name + "' appears twice");
}

void CheckRotation(const Eigen::Matrix3d& rotation, const std::string& place) {
  constexpr double kTolerance = 1e-4;
  const Eigen::Matrix3d deviation = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  const double off = deviation.cwiseAbs().maxCoeff();
  if (!(off <= kTolerance)) {
    throw InputError(
        place, fmt::format("expected a rotation, found R R^T off the identity by {:.2g}", off));
  }
  if (rotation.determinant() < 0.0) {
    throw InputError(place, "expected a rotation, found a reflection (determinant -1)");
  }
}

}  // namespace

std::string PlaceInRecording(const Recording& recording, const std::string& file,
                             const std::string& key) {
  return (recording.path / file).string() + ": " + key;
}

void CheckOnCloth(const Recording& recording, const Eigen::Vector2d& uv, const std::string& place) {
  for (int i = 0; i < 2; ++i) {
    const double size = recording.cloth.size[i];
    if (uv[i] >= -kOnClothSlack && uv[i] <= size + kOnClothSlack) continue;
    throw InputError(
        place, fmt::format("{} = {} is outside the cloth, 0..{}", i == 0 ? "u" : "v", uv[i], size));
  }
}

void CheckFrame(const Recording& recording, int frame, const std::string& place) {
  if (frame >= 0 && frame < recording.frame_count) return;
  throw InputError(place,
                   fmt::format("frame {} is outside 0..{}", frame, recording.frame_count - 1));
}

void CheckPositive(double value, const std::string& place) {
  if (std::isfinite(value) && value > 0.0) return;
  throw InputError(place, fmt::format("expected a number above 0, found {}", value));
}

void CheckScene(const Recording& recording) {
  CheckPositive(recording.frame_rate, YamlPlace(recording, "frame_rate"));
  if (recording.frame_count < 1 || recording.frame_count > kMaxFrameCount) {
    throw InputError(
        YamlPlace(recording, "frame_count"),
        fmt::format("expected 1..{}, found {}", kMaxFrameCount, recording.frame_count));
  }
  CheckFinite(recording.gravity, YamlPlace(recording, "gravity"));
  if (recording.ground_height && !std::isfinite(*recording.ground_height)) {
    throw InputError(YamlPlace(recording, "ground.height"), "expected a finite number");
  }
}

void CheckCloth(const Recording& recording) {
  const ClothDescription& cloth = recording.cloth;
  CheckPositive(cloth.size.x(), YamlPlace(recording, "cloth.size[0]"));
  CheckPositive(cloth.size.y(), YamlPlace(recording, "cloth.size[1]"));
  if (cloth.resolution.minCoeff() < 2) {
    throw InputError(YamlPlace(recording, "cloth.resolution"),
                     fmt::format("expected at least 2 particles each way, found [{}, {}]",
                                 cloth.resolution.x(), cloth.resolution.y()));
  }
  if (cloth.areal_density) {
    CheckPositive(*cloth.areal_density, YamlPlace(recording, "cloth.areal_density"));
  }
  std::visit([&](const auto& placement) { CheckPlacement(recording, placement); }, cloth.initial);
}

void CheckHandles(const Recording& recording) {
  std::set<std::string> names;
  for (size_t i = 0; i < recording.handles.size(); ++i) {
    const HandleDescription& handle = recording.handles[i];
    const std::string place = YamlPlace(recording, fmt::format("handles[{}]", i));
    CheckName(handle.name, &names, place + ".name");
    CheckOnCloth(recording, handle.uv, place + ".uv");
    if (handle.path_sigma) CheckPositive(*handle.path_sigma, place + ".path_sigma");
    if (handle.released_after) {
      CheckFrame(recording, *handle.released_after, place + ".released_after");
    }
    if (!handle.path) continue;
    if (handle.path->size() != static_cast<size_t>(recording.frame_count)) {
      throw InputError(place + ".path", fmt::format("expected {} frames, found {}",
                                                    recording.frame_count, handle.path->size()));
    }
    bool any_known = false;
    for (const std::optional<Eigen::Vector3d>& position : *handle.path) {
      if (position) CheckFinite(*position, place + ".path");
      any_known = any_known || position.has_value();
    }
    if (!any_known) throw InputError(place + ".path", "expected at least one position");
  }
}

void CheckObstacles(const Recording& recording) {
  std::set<std::string> names;
  for (size_t i = 0; i < recording.obstacles.size(); ++i) {
    const ObstacleDescription& obstacle = recording.obstacles[i];
    const std::string place = YamlPlace(recording, fmt::format("obstacles[{}]", i));
    CheckName(obstacle.name, &names, place + ".name");
    if (const auto* ball = std::get_if<BallShape>(&obstacle.shape)) {
      CheckPositive(ball->radius, place + ".sphere.radius");
    } else if (const auto* bar = std::get_if<BarShape>(&obstacle.shape)) {
      CheckPositive(bar->radius, place + ".capsule.radius");
      CheckPositive(bar->length, place + ".capsule.length");
    } else if (const auto* box = std::get_if<BoxShape>(&obstacle.shape)) {
      for (int k = 0; k < 3; ++k)
        CheckPositive(box->size[k], place + fmt::format(".box.size[{}]", k));
    } else if (const auto& file = std::get<MeshShape>(obstacle.shape).file;
               !std::filesystem::is_regular_file(file)) {
      throw InputError(place + ".mesh", fmt::format("no such file: {}", file.string()));
    }
    const size_t frames = obstacle.path.size();
    if (frames != 1 && frames != static_cast<size_t>(recording.frame_count)) {
      throw InputError(place + ".path",
                       fmt::format("expected {} frames, found {}", recording.frame_count, frames));
    }
    for (const ObstacleDescription::Pose& pose : obstacle.path) {
      CheckFinite(pose.position, place + (frames == 1 ? ".position" : ".path"));
      CheckFinite(pose.rotation, place + (frames == 1 ? ".rotation" : ".path"));
    }
  }
}

void CheckNoiseAndSplits(const Recording& recording) {
  const NoiseSigmas& noise = recording.noise;
  if (noise.marker) CheckPositive(*noise.marker, YamlPlace(recording, "noise.marker"));
  if (noise.track) CheckPositive(*noise.track, YamlPlace(recording, "noise.track"));
  if (noise.silhouette) CheckPositive(*noise.silhouette, YamlPlace(recording, "noise.silhouette"));
  if (const std::optional<Splits::FrameRange>& range = recording.splits.held_out_frames) {
    const std::string place = YamlPlace(recording, "splits.held_out_frames");
    CheckFrame(recording, range->first, place);
    CheckFrame(recording, range->last, place);
    if (range->first > range->last) {
      throw InputError(
          place, fmt::format("expected [first, last], found [{}, {}]", range->first, range->last));
    }
  }
  std::vector<std::string> names;
  for (const Camera& camera : recording.cameras) names.push_back(camera.name);
  for (const std::string& name : recording.splits.held_out_cameras) {
    if (FindCamera(recording, name)) continue;
    throw InputError(YamlPlace(recording, "splits.held_out_cameras"),
                     "'" + name + "' is no camera of cameras.yaml; " + Suggestion(name, names));
  }
}

void CheckCameras(const Recording& recording) {
  std::set<std::string> names;
  for (size_t i = 0; i < recording.cameras.size(); ++i) {
    const Camera& camera = recording.cameras[i];
    const std::string place =
        PlaceInRecording(recording, "cameras.yaml", fmt::format("cameras[{}]", i));
    CheckName(camera.name, &names, place + ".name");
    if (camera.width < 1 || camera.height < 1) {
      throw InputError(place + ".size",
                       fmt::format("expected at least 1 px each way, found [{}, {}]", camera.width,
                                   camera.height));
    }
    CheckPositive(camera.fx, place + ".K: fx");
    CheckPositive(camera.fy, place + ".K: fy");
    const bool finite = std::isfinite(camera.cx) && std::isfinite(camera.cy) &&
                        std::all_of(camera.distortion.begin(), camera.distortion.end(),
                                    [](double value) { return std::isfinite(value); });
    if (!finite) throw InputError(place, "expected finite numbers in K and distortion");
    CheckRotation(camera.camera_from_world_rotation, place + ".R");
    CheckFinite(camera.camera_from_world_translation, place + ".t");
  }
}

}  // namespace clothfit
