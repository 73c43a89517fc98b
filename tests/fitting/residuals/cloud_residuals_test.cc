// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/cloud_residuals.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "fitting/scene/scene.h"
#include "tests/support/crumpled_cloth.h"
#include "tests/support/flat_scene.h"

namespace clothfit {
namespace {

using Eigen::Vector3d;

Scene SceneOf(const CrumpledCloth& cloth) {
  Scene scene;
  scene.mesh = cloth.mesh;
  scene.initial = cloth.x;
  return scene;
}

// Points near the surface and beyond its edges, every 40 mm or so.
CloudObservation CloudOf(const CrumpledCloth& cloth, double off, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  CloudObservation cloud;
  cloud.spacing = 0.02;
  for (const auto& [a, b, c] : cloth.mesh.triangles) {
    const Vector3d middle =
        (cloth.x.segment<3>(3 * a) + cloth.x.segment<3>(3 * b) + cloth.x.segment<3>(3 * c)) / 3.0;
    Vector3d noise;
    for (double& value : noise.reverse()) value = normal(random);
    cloud.points.push_back(middle + off * noise);
  }
  return cloud;
}

std::vector<PointResidual> Evaluate(const CloudResiduals& residuals, const CloudObservation& cloud,
                                    const Eigen::VectorXd& x) {
  std::vector<PointResidual> all;
  residuals.Evaluate(cloud, x, &all);
  EXPECT_EQ(static_cast<int>(all.size()), residuals.Count(cloud));
  return all;
}

TEST(CloudResiduals, AreZeroOnTheSurface) {
  const CrumpledCloth cloth = Crumple(1);
  const Scene scene = SceneOf(cloth);
  const CloudResiduals residuals(scene, 1.0);
  const CloudObservation cloud = CloudOf(cloth, 0.0, 1);
  const std::vector<PointResidual> all = Evaluate(residuals, cloud, cloth.x);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    EXPECT_LT(std::abs(all[i].value), 1e-15);
    EXPECT_NEAR(all[i].slope.norm(), 1.0, 1e-12);  // which it would have, either way
  }
}

// Every residual against central differences, at generic places near and far from the cloud.
TEST(CloudResiduals, HaveTheGradientOfTheirValues) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int of_points = 0, of_particles = 0, jumped = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const CrumpledCloth cloth = Crumple(seed);
    const Scene scene = SceneOf(cloth);
    const CloudResiduals residuals(scene, 0.7);
    CloudObservation cloud = CloudOf(cloth, 0.03, seed);
    cloud.points.resize(cloud.points.size() / 2);  // half of the cloth has none near
    for (const double off : {0.001, 0.03}) {
      Eigen::VectorXd x = cloth.x, along = cloth.x;
      for (double& value : x) value += off * normal(random);
      for (double& value : along) value = normal(random);
      constexpr double kStep = 1e-7;
      const std::vector<PointResidual> here = Evaluate(residuals, cloud, x);
      const std::vector<PointResidual> before = Evaluate(residuals, cloud, x - kStep * along);
      const std::vector<PointResidual> after = Evaluate(residuals, cloud, x + kStep * along);
      for (std::size_t i = 0; i < here.size(); ++i) {
        if (here[i].IsZero()) continue;
        ++(i < cloud.points.size() ? of_points : of_particles);
        const double slope = here[i].slope * here[i].point.At(along);
        // A point that comes to the edge of a triangle may change its sign, which no square sees.
        const double squares = after[i].value * after[i].value - before[i].value * before[i].value;
        const double difference = squares / (4.0 * kStep * here[i].value);
        if (std::abs(slope - difference) > 1e-5 * (1.0 + std::abs(slope))) ++jumped;
      }
    }
  }
  EXPECT_GT(of_points, 600);
  EXPECT_GT(of_particles, 200);
  // Those whose closest point changes from one part of the surface to another within the step.
  EXPECT_LE(jumped, 2);
}

TEST(CloudResiduals, PullBackWhatACloudShouldShow) {
  const FlatScene flat({0.8, 0.6});
  CrumpledCloth cloth = Crumple(1);
  for (Eigen::Index i = 2; i < cloth.x.size(); i += 3) cloth.x[i] = 0.0;
  Scene scene = SceneOf(cloth);
  CloudObservation cloud = CloudOf(cloth, 0.0, 1);
  cloud.spacing = 0.04;  // of triangles with sides of 70 mm
  Eigen::VectorXd flown = cloth.x;
  flown[2] += 0.3;  // the first particle, towards a camera that looks down
  const auto pulled = [&](double coverage) {
    const CloudResiduals residuals(scene, coverage);
    return Evaluate(residuals, cloud, flown);
  };
  const std::size_t points = cloud.points.size();
  const double weight = std::sqrt(static_cast<double>(points) / scene.mesh.num_particles());
  const PointResidual whole = pulled(1.0)[points];
  EXPECT_GT(whole.value, 0.2 * weight);
  EXPECT_GT(whole.slope.z(), 0.9 * weight);
  EXPECT_NEAR(pulled(0.25)[points].value, 0.5 * whole.value, 1e-12);
  EXPECT_EQ(pulled(0.0).size(), points);
  for (std::size_t i = points + 1; i < pulled(1.0).size(); ++i)
    EXPECT_TRUE(pulled(1.0)[i].IsZero());

  // A camera sees it before the others; from below they hide it, and beside the picture it need
  // not be seen.
  const Vector3d middle(0.4, 0.3, 0.0);
  scene.recording.cameras = {LookAt({0.4, 0.3, 2.0}, middle), LookAt({0.4, 0.3, -2.0}, middle),
                             LookAt({0.4, 0.3, 2.0}, {5.0, 0.3, 1.0})};
  flown[0] = 0.4;
  flown[1] = 0.3;
  cloud.camera = 0;
  EXPECT_FALSE(pulled(1.0)[points].IsZero());
  for (const int camera : {1, 2}) {
    cloud.camera = camera;
    EXPECT_TRUE(pulled(1.0)[points].IsZero()) << camera;
  }
}

}  // namespace
}  // namespace clothfit
