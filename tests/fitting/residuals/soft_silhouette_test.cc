// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/soft_silhouette.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/crumpled_cloth.h"
#include "tests/support/flat_scene.h"

namespace clothfit {
namespace {

using Residuals = std::vector<SoftSilhouette::Residual>;

Camera Aside() { return LookAt({0.1, -0.7, 0.9}, {0.4, 0.3, 0.0}, 250.0); }

SilhouetteObservation Measure(const Camera& camera, const CrumpledCloth& cloth) {
  BitMask mask;
  SilhouetteRaster(camera, cloth.mesh.triangles).Draw(cloth.x, &mask);
  return MakeSilhouette(0, 0, mask.ToMat());
}

Residuals Evaluate(const SoftSilhouette& soft, const SilhouetteObservation& measured,
                   const Eigen::VectorXd& x) {
  Residuals residuals;
  EXPECT_TRUE(soft.Evaluate(measured, x, &residuals));
  EXPECT_EQ(static_cast<int>(residuals.size()), soft.Count(measured));
  return residuals;
}

// px: root of the mean square over the points of the outline.
double Error(const Residuals& residuals, const SilhouetteObservation& measured) {
  double sum = 0.0;
  for (const SoftSilhouette::Residual& r : residuals) sum += r.value * r.value;
  return std::sqrt(sum / static_cast<double>(measured.outline.size()));
}

Eigen::VectorXd Moved(const Eigen::VectorXd& x, const Eigen::Vector3d& by) {
  Eigen::VectorXd moved = x;
  for (Eigen::Index i = 0; i < x.size(); i += 3) moved.segment<3>(i) += by;
  return moved;
}

TEST(SoftSilhouette, IsZeroAtTheTruthAndInPixelsBesideIt) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const CrumpledCloth cloth = Crumple(seed);
    const Camera camera = Aside();
    const SilhouetteObservation measured = Measure(camera, cloth);
    const SoftSilhouette soft(camera, cloth.mesh);
    const double at_truth = Error(Evaluate(soft, measured, cloth.x), measured);
    EXPECT_LT(at_truth, 0.35);  // what pixels are to an outline
    // Parallel to the picture, so that every point moves by about 250 / 1.2 px a metre: on the
    // average over an outline's directions the distance is 1 / sqrt(2) of it.
    const Eigen::Vector3d right = camera.camera_from_world_rotation.row(0);
    const double shifted = Error(Evaluate(soft, measured, Moved(cloth.x, 0.03 * right)), measured);
    EXPECT_GT(shifted, 2.0);
    EXPECT_LT(shifted, 8.0);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double by : {-0.02, 0.02}) {
        const Eigen::VectorXd x = Moved(cloth.x, by * Eigen::Vector3d::Unit(axis));
        EXPECT_GT(Error(Evaluate(soft, measured, x), measured), 2.0 * at_truth);
      }
    }
  }
}

// Every residual against central differences, at generic places near and far from the truth.
TEST(SoftSilhouette, HasTheGradientOfItsValue) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int compared = 0, jumped = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const CrumpledCloth cloth = Crumple(seed);
    Camera camera = Aside();
    if (seed == 3) camera.distortion = {-0.2, 0.05, 0.002, -0.001, 0.01};
    const SilhouetteObservation measured = Measure(camera, cloth);
    const SoftSilhouette soft(camera, cloth.mesh);
    for (const double off : {0.001, 0.03}) {
      Eigen::VectorXd x = cloth.x, along = cloth.x;
      for (double& value : x) value += off * normal(random);
      for (double& value : along) value = normal(random);
      constexpr double kStep = 1e-6;
      const Residuals here = Evaluate(soft, measured, x);
      const Residuals before = Evaluate(soft, measured, x - kStep * along);
      const Residuals after = Evaluate(soft, measured, x + kStep * along);
      for (std::size_t i = 0; i < here.size(); ++i) {
        const double slope = here[i].slope * here[i].point.At(along);
        const double difference = (after[i].value - before[i].value) / (2.0 * kStep);
        ++compared;
        if (std::abs(slope - difference) > 1e-3 * (std::abs(slope) + 100.0)) ++jumped;
      }
    }
  }
  EXPECT_GT(compared, 1000);
  // Points whose nearest one changes from one part of the outline to another within the step, or
  // slides along another part that hides it.
  EXPECT_LE(jumped, compared / 100);
}

