// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A term's force against the energy that it comes from.
#pragma once

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "autodiff_sim/base/gradient_check.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {

// Checks f = -dE/dx at zero velocity over all scenes. energy(element, numbers) in joules.
template <class Term, class Energy>
void ExpectForceOfEnergy(const Eigen::VectorXd& parameters, const Energy& energy,
                         const std::vector<TermScene>& scenes = MakeTermScenes(),
                         double tolerance = 1e-7) {
  using Layout = TermLayout<Term>;
  int acting = 0;
  for (TermScene scene : scenes) {
    SCOPED_TRACE(scene.name);
    scene.v.setZero();
    for (const auto& element : SceneElements<Term>(scene)) {
      const Eigen::VectorXd numbers = ElementNumbers<Term>(element, scene, parameters);
      const Eigen::VectorXd force = EvaluateTerm<Term, double>(element, numbers);
      const double largest = force.lpNorm<Eigen::Infinity>();
      for (int i = 0; i < Layout::kForces; ++i) {
        GradientCheckOptions options;
        options.tolerance = 1e-7;
        options.max_steps = 12;
        const Difference d = RiddersDifference(
            [&](double s, Eigen::VectorXd* f) {
              Eigen::VectorXd moved = numbers;
              moved[i] += s;
              *f = Eigen::VectorXd::Constant(1, energy(element, moved));
              return true;
            },
            1e-4, options);
        // The energies' roundoff, up to 1e-16 J over a step of 1e-6 m.
        EXPECT_NEAR(force[i], -d.derivative[0], tolerance * largest + 1e-10);
      }
      if (largest > 1e-6) ++acting;
    }
  }
  EXPECT_GT(acting, 10);
}

// The same with the energy that the term itself gives.
template <class Term>
void ExpectForceOfEnergy(const Eigen::VectorXd& parameters,
                         const std::vector<TermScene>& scenes = MakeTermScenes(),
                         double tolerance = 1e-7) {
  ExpectForceOfEnergy<Term>(
      parameters,
      [](const auto& element, const Eigen::VectorXd& numbers) {
        return Term::Energy(element, MakeElementInput<Term, double>(numbers));
      },
      scenes, tolerance);
}

template <int kNode>
Eigen::Vector3d Node(const Eigen::VectorXd& numbers) {
  return numbers.segment<3>(3 * kNode);
}

}  // namespace clothfit
