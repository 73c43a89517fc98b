// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/renderer.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "tests/support/rendered_scene.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::array<double, 5> kLens = {-0.25, 0.08, 0.002, -0.001, 0.0};

Eigen::Vector3f ColourAt(const cv::Mat& picture, int x, int y) {
  const cv::Vec3f& colour = picture.at<cv::Vec3f>(y, x);
  return {colour[0], colour[1], colour[2]};
}

bool Same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; }

// On which side of the outline a pixel is by projecting the triangles into the picture, where lens
// distortion bends no edge by more than a hundredth of a pixel.
bool IsCovered(const RenderedScene& scene, const Vector2d& pixel) {
  for (const std::array<int, 3>& nodes : scene.mesh.triangles) {
    std::array<Vector2d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = ProjectPoint(scene.camera, Vector3d(scene.x.segment<3>(3 * nodes[k])));
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d side = corners[(k + 1) % 3] - corners[k], way = pixel - corners[k];
      (side.x() * way.y() - side.y() * way.x() > 0.0 ? left : right) += 1;
    }
    if (left == 0 || right == 0) return true;
  }
  return false;
}

void ExpectMaskIsTheProjection(const RenderedScene& scene) {
  const cv::Mat mask = scene.MakeRenderer(1).Mask(scene.surface);
  int inside = 0, different = 0;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const bool is_covered = IsCovered(scene, Vector2d(x, y));
      inside += is_covered ? 1 : 0;
      different += (mask.at<uchar>(y, x) == 255) == is_covered ? 0 : 1;
    }
  }
  EXPECT_GT(inside, 400);
  // Of some 150 pixels on the outline one may lie within a hundredth of a pixel of it.
  EXPECT_LE(different, 3);
}

TEST(Renderer, MaskIsTheProjectedSurface) {
  ExpectMaskIsTheProjection(RenderedScene());
  ExpectMaskIsTheProjection(RenderedScene(ClothPattern::kRich, kLens));
}

TEST(Renderer, PixelsShowThePointsThatProjectOntoThem) {
  const RenderedScene scene(ClothPattern::kRich, kLens);
  int seen_count = 0;
  for (int y = 0; y < scene.camera.height; y += 3) {
    for (int x = 0; x < scene.camera.width; x += 3) {
      const auto seen = scene.surface.SeenAt(scene.camera, Vector2d(x, y));
      if (!seen) continue;
      ++seen_count;
      EXPECT_LT((ProjectPoint(scene.camera, seen->position) - Vector2d(x, y)).norm(), 1e-9);
      const SurfacePoint located = LocateOnCloth(scene.mesh, {seen->uv})[0];
      EXPECT_LT((located.At(scene.x) - seen->position).norm(), 1e-9);
      EXPECT_GT(seen->normal.dot(CameraCentre(scene.camera) - seen->position), -0.2);
    }
  }
  EXPECT_GT(seen_count, 50);
}

TEST(Renderer, PixelsHaveTheTexturesColour) {
  const RenderedScene scene;
  const cv::Mat picture = scene.MakeRenderer(1).Render(scene.surface);
  int checked = 0;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const auto seen = scene.surface.SeenAt(scene.camera, Vector2d(x, y));
      if (!seen) continue;
      const double slant =
          seen->facet.dot((CameraCentre(scene.camera) - seen->position).normalized());
      if (slant < 0.3) continue;
      const double footprint = seen->distance / (scene.camera.fx * std::sqrt(slant));
      // The light is white: it changes no ratio of the channels.
      const Eigen::Vector3f expected = scene.look.texture.At(seen->uv, footprint).normalized();
      EXPECT_LT((ColourAt(picture, x, y).normalized() - expected).norm(), 1e-5) << x << " " << y;
      ++checked;
    }
  }
  EXPECT_GT(checked, 400);
}

