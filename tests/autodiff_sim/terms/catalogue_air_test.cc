// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Wind and gusts against the air drag in air that moves.
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

const Eigen::Vector3d kWind(0.7, -0.4, 0.2);  // m/s

double InitialDrag(int i) { return InitialValue(UniformWind::kReads[i]); }

// The air drag on an element at its initial coefficients, in air that moves.
Eigen::VectorXd DragInMovingAir(const AirDrag::Element& element, TermScene scene,
                                const Eigen::Vector3d& air) {
  for (int i = 0; i < scene.mesh.num_particles(); ++i) scene.v.segment<3>(3 * i) -= air;
  return EvaluateTerm<AirDrag, double>(
      element, ElementNumbers<AirDrag>(element, scene,
                                       Numbers({InitialDrag(0), InitialDrag(1), InitialDrag(2)})));
}

// Drag and wind together are the drag that an observer who moves with the air sees.
TEST(WindPhysics, IsDragInMovingAir) {
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<UniformWind>(scene)) {
      const Eigen::VectorXd wind = EvaluateTerm<UniformWind, double>(
          element, ElementNumbers<UniformWind>(element, scene, kWind));
      const Eigen::VectorXd still = DragInMovingAir(element, scene, Eigen::Vector3d::Zero());
      const Eigen::VectorXd moving = DragInMovingAir(element, scene, kWind);
      EXPECT_LE((still + wind - moving).norm(), 1e-13 * (still.norm() + moving.norm()));
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

// Gust's numbers: peak kWind at the middle of the cloth and everywhere else the same.
Eigen::VectorXd EvenGust(double onset, double duration) {
  return Numbers({kWind.x(), kWind.y(), kWind.z(), onset, duration, 0.03, 0.03, 1e9});
}

TEST(GustPhysics, IsWindOfItsStrengthAtTheTime) {
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    const auto elements = SceneElements<Gust>(scene);
    for (const auto& element : elements) {
      const auto force = [&](double onset, double duration) {
        return EvaluateTerm<Gust, double>(
            element, ElementNumbers<Gust>(element, scene, EvenGust(onset, duration)));
      };
      const auto wind = [&](double share) {
        return EvaluateTerm<UniformWind, double>(
            {element.nodes}, ElementNumbers<UniformWind>({element.nodes}, scene, share * kWind));
      };
      const double size = wind(1.0).norm();
      // Half way, a quarter of the way, before and after.
      EXPECT_LE((force(kSampleTime - 0.1, 0.2) - wind(1.0)).norm(), 1e-12 * size);
      EXPECT_LE((force(kSampleTime - 0.1, 0.4) - wind(0.5)).norm(), 1e-12 * size);
      EXPECT_EQ(force(kSampleTime + 0.01, 0.2).norm(), 0.0);
      EXPECT_EQ(force(kSampleTime - 0.3, 0.2).norm(), 0.0);
      // It sets in with no slope: sin^2 of pi times a thousandth.
      EXPECT_LE(force(kSampleTime - 2e-4, 0.2).norm(), 1e-4 * size);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

TEST(GustPhysics, FallsOffAroundItsPlace) {
  const TermScene scene = MakeTermScenes().front();
  const auto elements = SceneElements<Gust>(scene);
  Eigen::VectorXd parameters = EvenGust(kSampleTime - 0.1, 0.2);
  for (const auto& element : elements) {
    // At one radius from the place.
    parameters.segment<3>(5) << element.uv.x() + 0.03, element.uv.y() - 0.04, 0.05;
    const Eigen::VectorXd force =
        EvaluateTerm<Gust, double>(element, ElementNumbers<Gust>(element, scene, parameters));
    const Eigen::VectorXd expected = EvaluateTerm<UniformWind, double>(
        {element.nodes},
        ElementNumbers<UniformWind>({element.nodes}, scene, std::exp(-0.5) * kWind));
    EXPECT_LE((force - expected).norm(), 1e-12 * expected.norm());
  }
  EXPECT_GT(elements.size(), 10u);
}

}  // namespace
}  // namespace clothfit
