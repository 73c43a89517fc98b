// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/pictures/corner_placement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "tracking/camera/triangulation.h"

namespace clothfit {
namespace {

constexpr const char* kOption = "--corner";
constexpr double kMillimetresPerMetre = 1e3;

// One point of the cloth with all its views; triangulated where there are two or more.
struct Corner {
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();  // m
  std::vector<Sighting> sightings;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m, world; of the former

  bool is_triangulated() const { return sightings.size() > 1; }
};

std::string Described(const Eigen::Vector2d& uv) {
  return fmt::format("({:g}, {:g})", uv.x(), uv.y());
}

int CameraIndex(const std::string& name, const std::vector<Camera>& cameras) {
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (cameras[i].name == name) return static_cast<int>(i);
  }
  throw InputError(kOption, "'" + name + "' is no camera; " + Suggestion(name, NamesOf(cameras)));
}

std::vector<Corner> ByPoint(const std::vector<SeenCorner>& seen, const std::vector<Camera>& cameras,
                            const Eigen::Vector2d& size) {
  std::vector<Corner> corners;
  for (const SeenCorner& one : seen) {
    const int camera = CameraIndex(one.camera, cameras);
    if (!IsInImage(cameras[static_cast<size_t>(camera)], one.pixel)) {
      throw InputError(kOption, fmt::format("pixel ({:g}, {:g}) is outside the picture of '{}'",
                                            one.pixel.x(), one.pixel.y(), one.camera));
    }
    const bool is_on_cloth =
        (one.uv.array() >= 0.0).all() && (one.uv.array() <= size.array()).all();
    if (!is_on_cloth) {
      throw InputError(kOption, fmt::format("{} is not on the cloth; expected 0 to {:g} and 0 to "
                                            "{:g} m",
                                            Described(one.uv), size.x(), size.y()));
    }
    auto known = std::find_if(corners.begin(), corners.end(),
                              [&](const Corner& corner) { return corner.uv == one.uv; });
    if (known == corners.end()) known = corners.insert(known, Corner{one.uv, {}, {}});
    for (const Sighting& other : known->sightings) {
      if (other.camera != camera) continue;
      throw InputError(kOption, Described(one.uv) + " is given twice in '" + one.camera + "'");
    }
    known->sightings.push_back({camera, one.pixel});
  }
  return corners;
}

void Triangulate(const std::vector<Camera>& cameras, std::vector<Corner>* corners,
                 std::vector<std::string>* notes) {
  TriangulationOptions options;
  options.gate = 10.0;  // px; somebody points at them
  for (Corner& corner : *corners) {
    if (!corner.is_triangulated()) continue;
    const size_t count = corner.sightings.size();
    const auto found = TriangulateRobustly(cameras, corner.sightings, options);
    if (!found || found->num_agreeing < static_cast<int>(count)) {
      throw InputError(kOption,
                       fmt::format("the views of {} are not of one point: they are more than {:g} "
                                   "px off, or of directions that hardly differ",
                                   Described(corner.uv), options.gate));
    }
    corner.position = found->position;
    notes->push_back(
        fmt::format("corner {}: at ({:.3f}, {:.3f}, {:.3f}) m, by {} cameras, off by "
                    "{:.1f} px",
                    Described(corner.uv), corner.position.x(), corner.position.y(),
                    corner.position.z(), count, found->reprojection_rms));
  }
}

FlatPlacement PlacementOf(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& origin) {
  return {origin, rotation.col(0), rotation.col(1)};
}

bool IsLine(const std::vector<Corner>& corners) {
  const Eigen::Vector2d along = corners[1].uv - corners[0].uv;
  return std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    const Eigen::Vector2d other = corner.uv - corners[0].uv;
    constexpr double kFlat = 1e-3;  // of the lengths' product
    return std::abs(along.x() * other.y() - along.y() * other.x()) <=
           kFlat * along.norm() * other.norm();
  });
}

FlatPlacement ByThree(const std::vector<Corner>& corners) {
  const auto count = static_cast<Eigen::Index>(corners.size());
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, count);
  Eigen::Matrix3Xd places(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    flat.col(i).head<2>() = corners[static_cast<size_t>(i)].uv;
    places.col(i) = corners[static_cast<size_t>(i)].position;
  }
  const Eigen::Matrix4d motion = Eigen::umeyama(flat, places, false);
  return PlacementOf(motion.topLeftCorner<3, 3>(), motion.topRightCorner<3, 1>());
}

// Straight down from the line between two points.
FlatPlacement Hanging(const Corner& a, const Corner& b, const Eigen::Vector2d& size) {
  const Eigen::Vector2d along_uv = (b.uv - a.uv).normalized();
  const Eigen::Vector2d across_uv(-along_uv.y(), along_uv.x());
  const Eigen::Vector3d along = (b.position - a.position).normalized();
  const Eigen::Vector3d down =
      -Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitZ().dot(along) * along;
  constexpr double kSteep = 0.3;  // sine of the angle to the vertical
  if (down.norm() < kSteep) {
    throw InputError(kOption, "the two corners are nearly one above the other; expected a third");
  }
  const Eigen::Vector2d middle_uv = 0.5 * (a.uv + b.uv);
  const bool is_below = (0.5 * size - middle_uv).dot(across_uv) >= 0.0;
  const Eigen::Vector3d across = (is_below ? 1.0 : -1.0) * down.normalized();
  FlatPlacement flat;
  flat.u_axis = along_uv.x() * along + across_uv.x() * across;
  flat.v_axis = along_uv.y() * along + across_uv.y() * across;
  flat.origin =
      0.5 * (a.position + b.position) - middle_uv.x() * flat.u_axis - middle_uv.y() * flat.v_axis;
  return flat;
}