TEST(Renderer, ShadowIsWhereTheLampIsHidden) {
  const RenderedScene scene;
  const Renderer renderer = scene.MakeRenderer(1);
  const cv::Mat picture = renderer.Render(scene.surface), mask = renderer.Mask(scene.surface);
  int shaded = 0, lit = 0;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      if (mask.at<uchar>(y, x) != 0) continue;
      const RoomPoint point =
          HitRoom(scene.room, CameraCentre(scene.camera), *PixelDirection(scene.camera, {x, y}));
      const bool is_hidden = scene.surface.rays().IsBlocked(scene.room.lamp, point.position, 0.0);
      const double expected = Irradiance(scene.room, point.position, point.normal, !is_hidden) /
                              Irradiance(scene.room, point.position, point.normal, true);
      EXPECT_NEAR(picture.at<cv::Vec3f>(y, x)[1] / renderer.empty().at<cv::Vec3f>(y, x)[1],
                  expected, 1e-5);
      (is_hidden ? shaded : lit) += 1;
    }
  }
  EXPECT_GT(shaded, 50);
  EXPECT_GT(lit, 500);
}

// A square above another, both in the light of the lamp: where the upper one stands in the way, the
// lower one has the ambient light alone.
TEST(Renderer, TheClothShadesItself) {
  RenderedScene scene(ClothPattern::kPlain);
  const int num_along_u = scene.mesh.grid[0];
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const double v = scene.mesh.uv[i].y();  // bent like a Z, with a gap above the middle
    const double y = std::abs(v - 0.4);
    scene.x.segment<3>(3 * i) =
        Vector3d(scene.mesh.uv[i].x(), y, v < 0.4 ? 0.6 - 0.3 * (i / num_along_u) / 8.0 : 0.3);
  }
  scene.surface.MoveTo(scene.x);
  const Renderer renderer = scene.MakeRenderer(1);
  const cv::Mat picture = renderer.Render(scene.surface);
  int shaded = 0;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const auto seen = scene.surface.SeenAt(scene.camera, Vector2d(x, y));
      if (!seen || seen->uv.y() < 0.45) continue;
      if (!scene.surface.rays().IsBlocked(scene.room.lamp, seen->position, 0.003)) continue;
      ++shaded;
      const float colour = scene.look.texture.At(seen->uv, 0.01)[1];
      EXPECT_NEAR(picture.at<cv::Vec3f>(y, x)[1],
                  colour * Irradiance(scene.room, seen->position, seen->normal, false), 1e-5);
    }
  }
  EXPECT_GT(shaded, 20);
}

TEST(Renderer, DoesNotDependOnTheThreads) {
  const RenderedScene scene;
  const Renderer one = scene.MakeRenderer(2, 1), two = scene.MakeRenderer(2, 2);
  EXPECT_TRUE(Same(one.empty(), two.empty()));
  EXPECT_TRUE(Same(one.Render(scene.surface), two.Render(scene.surface)));
}

TEST(Renderer, ShowsTheEmptyRoomAwayFromTheCloth) {
  RenderedScene scene;
  const Renderer renderer = scene.MakeRenderer(2);
  const ClothSurface none(scene.mesh);
  EXPECT_TRUE(Same(renderer.Render(none), renderer.empty()));
  EXPECT_EQ(cv::countNonZero(renderer.Mask(none)), 0);
  // Behind the camera it is not seen either, nor its shadow, however large its bounds are then.
  const Vector3d away = 1.2 * CameraCentre(scene.camera) - scene.room.centre * 0.2;
  for (int i = 0; i < scene.mesh.num_particles(); ++i)
    scene.x.segment<3>(3 * i) = away + Vector3d(0.0, -0.3, 0.01 * i);
  scene.surface.MoveTo(scene.x);
  EXPECT_EQ(cv::countNonZero(renderer.Mask(scene.surface)), 0);
}

TEST(Renderer, MoreSamplesComeCloserToTheMean) {
  const RenderedScene scene;
  const cv::Mat fine = scene.MakeRenderer(8).Render(scene.surface);
  const double one = cv::norm(scene.MakeRenderer(1).Render(scene.surface), fine);
  const double three = cv::norm(scene.MakeRenderer(3).Render(scene.surface), fine);
  EXPECT_LT(three, 0.6 * one);
}

}  // namespace
}  // namespace clothfit