// Where it is least, the hard error is least too.
TEST(SoftSilhouette, HasItsMinimumWhereTheHardErrorHasIt) {
  const CrumpledCloth cloth = Crumple(2);
  const Camera camera = Aside();
  const SilhouetteObservation measured = Measure(camera, cloth);
  const SoftSilhouette soft(camera, cloth.mesh);
  const SilhouetteRaster raster(camera, cloth.mesh.triangles);
  for (int axis = 0; axis < 3; ++axis) {
    double best_soft = 0.0, best_hard = 0.0;
    double least_soft = std::numeric_limits<double>::infinity(), least_hard = least_soft;
    for (int step = -15; step <= 15; ++step) {
      const double by = 0.001 * step;  // m, about 0.2 px
      const Eigen::VectorXd x = Moved(cloth.x, by * Eigen::Vector3d::Unit(axis));
      BitMask mask;
      raster.Draw(x, &mask);
      const auto hard = static_cast<double>(CountDifferences(mask, measured.mask));
      const double error = Error(Evaluate(soft, measured, x), measured);
      if (error < least_soft) {
        least_soft = error;
        best_soft = by;
      }
      if (hard < least_hard) {
        least_hard = hard;
        best_hard = by;
      }
    }
    EXPECT_NEAR(best_hard, 0.0, 1e-9);
    EXPECT_NEAR(best_soft, best_hard, 0.0025);
  }
}

// A part of the cloth is missing in the one or in the other.
TEST(SoftSilhouette, SeesHolesAndFlaps) {
  const CrumpledCloth whole = Crumple(4, 0.02);
  CrumpledCloth holed = whole;
  for (auto t = holed.mesh.triangles.begin(); t != holed.mesh.triangles.end();) {
    const Eigen::Vector2d middle =
        (whole.mesh.uv[(*t)[0]] + whole.mesh.uv[(*t)[1]] + whole.mesh.uv[(*t)[2]]) / 3.0;
    const bool cut = (middle - Eigen::Vector2d(0.4, 0.3)).lpNorm<Eigen::Infinity>() < 0.12;
    t = cut ? holed.mesh.triangles.erase(t) : t + 1;
  }
  const Camera camera = Aside();
  const SilhouetteObservation measured_whole = Measure(camera, whole);
  const SilhouetteObservation measured_holed = Measure(camera, holed);
  ASSERT_GT(CountDifferences(measured_whole.mask, measured_holed.mask), 500);
  // The simulated cloth covers the hole that is measured: the hole's outline is not reached, and
  // particles lie in it.
  const SoftSilhouette with_whole(camera, whole.mesh);
  EXPECT_LT(Error(Evaluate(with_whole, measured_whole, whole.x), measured_whole), 0.35);
  EXPECT_GT(Error(Evaluate(with_whole, measured_holed, whole.x), measured_holed), 5.0);
  // Folded over, the simulated cloth lies within the measured silhouette, so that particles alone
  // would see nothing amiss; the outline of the half that is missing is not reached.
  Eigen::VectorXd half = whole.x;
  for (int i = 0; i < whole.mesh.num_particles(); ++i) {
    double& x = half[3 * i];
    if (x > 0.4) x = 0.8 - x;
  }
  EXPECT_GT(Error(Evaluate(with_whole, measured_whole, half), measured_whole), 15.0);
}

TEST(SoftSilhouette, IsNoneWhereThereIsNothingToSee) {
  const CrumpledCloth cloth = Crumple(1);
  const Camera camera = Aside();
  const SilhouetteObservation measured = Measure(camera, cloth);
  const SoftSilhouette soft(camera, cloth.mesh);
  Residuals residuals;
  const Eigen::Vector3d back = -camera.camera_from_world_rotation.row(2);
  EXPECT_FALSE(soft.Evaluate(measured, Moved(cloth.x, 5.0 * back), &residuals));
  Eigen::VectorXd torn = cloth.x;
  torn[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(soft.Evaluate(measured, torn, &residuals));
  // Beside the picture it still knows where to go.
  const Eigen::Vector3d right = camera.camera_from_world_rotation.row(0);
  const Residuals beside = Evaluate(soft, measured, Moved(cloth.x, 2.0 * right));
  double by_right = 0.0;
  for (const SoftSilhouette::Residual& r : beside) by_right += r.value * r.slope * right;
  EXPECT_GT(by_right, 0.0);
}

}  // namespace
}  // namespace clothfit
