// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/folder/validation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/LU>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kOnClothSlack = 1e-6;  // m; decimals in the file are rounded

std::string YamlPlace(const Recording& recording, const std::string& key) {
  return PlaceInRecording(recording, "recording.yaml", key);
}

void CheckFinite(const Eigen::Vector3d& vector, const std::string& place) {
  if (!vector.allFinite()) throw InputError(place, "expected finite numbers");
}

void CheckWithin(double value, const Limits& limits, const std::string& place) {
  if (value >= limits.least && value <= limits.most) return;
  throw InputError(
      place, value > 0.0 && std::isfinite(value)
                 ? fmt::format("expected {} to {}, found {}", limits.least, limits.most, value)
                 : fmt::format("expected a number above 0, found {}", value));
}

// What the file may hold of one kind. Paths take memory for every frame, and many may share a file.
void CheckCount(std::size_t count, const Recording& recording, const std::string& place) {
  constexpr double kMostPositions = 1e7;  // of all paths together: some 500 MB
  if (count > static_cast<std::size_t>(kMostThings))
    throw InputError(place, fmt::format("expected at most {}, found {}", kMostThings, count));
  if (static_cast<double>(count) * recording.frame_count > kMostPositions)
    throw InputError(place,
                     fmt::format("{} of them over {} frames; expected at most {:g} positions "
                                 "in all",
                                 count, recording.frame_count, kMostPositions));
}

