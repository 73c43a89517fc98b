// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/raster.h"

#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "tests/support/crumpled_cloth.h"
#include "tests/support/flat_scene.h"
#include "tracking/recording/surface/cloth_surface.h"

namespace clothfit {
namespace {

Camera Bent(Camera camera) {
  camera.distortion = {-0.2, 0.05, 0.002, -0.001, 0.01};
  return camera;
}

// Möller and Trumbore, in double precision, for every triangle.
bool IsHitByForce(const CrumpledCloth& cloth, const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction) {
  for (const std::array<int, 3>& t : cloth.mesh.triangles) {
    const Eigen::Vector3d a = cloth.x.segment<3>(3 * t[0]);
    const Eigen::Vector3d ab = cloth.x.segment<3>(3 * t[1]) - a;
    const Eigen::Vector3d ac = cloth.x.segment<3>(3 * t[2]) - a;
    const Eigen::Vector3d p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0.0) continue;
    const Eigen::Vector3d from = origin - a;
    const double u = from.dot(p) / determinant;
    const Eigen::Vector3d q = from.cross(ab);
    const double v = direction.dot(q) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ac.dot(q) / determinant > 0.0) return true;
  }
  return false;
}

int DifferencesByForce(const Camera& camera, const CrumpledCloth& cloth, const BitMask& mask) {
  int differences = 0;
  const Eigen::Vector3d centre = CameraCentre(camera);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto direction = PixelDirection(camera, Eigen::Vector2d(x, y));
      const bool hit = direction && IsHitByForce(cloth, centre, *direction);
      differences += hit != mask.At(x, y) ? 1 : 0;
    }
  }
  return differences;
}

TEST(SilhouetteRaster, IsThatOfRaysThroughThePixelsCentres) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const CrumpledCloth cloth = Crumple(seed);
    const Camera pinhole = LookAt({0.1, -0.7, 0.9}, {0.4, 0.3, 0.0}, 250.0);
    for (const Camera& camera : {pinhole, Bent(pinhole)}) {
      BitMask mask;
      SilhouetteRaster(camera, cloth.mesh.triangles).Draw(cloth.x, &mask);
      EXPECT_GT(mask.Count(), 3000);
      EXPECT_EQ(DifferencesByForce(camera, cloth, mask), 0);
      // Embree computes in single precision: a pixel on an edge may go either way.
      ClothSurface surface(cloth.mesh);
      surface.MoveTo(cloth.x);
      int differences = 0;
      for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
          const bool seen = surface.SeenAt(camera, Eigen::Vector2d(x, y)).has_value();
          differences += seen != mask.At(x, y) ? 1 : 0;
        }
      }
      EXPECT_LE(differences, 2);
    }
  }
}

// The camera stands among the folds: triangles reach behind it.
TEST(SilhouetteRaster, SeesNothingBehindTheCamera) {
  const CrumpledCloth cloth = Crumple(5, 0.3);
  for (const Eigen::Vector3d& target : {Eigen::Vector3d(1.0, 0.6, 0.1), {-1.0, 0.2, 0.3}}) {
    const Camera camera = LookAt({0.4, 0.3, 0.05}, target, 200.0);
    BitMask mask;
    SilhouetteRaster(camera, cloth.mesh.triangles).Draw(cloth.x, &mask);
    EXPECT_GT(mask.Count(), 1000);
    EXPECT_EQ(DifferencesByForce(camera, cloth, mask), 0);
  }
  BitMask mask;
  const Camera away = LookAt({0.4, 0.3, 2.0}, {0.5, 0.3, 3.0});
  SilhouetteRaster(away, cloth.mesh.triangles).Draw(cloth.x, &mask);
  EXPECT_EQ(mask.Count(), 0);
}

// Edges run exactly through pixels' centres: they belong to the cloth, and nothing falls between.
TEST(SilhouetteRaster, HasNoGapsBetweenTriangles) {
  Camera camera;
  camera.width = 100;
  camera.height = 80;
  camera.fx = camera.fy = 64.0;
  camera.cx = 50.0;
  camera.cy = 40.0;
  CrumpledCloth cloth{MakeGrid({1.0, 0.5}, {9, 5}), {}};
  cloth.x.resize(3 * cloth.mesh.num_particles());
  for (int i = 0; i < cloth.mesh.num_particles(); ++i) {
    cloth.x.segment<3>(3 * i) << cloth.mesh.uv[i].array() - 0.25, 1.0;
  }
  BitMask mask;
  SilhouetteRaster(camera, cloth.mesh.triangles).Draw(cloth.x, &mask);
  EXPECT_EQ(mask.Count(), 65 * 33);
  EXPECT_TRUE(mask.At(50 - 16, 40 - 16));
  EXPECT_TRUE(mask.At(50 + 48, 40 + 16));
}

TEST(SilhouetteRaster, DrawsWhatIsNotANumberNowhere) {
  CrumpledCloth cloth = Crumple(1);
  const Camera camera = LookAt({0.1, -0.7, 0.9}, {0.4, 0.3, 0.0}, 250.0);
  for (const Camera& c : {camera, Bent(camera)}) {
    const SilhouetteRaster raster(c, cloth.mesh.triangles);
    BitMask whole, torn, none;
    raster.Draw(cloth.x, &whole);
    Eigen::VectorXd x = cloth.x;
    x[4] = std::numeric_limits<double>::quiet_NaN();
    x[31] = std::numeric_limits<double>::infinity();
    raster.Draw(x, &torn);
    EXPECT_GT(torn.Count(), 0);
    EXPECT_LE(torn.Count(), whole.Count());
    raster.Draw(Eigen::VectorXd::Constant(x.size(), x[4]), &none);
    EXPECT_EQ(none.Count(), 0);
  }
}

TEST(BitMask, IsTheSameAsAPicture) {
  cv::RNG random(3);
  for (const int width : {1, 63, 64, 65, 200}) {
    cv::Mat a(7, width, CV_8UC1), b(7, width, CV_8UC1);
    random.fill(a, cv::RNG::UNIFORM, 0, 2);
    random.fill(b, cv::RNG::UNIFORM, 0, 2);
    const BitMask mask(a);
    EXPECT_EQ(mask.Count(), cv::countNonZero(a));
    EXPECT_EQ(CountDifferences(mask, BitMask(b)), cv::countNonZero(a != b));
    EXPECT_EQ(cv::countNonZero(mask.ToMat() != 255 * a), 0);
  }
}

TEST(BitMask, SetsSpans) {
  for (const auto& [first, last] : std::vector<std::pair<int, int>>{
           {0, 0}, {0, 63}, {63, 64}, {5, 20}, {64, 127}, {60, 199}, {0, 199}, {199, 199}}) {
    BitMask mask(200, 3);
    mask.SetSpan(1, first, last);
    EXPECT_EQ(mask.Count(), last - first + 1);
    for (int x = 0; x < 200; ++x) {
      EXPECT_EQ(mask.At(x, 1), x >= first && x <= last);
      EXPECT_FALSE(mask.At(x, 0));
    }
    mask.Clear();
    EXPECT_EQ(mask.Count(), 0);
  }
  BitMask mask(200, 3);
  mask.SetSpan(2, 10, 10);
  EXPECT_TRUE(mask.AtPoint(10.4, 1.6));
  EXPECT_FALSE(mask.AtPoint(10.6, 2.0));
  EXPECT_FALSE(mask.AtPoint(-3.0, 2.0));
  EXPECT_FALSE(mask.AtPoint(std::numeric_limits<double>::quiet_NaN(), 2.0));
}

}  // namespace
}  // namespace clothfit
