// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/camera.h"

#include <random>

#include <Eigen/Geometry>
#include <ceres/jet.h>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace clothfit {
namespace {

Camera TestCamera() {
  Camera camera;
  camera.name = "cam0";
  camera.width = 640;
  camera.height = 480;
  camera.fx = 520.0;
  camera.fy = 515.0;
  camera.cx = 318.5;
  camera.cy = 242.25;
  camera.distortion = {-0.21, 0.06, 0.0012, -0.0008, -0.004};
  camera.camera_from_world_rotation =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(0.9, 0.3, -0.2).normalized()).toRotationMatrix();
  camera.camera_from_world_translation = {0.3, -0.2, 3.0};
  return camera;
}

// Points before the camera, all over its picture and somewhat beyond.
std::vector<Eigen::Vector3d> PointsInView(const Camera& camera) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 50; ++i) {
    const double depth = 2.5 + unit(random);
    const double y = 0.5 * depth * unit(random), x = 0.65 * depth * unit(random);
    const Eigen::Vector3d in_camera(x, y, depth);
    points.emplace_back(camera.camera_from_world_rotation.transpose() *
                        (in_camera - camera.camera_from_world_translation));
  }
  return points;
}

TEST(ProjectPoint, AgreesWithOpenCv) {
  const Camera camera = TestCamera();
  const std::vector<Eigen::Vector3d> points = PointsInView(camera);
  std::vector<cv::Point3d> cv_points;
  for (const Eigen::Vector3d& point : points)
    cv_points.emplace_back(point.x(), point.y(), point.z());
  cv::Matx33d rotation;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rotation(i, j) = camera.camera_from_world_rotation(i, j);
  }
  cv::Vec3d rotation_vector;
  cv::Rodrigues(rotation, rotation_vector);
  const Eigen::Vector3d& t = camera.camera_from_world_translation;
  const cv::Matx33d k(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Mat distortion(1, 5, CV_64F, const_cast<double*>(camera.distortion.data()));
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(cv_points, rotation_vector, cv::Vec3d(t.x(), t.y(), t.z()), k, distortion,
                    pixels);
  ASSERT_EQ(pixels.size(), points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d pixel = ProjectPoint(camera, points[i]);
    EXPECT_NEAR(pixel.x(), pixels[i].x, 1e-9);  // px; rounding of the rotation vector
    EXPECT_NEAR(pixel.y(), pixels[i].y, 1e-9);
  }
}

TEST(ProjectPoint, PutsTheOpticalAxisAtThePrincipalPoint) {
  Camera camera = TestCamera();
  const Eigen::Vector3d axis = camera.camera_from_world_rotation.row(2);
  const Eigen::Vector2d pixel =
      ProjectPoint(camera, Eigen::Vector3d(CameraCentre(camera) + 2.0 * axis));
  EXPECT_NEAR(pixel.x(), camera.cx, 1e-9);
  EXPECT_NEAR(pixel.y(), camera.cy, 1e-9);
}

TEST(ProjectPoint, JetsAgreeWithCentralDifferences) {
  using Jet = ceres::Jet<double, 3>;
  const Camera camera = TestCamera();
  constexpr double kStep = 1e-5;  // m
  int checked = 0;
  for (const Eigen::Vector3d& point : PointsInView(camera)) {
    const Eigen::Matrix<Jet, 3, 1> jet_point(Jet(point.x(), 0), Jet(point.y(), 1),
                                             Jet(point.z(), 2));
    const Eigen::Matrix<Jet, 2, 1> pixel = ProjectPoint<Jet>(camera, jet_point);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
      const Eigen::Vector2d difference = (ProjectPoint(camera, Eigen::Vector3d(point + step)) -
                                          ProjectPoint(camera, Eigen::Vector3d(point - step))) /
                                         (2.0 * kStep);
      // px/m: hundreds in size; the differences are good to 1e-13 * 500 / 1e-5 and kStep^2.
      EXPECT_NEAR(pixel.x().v[i], difference.x(), 2e-5);
      EXPECT_NEAR(pixel.y().v[i], difference.y(), 2e-5);
      ++checked;
    }
    EXPECT_NEAR(pixel.x().a, ProjectPoint(camera, point).x(), 1e-10);
  }
  EXPECT_EQ(checked, 150);
}

TEST(UndistortPixel, RoundTripsOverTheWholePicture) {
  const Camera camera = TestCamera();
  int checked = 0;
  for (int y = 0; y < camera.height; y += 20) {
    for (int x = 0; x < camera.width; x += 20) {
      const Eigen::Vector2d pixel(x, y);
      const std::optional<Eigen::Vector3d> direction = PixelDirection(camera, pixel);
      ASSERT_TRUE(direction) << pixel.transpose();
      EXPECT_NEAR(direction->norm(), 1.0, 1e-14);
      const Eigen::Vector3d point = CameraCentre(camera) + 3.7 * *direction;
      EXPECT_TRUE(IsInFront(camera, point));
      EXPECT_LT((ProjectPoint(camera, point) - pixel).norm(), 1e-10);  // px
      ++checked;
    }
  }
  EXPECT_EQ(checked, 32 * 24);
}

TEST(UndistortPixel, IsExactWithoutDistortion) {
  Camera camera = TestCamera();
  camera.distortion = {};
  const std::optional<Eigen::Vector2d> point =
      UndistortPixel(camera, {camera.cx + 52.0, camera.cy});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->x(), 0.1, 1e-15);
  EXPECT_NEAR(point->y(), 0.0, 1e-15);
}

TEST(UndistortPixel, IsEmptyWhereTheLensHasNoInverse) {
  Camera camera = TestCamera();
  camera.distortion = {-0.3, 0.0, 0.0, 0.0, 0.0};
  // r (1 - 0.3 r^2) is largest at r = 1 / sqrt(0.9), where it is 0.7027.
  EXPECT_TRUE(UndistortPixel(camera, {camera.cx + 0.70 * camera.fx, camera.cy}));
  EXPECT_FALSE(UndistortPixel(camera, {camera.cx + 0.71 * camera.fx, camera.cy}));
  EXPECT_FALSE(UndistortPixel(camera, {camera.cx + 2.00 * camera.fx, camera.cy}));
}

TEST(CameraCentre, IsWhereTheCameraFrameHasItsOrigin) {
  const Camera camera = TestCamera();
  EXPECT_LT(CameraFromWorld<double>(camera, CameraCentre(camera)).norm(), 1e-14);
}

TEST(IsInFront, TellsTheSidesOfTheCamera) {
  const Camera camera = TestCamera();
  const Eigen::Vector3d axis = camera.camera_from_world_rotation.row(2);
  EXPECT_TRUE(IsInFront(camera, CameraCentre(camera) + 0.1 * axis));
  EXPECT_FALSE(IsInFront(camera, CameraCentre(camera) - 0.1 * axis));
}

TEST(IsInImage, IncludesHalfAPixelAroundTheOutermostCentres) {
  const Camera camera = TestCamera();
  EXPECT_TRUE(IsInImage(camera, {-0.5, -0.5}));
  EXPECT_TRUE(IsInImage(camera, {639.4, 479.4}));
  EXPECT_FALSE(IsInImage(camera, {639.5, 10.0}));
  EXPECT_FALSE(IsInImage(camera, {10.0, 479.5}));
  EXPECT_FALSE(IsInImage(camera, {-0.6, 10.0}));
}

}  // namespace
}  // namespace clothfit