void CheckPlacement(const Recording& recording, const FlatPlacement& flat) {
  constexpr double kTolerance =
      1e-3;  // a millimetre a metre; more would stretch or shear the cloth
  CheckPosition(flat.origin, YamlPlace(recording, "cloth.initial.origin"));
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
  if (points.size() < 3 || points.size() > size_t{kMostPlacedPoints}) {
    throw InputError(
        place, fmt::format("expected 3..{} points, found {}", kMostPlacedPoints, points.size()));
  }
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::set<std::pair<double, double>> seen;
  for (size_t i = 0; i < points.size(); ++i) {
    const PlacedPoint& point = points[i];
    const std::string point_place = fmt::format("{}: point {}", place, i + 1);
    CheckOnCloth(recording, point.uv, point_place);
    CheckPosition(point.position, point_place);
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
  if (IsThere(mesh.file)) return CheckInputFile(mesh.file);
  throw InputError(YamlPlace(recording, "cloth.mesh"),
                   fmt::format("no such file: {}", mesh.file.string()));
}

// Names become file names and fields of CSV.
void CheckName(const std::string& name, std::set<std::string>* seen, const std::string& place) {
  CheckShown(name, place);
  const bool usable = !name.empty() && name.front() != '.' && TrimBlanks(name) == name &&
                      name.find_first_of("/\\,") == std::string::npos;
  if (!usable) {
    throw InputError(place, fmt::format("{} cannot name a file; expected a name without slashes "
                                        "or commas that does not start with a dot",
                                        Quoted(name)));
  }
  if (!seen->insert(name).second) throw InputError(place, "'" + name + "' appears twice");
}

void CheckTurn(const Eigen::Vector3d& rotation, const std::string& place) {
  CheckFinite(rotation, place);
  const double largest = rotation.cwiseAbs().maxCoeff();
  if (largest <= kMostRotation) return;
  throw InputError(place,
                   fmt::format("expected radians, at most {:g}, found {}", kMostRotation, largest));
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

void CheckPosition(const Eigen::Vector3d& position, const std::string& place) {
  CheckFinite(position, place);
  const double farthest = position.cwiseAbs().maxCoeff();
  if (farthest <= kFarthest) return;
  throw InputError(place, fmt::format("expected metres, at most {} from the world's origin, found "
                                      "{}",
                                      kFarthest, farthest));
}

void CheckShown(const std::string& name, const std::string& place) {
  if (name.size() > static_cast<std::size_t>(kLongestName))
    throw InputError(
        place, fmt::format("expected at most {} bytes, found {}", kLongestName, Quoted(name)));
  if (Printable(name) == name) return;
  throw InputError(place, Quoted(name) +
                              "; expected UTF-8 without control characters and marks "
                              "that turn the direction of writing");
}

void CheckFrame(const Recording& recording, int frame, const std::string& place) {
  if (frame >= 0 && frame < recording.frame_count) return;
  throw InputError(place,
                   fmt::format("frame {} is outside 0..{}", frame, recording.frame_count - 1));
}

void CheckScene(const Recording& recording) {
  CheckShown(recording.name, YamlPlace(recording, "name"));
  CheckWithin(recording.frame_rate, kFrameRate, YamlPlace(recording, "frame_rate"));
  if (recording.frame_count < 1 || recording.frame_count > kMostFrames) {
    throw InputError(YamlPlace(recording, "frame_count"),
                     fmt::format("expected 1..{}, found {}", kMostFrames, recording.frame_count));
  }
  CheckFinite(recording.gravity, YamlPlace(recording, "gravity"));
  if (const double gravity = recording.gravity.cwiseAbs().maxCoeff(); gravity > kMostGravity) {
    throw InputError(YamlPlace(recording, "gravity"),
                     fmt::format("expected at most {} m/s^2, found {}", kMostGravity, gravity));
  }
  if (recording.ground_height) {
    CheckPosition({0.0, 0.0, *recording.ground_height}, YamlPlace(recording, "ground.height"));
  }
}

void CheckCloth(const Recording& recording) {
  const ClothDescription& cloth = recording.cloth;
  CheckWithin(cloth.size.x(), kSide, YamlPlace(recording, "cloth.size[0]"));
  CheckWithin(cloth.size.y(), kSide, YamlPlace(recording, "cloth.size[1]"));
  if (cloth.resolution.minCoeff() < 2 || cloth.resolution.maxCoeff() > kMostResolution) {
    throw InputError(YamlPlace(recording, "cloth.resolution"),
                     fmt::format("expected 2 to {} particles each way, found [{}, {}]",
                                 kMostResolution, cloth.resolution.x(), cloth.resolution.y()));
  }
  if (cloth.areal_density) {
    CheckWithin(*cloth.areal_density, kDensity, YamlPlace(recording, "cloth.areal_density"));
  }
  std::visit([&](const auto& placement) { CheckPlacement(recording, placement); }, cloth.initial);
}

void CheckHandles(const Recording& recording) {
  std::set<std::string> names;
  CheckCount(recording.handles.size(), recording, YamlPlace(recording, "handles"));
  for (size_t i = 0; i < recording.handles.size(); ++i) {
    const HandleDescription& handle = recording.handles[i];
    const std::string place = YamlPlace(recording, fmt::format("handles[{}]", i));
    CheckName(handle.name, &names, place + ".name");
    CheckOnCloth(recording, handle.uv, place + ".uv");
    if (handle.path_sigma) CheckWithin(*handle.path_sigma, kSigma, place + ".path_sigma");
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
      if (position) CheckPosition(*position, place + ".path");
      any_known = any_known || position.has_value();
    }
    if (!any_known) throw InputError(place + ".path", "expected at least one position");
  }
}

void CheckObstacles(const Recording& recording) {
  std::set<std::string> names;
  CheckCount(recording.obstacles.size(), recording, YamlPlace(recording, "obstacles"));
  for (size_t i = 0; i < recording.obstacles.size(); ++i) {
    const ObstacleDescription& obstacle = recording.obstacles[i];
    const std::string place = YamlPlace(recording, fmt::format("obstacles[{}]", i));
    CheckName(obstacle.name, &names, place + ".name");
    if (const auto* ball = std::get_if<BallShape>(&obstacle.shape)) {
      CheckWithin(ball->radius, kLength, place + ".sphere.radius");
    } else if (const auto* bar = std::get_if<BarShape>(&obstacle.shape)) {
      CheckWithin(bar->radius, kLength, place + ".capsule.radius");
      CheckWithin(bar->length, kLength, place + ".capsule.length");
    } else if (const auto* box = std::get_if<BoxShape>(&obstacle.shape)) {
      for (int k = 0; k < 3; ++k)
        CheckWithin(box->size[k], kLength, place + fmt::format(".box.size[{}]", k));
      if (box->below != 0.0) CheckWithin(box->below, kLength, place + ".box.below");
    } else if (const auto& file = std::get<MeshShape>(obstacle.shape).file; !IsThere(file)) {
      throw InputError(place + ".mesh", fmt::format("no such file: {}", file.string()));
    }
    const size_t frames = obstacle.path.size();
    if (frames != 1 && frames != static_cast<size_t>(recording.frame_count)) {
      throw InputError(place + ".path",
                       fmt::format("expected {} frames, found {}", recording.frame_count, frames));
    }
    for (const ObstacleDescription::Pose& pose : obstacle.path) {
      CheckPosition(pose.position, place + (frames == 1 ? ".position" : ".path"));
      CheckTurn(pose.rotation, place + (frames == 1 ? ".rotation" : ".path"));
    }
  }
}

void CheckNoiseAndSplits(const Recording& recording) {
  const NoiseSigmas& noise = recording.noise;
  const auto check_sigma = [&](const std::optional<double>& sigma, const std::string& key) {
    if (sigma) CheckWithin(*sigma, kSigma, YamlPlace(recording, key));
  };
  check_sigma(noise.marker, "noise.marker");
  check_sigma(noise.layout, "noise.layout");
  check_sigma(noise.track, "noise.track");
  check_sigma(noise.silhouette, "noise.silhouette");
  check_sigma(noise.cloud, "noise.cloud");
  check_sigma(noise.obstacles, "noise.obstacles");
  if (noise.cloud_spacing)
    CheckWithin(*noise.cloud_spacing, kLength, YamlPlace(recording, "noise.cloud_spacing"));
  if (const std::optional<Splits::FrameRange>& range = recording.splits.held_out_frames) {
    const std::string place = YamlPlace(recording, "splits.held_out_frames");
    CheckFrame(recording, range->first, place);
    CheckFrame(recording, range->last, place);
    if (range->first > range->last) {
      throw InputError(
          place, fmt::format("expected [first, last], found [{}, {}]", range->first, range->last));
    }
  }
  for (const std::string& name : recording.splits.held_out_cameras) {
    if (FindCamera(recording, name)) continue;
    throw InputError(YamlPlace(recording, "splits.held_out_cameras"),
                     IsNoCamera(name, recording.cameras));
  }
}

void CheckCameras(const Recording& recording) {
  std::set<std::string> names;
  if (recording.cameras.size() > static_cast<std::size_t>(kMostThings)) {
    throw InputError(
        PlaceInRecording(recording, "cameras.yaml", "cameras"),
        fmt::format("expected at most {}, found {}", kMostThings, recording.cameras.size()));
  }
  for (size_t i = 0; i < recording.cameras.size(); ++i) {
    const Camera& camera = recording.cameras[i];
    const std::string place =
        PlaceInRecording(recording, "cameras.yaml", fmt::format("cameras[{}]", i));
    CheckName(camera.name, &names, place + ".name");
    if (!IsPictureSize(camera.width, camera.height)) {
      throw InputError(
          place + ".size",
          fmt::format("expected 1 to {} px each way, {:g} in all, found [{}, {}]", kMostPictureSide,
                      kMostPicturePixels, camera.width, camera.height));
    }
    CheckWithin(camera.fx, kFocalLength, place + ".K: fx");
    CheckWithin(camera.fy, kFocalLength, place + ".K: fy");
    const bool bounded =
        std::abs(camera.cx) <= kFarthestPixel && std::abs(camera.cy) <= kFarthestPixel &&
        std::all_of(camera.distortion.begin(), camera.distortion.end(),
                    [](double value) { return std::abs(value) <= kMostDistortion; });
    if (!bounded) {
      throw InputError(place, fmt::format("expected cx and cy of at most {:g} px in K, and at most "
                                          "{:g} in distortion",
                                          kFarthestPixel, kMostDistortion));
    }
    CheckRotation(camera.camera_from_world_rotation, place + ".R");
    CheckPosition(camera.camera_from_world_translation, place + ".t");
  }
}

}  // namespace clothfit