std::optional<FlatPlacement> ByOneCamera(const std::vector<SeenCorner>& seen,
                                         const Camera& camera) {
  std::vector<cv::Point3d> flat;
  std::vector<cv::Point2d> normalised;
  for (const SeenCorner& one : seen) {
    const std::optional<Eigen::Vector2d> point = UndistortPixel(camera, one.pixel);
    if (!point) return std::nullopt;
    flat.emplace_back(one.uv.x(), one.uv.y(), 0.0);
    normalised.emplace_back(point->x(), point->y());
  }
  cv::Vec3d turn, shift;
  const cv::Matx33d no_lens = cv::Matx33d::eye();
  try {
    if (!cv::solvePnP(flat, normalised, no_lens, cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE)) {
      return std::nullopt;
    }
  } catch (const cv::Exception&) {  // points on a line
    return std::nullopt;
  }
  const Eigen::Vector3d axis(turn[0], turn[1], turn[2]);
  const double angle = axis.norm();
  const Eigen::Matrix3d camera_from_sheet =
      angle > 0.0 ? Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix()
                  : Eigen::Matrix3d::Identity();
  const Eigen::Vector3d origin_in_camera(shift[0], shift[1], shift[2]);
  const Eigen::Matrix3d world_from_camera = camera.camera_from_world_rotation.transpose();
  return PlacementOf(world_from_camera * camera_from_sheet,
                     world_from_camera * (origin_in_camera - camera.camera_from_world_translation));
}

// By the first camera that sees four corners.
std::optional<FlatPlacement> ByAnyCamera(const std::vector<Corner>& corners,
                                         const std::vector<Camera>& cameras,
                                         std::vector<std::string>* notes) {
  for (size_t camera = 0; camera < cameras.size(); ++camera) {
    std::vector<SeenCorner> seen;
    for (const Corner& corner : corners) {
      for (const Sighting& one : corner.sightings) {
        if (one.camera == int(camera)) seen.push_back({"", corner.uv, one.pixel});
      }
    }
    if (seen.size() < 4) continue;
    notes->push_back(fmt::format("the sheet is placed by {} corners in '{}' alone", seen.size(),
                                 cameras[camera].name));
    return ByOneCamera(seen, cameras[camera]);
  }
  return std::nullopt;
}

FlatPlacement Place(const std::vector<Corner>& corners, const std::vector<Camera>& cameras,
                    const Eigen::Vector2d& size, std::vector<std::string>* notes) {
  std::vector<Corner> placed;
  std::copy_if(corners.begin(), corners.end(), std::back_inserter(placed),
               [](const Corner& corner) { return corner.is_triangulated(); });
  if (placed.size() > 2 && !IsLine(placed)) return ByThree(placed);
  if (placed.size() >= 2) {
    notes->emplace_back("the sheet is taken to hang straight down from these corners");
    return Hanging(placed.front(), placed.back(), size);
  }
  if (const auto flat = ByAnyCamera(corners, cameras, notes)) return *flat;
  throw InputError(kOption,
                   "expected three corners that two cameras see, two where the cloth hangs from "
                   "them, or four in one camera");
}

void NoteErrors(const std::vector<Corner>& corners, const std::vector<Camera>& cameras,
                SheetPlacement* placement) {
  double largest_px = 0.0;
  double largest_m = 0.0;
  const FlatPlacement& flat = placement->flat;
  for (const Corner& corner : corners) {
    const Eigen::Vector3d place =
        flat.origin + corner.uv.x() * flat.u_axis + corner.uv.y() * flat.v_axis;
    for (const double error : ReprojectionErrors(cameras, corner.sightings, place)) {
      largest_px = std::max(largest_px, error);
    }
    if (corner.is_triangulated()) {
      largest_m = std::max(largest_m, (place - corner.position).norm());
    }
  }
  placement->notes.push_back(fmt::format(
      "the flat sheet is off the corners by at most {:.1f} px, and {:.1f} mm from those "
      "that two cameras see",
      largest_px, kMillimetresPerMetre * largest_m));
}

}  // namespace

SheetPlacement PlaceByCorners(const std::vector<SeenCorner>& seen,
                              const std::vector<Camera>& cameras, const Eigen::Vector2d& size) {
  SheetPlacement placement;
  std::vector<Corner> corners = ByPoint(seen, cameras, size);
  Triangulate(cameras, &corners, &placement.notes);
  const FlatPlacement flat = Place(corners, cameras, size, &placement.notes);
  // Files of short numbers are easier to read, and nobody points to a micrometre.
  const auto rounded = [](const Eigen::Vector3d& vector, double steps) -> Eigen::Vector3d {
    return (vector.array() * steps).round() / steps + 0.0;  // no "-0"
  };
  placement.flat = {rounded(flat.origin, 1e6), rounded(flat.u_axis, 1e12),
                    rounded(flat.v_axis, 1e12)};
  NoteErrors(corners, cameras, &placement);
  return placement;
}

}  // namespace clothfit
