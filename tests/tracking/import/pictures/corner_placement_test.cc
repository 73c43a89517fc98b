// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/pictures/corner_placement.h"

#include <algorithm>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::HasSubstr;

const Eigen::Vector2d kSize(0.6, 0.4);  // m

Camera LookingFrom(const std::string& name, const Eigen::Vector3d& centre) {
  Camera camera;
  camera.name = name;
  camera.width = 1280;
  camera.height = 960;
  camera.fx = camera.fy = 1000.0;
  camera.cx = 640.0;
  camera.cy = 480.0;
  camera.distortion = {-0.1, 0.02, 0.001, -0.001, 0.0};
  const Eigen::Vector3d forward = (Eigen::Vector3d(0.0, 0.0, 1.0) - centre).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  camera.camera_from_world_rotation.row(0) = right;
  camera.camera_from_world_rotation.row(1) = forward.cross(right);
  camera.camera_from_world_rotation.row(2) = forward;
  camera.camera_from_world_translation = -camera.camera_from_world_rotation * centre;
  return camera;
}

std::vector<Camera> ThreeCameras() {
  return {LookingFrom("front", {0.0, -2.0, 1.2}), LookingFrom("left", {-1.5, -1.5, 1.0}),
          LookingFrom("right", {1.5, -1.5, 1.5})};
}

// Hangs from its edge v = 0, which leans by a few degrees.
FlatPlacement HangingSheet() {
  const Eigen::Vector3d u = Eigen::Vector3d(1.0, 0.2, 0.05).normalized();
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ() + u.z() * u;
  return {{-0.3, 0.05, 1.2}, u, down.normalized()};
}

Eigen::Vector3d On(const FlatPlacement& sheet, const Eigen::Vector2d& uv) {
  return sheet.origin + uv.x() * sheet.u_axis + uv.y() * sheet.v_axis;
}

// Of these points in these cameras, with the noise of somebody who points at them.
std::vector<SeenCorner> SeenBy(const FlatPlacement& sheet,
                               const std::vector<Eigen::Vector2d>& points,
                               const std::vector<Camera>& cameras, double noise = 0.5) {
  std::mt19937 random(11);
  std::normal_distribution<double> gaussian;
  std::vector<SeenCorner> seen;
  for (const Eigen::Vector2d& uv : points) {
    for (const Camera& camera : cameras) {
      const Eigen::Vector2d pixel = ProjectPoint(camera, On(sheet, uv));
      Eigen::Vector2d error;
      for (double& value : error.reverse()) value = gaussian(random);
      seen.push_back({camera.name, uv, pixel + noise * error});
    }
  }
  return seen;
}

// m, of the four corners.
double LargestError(const FlatPlacement& found, const FlatPlacement& truth) {
  double largest = 0.0;
  for (const double u : {0.0, kSize.x()}) {
    for (const double v : {0.0, kSize.y()}) {
      largest = std::max(largest, (On(found, {u, v}) - On(truth, {u, v})).norm());
    }
  }
  return largest;
}

TEST(CornerPlacement, ThreeCornersPlaceASheet) {
  const FlatPlacement truth{{-0.3, 0.1, 0.9},
                            Eigen::Vector3d(1.0, 0.3, 0.2).normalized(),
                            Eigen::Vector3d(-0.3, 1.0, 0.0).normalized()};
  const auto seen = SeenBy(truth, {{0.0, 0.0}, {0.6, 0.0}, {0.0, 0.4}}, ThreeCameras());
  const SheetPlacement placed = PlaceByCorners(seen, ThreeCameras(), kSize);
  // Half a pixel of 1000 at 2.2 m is 1.1 mm, and more in depth.
  EXPECT_LT(LargestError(placed.flat, truth), 0.005);
  EXPECT_NEAR(placed.flat.u_axis.dot(placed.flat.v_axis), 0.0, 1e-12);
  EXPECT_THAT(placed.notes, Contains(HasSubstr("corner (0.6, 0): at (")));
  EXPECT_THAT(placed.notes, Contains(HasSubstr("the flat sheet is off the corners by at most")));
}

TEST(CornerPlacement, ASheetHangsFromTwoCorners) {
  const FlatPlacement truth = HangingSheet();
  const std::vector<Camera> cameras = ThreeCameras();
  const auto two = SeenBy(truth, {{0.0, 0.0}, {0.6, 0.0}}, {cameras[0], cameras[2]});
  EXPECT_LT(LargestError(PlaceByCorners(two, cameras, kSize).flat, truth), 0.006);
  // The same sheet named the other way round: it hangs from v = 0.4.
  const FlatPlacement turned{On(truth, {0.0, 0.4}), truth.u_axis, -truth.v_axis};
  const auto upper = SeenBy(turned, {{0.6, 0.4}, {0.0, 0.4}}, cameras);
  const SheetPlacement placed = PlaceByCorners(upper, cameras, kSize);
  EXPECT_LT(LargestError(placed.flat, turned), 0.006);
  EXPECT_THAT(placed.notes, Contains(HasSubstr("taken to hang straight down")));
}

TEST(CornerPlacement, FourCornersInOneCameraPlaceASheet) {
  const FlatPlacement truth = HangingSheet();
  const std::vector<Camera> cameras = ThreeCameras();
  const auto seen =
      SeenBy(truth, {{0.0, 0.0}, {0.6, 0.0}, {0.6, 0.4}, {0.0, 0.4}}, {cameras[1]}, 0.2);
  const SheetPlacement placed = PlaceByCorners(seen, cameras, kSize);
  // Depth follows from the size in the picture: 0.2 of 250 px at 2.1 m is 2 mm, and tilt adds to
  // it.
  EXPECT_LT(LargestError(placed.flat, truth), 0.02);
  EXPECT_THAT(placed.notes, Contains("the sheet is placed by 4 corners in 'left' alone"));
}

TEST(CornerPlacement, WrongCornersAreRefused) {
  const std::vector<Camera> cameras = ThreeCameras();
  const FlatPlacement sheet = HangingSheet();
  const auto error_of = [&](std::vector<SeenCorner> seen) {
    return InputErrorOf([&] { PlaceByCorners(seen, cameras, kSize); });
  };
  std::vector<SeenCorner> seen = SeenBy(sheet, {{0.0, 0.0}, {0.6, 0.0}}, cameras);
  seen[0].camera = "frnt";
  EXPECT_THAT(error_of(seen), HasSubstr("--corner: 'frnt' is no camera; did you mean 'front'?"));
  seen[0] = {"front", {0.0, 0.0}, {2000.0, 10.0}};
  EXPECT_THAT(error_of(seen), HasSubstr("pixel (2000, 10) is outside the picture of 'front'"));
  seen[0] = {"front", {0.7, 0.0}, {600.0, 10.0}};
  EXPECT_THAT(error_of(seen),
              HasSubstr("(0.7, 0) is not on the cloth; expected 0 to 0.6 and 0 to"));
  seen[0] = {"front", {0.0, 0.0}, {600.0, 10.0}};
  EXPECT_THAT(error_of(seen), HasSubstr("the views of (0, 0) are not of one point"));
  seen[0] = seen[1];
  EXPECT_THAT(error_of(seen), HasSubstr("(0, 0) is given twice in 'left'"));
  EXPECT_THAT(error_of(SeenBy(sheet, {{0.0, 0.0}}, cameras)),
              HasSubstr("expected three corners that two cameras see"));
  EXPECT_THAT(error_of(SeenBy(sheet, {{0.0, 0.0}, {0.0, 0.4}}, cameras)),
              HasSubstr("nearly one above the other"));
}

}  // namespace
}  // namespace clothfit
