// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/outline.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/crumpled_cloth.h"
#include "tests/support/flat_scene.h"
#include "tracking/silhouette/raster.h"

namespace clothfit {
namespace {

struct Seen {
  Camera camera;
  BitMask mask;
  std::vector<OutlinePiece> outline;
};

Seen See(const CrumpledCloth& cloth, bool is_bent) {
  Seen seen;
  seen.camera = LookAt({0.1, -0.7, 0.9}, {0.4, 0.3, 0.0}, 250.0);
  if (is_bent) seen.camera.distortion = {-0.2, 0.05, 0.002, -0.001, 0.01};
  SilhouetteRaster(seen.camera, cloth.mesh.triangles).Draw(cloth.x, &seen.mask);
  seen.outline = FindOutline(seen.camera, FindEdges(cloth.mesh.triangles), cloth.mesh.triangles,
                             cloth.x, seen.mask);
  return seen;
}

TEST(FindEdges, FindsEachOnce) {
  const ClothMesh mesh = MakeGrid({1.0, 1.0}, {4, 5});
  const std::vector<MeshEdge> edges = FindEdges(mesh.triangles);
  EXPECT_EQ(edges.size(), 20 + mesh.triangles.size() - 1);  // Euler: V - E + F = 1
  int rim = 0;
  for (const MeshEdge& edge : edges) {
    rim += edge.triangles[1] < 0 ? 1 : 0;
    for (int side = 0; side < 2 && edge.triangles[side] >= 0; ++side) {
      const std::array<int, 3>& t = mesh.triangles[edge.triangles[side]];
      EXPECT_EQ(edge.nodes[0] + edge.nodes[1] + edge.opposite[side], t[0] + t[1] + t[2]);
    }
  }
  EXPECT_EQ(rim, 2 * (3 + 4));
}

TEST(FindOutline, IsWhereTheMaskEnds) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    for (const bool is_bent : {false, true}) {
      const CrumpledCloth cloth = Crumple(seed);
      const Seen seen = See(cloth, is_bent);
      const cv::Mat mask = seen.mask.ToMat();
      cv::Mat margin;
      cv::morphologyEx(mask, margin, cv::MORPH_GRADIENT,
                       cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
      // Every piece lies there ...
      for (const OutlinePiece& piece : seen.outline) {
        const Eigen::Vector2d middle = 0.5 * (piece.pixels[0] + piece.pixels[1]);
        const cv::Point at(static_cast<int>(std::lround(middle.x())),
                           static_cast<int>(std::lround(middle.y())));
        if (cv::Rect(0, 0, mask.cols, mask.rows).contains(at)) {
          EXPECT_NE(margin.at<std::uint8_t>(at), 0) << middle.transpose();
        }
      }
      // ... and hardly anything of it has none nearby.
      int lonely = 0, count = 0;
      for (int y = 1; y + 1 < mask.rows; ++y) {
        for (int x = 1; x + 1 < mask.cols; ++x) {
          if (mask.at<std::uint8_t>(y, x) == 0 || margin.at<std::uint8_t>(y, x) == 0) continue;
          ++count;
          const auto nearest = NearestOnOutline(seen.outline, {x, y});
          ASSERT_TRUE(nearest.has_value());
          lonely += std::abs(nearest->distance) > 1.6 ? 1 : 0;
        }
      }
      EXPECT_LE(lonely, 0.02 * count);
    }
  }
}

TEST(NearestOnOutline, IsAPointOfTheClothAndHasASide) {
  const CrumpledCloth cloth = Crumple(2);
  for (const bool is_bent : {false, true}) {
    const Seen seen = See(cloth, is_bent);
    int inside = 0, wrong = 0, count = 0;
    for (int y = 5; y < seen.camera.height; y += 7) {
      for (int x = 5; x < seen.camera.width; x += 7) {
        const Eigen::Vector2d pixel(x, y);
        const auto nearest = NearestOnOutline(seen.outline, pixel);
        ASSERT_TRUE(nearest.has_value());
        const Eigen::Vector3d point =
            (1.0 - nearest->share) * cloth.x.segment<3>(3 * nearest->nodes[0]) +
            nearest->share * cloth.x.segment<3>(3 * nearest->nodes[1]);
        EXPECT_NEAR((ProjectPoint(seen.camera, point) - pixel).norm(), std::abs(nearest->distance),
                    0.01);
        ++count;
        inside += seen.mask.At(x, y) ? 1 : 0;
        wrong +=
            (nearest->distance < 0.0) != seen.mask.At(x, y) && std::abs(nearest->distance) > 1.0
                ? 1
                : 0;
      }
    }
    EXPECT_GT(inside, 50);
    EXPECT_LE(wrong, 0.01 * count);
  }
  EXPECT_FALSE(NearestOnOutline({}, {1.0, 2.0}).has_value());
}

}  // namespace
}  // namespace clothfit
