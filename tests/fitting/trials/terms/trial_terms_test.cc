// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The terms of trials keep the contract of autodiff_sim/term/term.h, as clothfit's own do.
#include "fitting/trials/terms/trial_terms.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/base/gradient_check.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

double Largest(const Eigen::VectorXd& values) { return values.lpNorm<Eigen::Infinity>(); }

// Calls check(element, numbers, scene) for some elements of every scene at random parameters, or
// with those that switch the term at off.
template <class Term, class Check>
int ForEachSample(bool is_off, const Check& check) {
  int count = 0;
  std::mt19937 random(7);
  for (const TermScene& scene : MakeTermScenes()) {
    const auto elements = SceneElements<Term>(scene);
    for (int sample = 0; sample < 10 && !elements.empty(); ++sample) {
      const auto& element = elements[random() % elements.size()];
      const Eigen::VectorXd parameters =
          is_off ? OffParameters<Term>(scene, &random) : RandomParameters<Term>(scene, &random);
      SCOPED_TRACE(scene.name);
      check(element, ElementNumbers<Term>(element, scene, parameters), scene);
      ++count;
    }
  }
  return count;
}

// A first step of differences: small beside an edge of 2 cm, else a hundredth of the number.
template <class Term>
double FirstStep(const TermScene& scene, const Eigen::VectorXd& numbers, int column) {
  using Layout = TermLayout<Term>;
  if (column < Layout::kV) return 1e-5;
  if (column < Layout::kParameter) return 1e-2 * scene.speed;
  if (column < Layout::kDensity &&
      Term::kParameters[column - Layout::kParameter].meaning != Meaning::kNumber)
    return 1e-4;
  return 1e-2 * std::max(std::abs(numbers[column]), 1e-3);
}

template <class Term>
class TrialTerm : public ::testing::Test {};
using TrialTermTypes = ::testing::Types<Vortex, DiagonalThread, StickyPoint>;
TYPED_TEST_SUITE(TrialTerm, TrialTermTypes);

TYPED_TEST(TrialTerm, JetsAgreeWithDifferences) {
  using Layout = TermLayout<TypeParam>;
  Eigen::VectorXd seen = Eigen::VectorXd::Zero(Layout::kSize);
  const int count = ForEachSample<TypeParam>(
      false, [&](const auto& element, const Eigen::VectorXd& numbers, const TermScene& scene) {
        // A term that is the difference of two forces is known to their roundoff only, see
        // force_term_test.cc.
        const double cancelling = TypeParam::kReads.size() > 0 ? 1e-4 : 0.0;
        const double size =
            std::max(Largest(EvaluateTerm<TypeParam, double>(element, numbers)), cancelling);
        for (int column = 0; column < Layout::kSize; ++column) {
          const double step = FirstStep<TypeParam>(scene, numbers, column);
          GradientCheckOptions options;
          options.tolerance = 1e-6;
          options.max_steps = 12;
          options.floor = std::max(1e-300, 1e-8 * size / step);  // roundoff of f over the step
          const Difference difference = RiddersDifference(
              [&](double s, Eigen::VectorXd* f) {
                Eigen::VectorXd moved = numbers;
                moved[column] += s;
                *f = EvaluateTerm<TypeParam, double>(element, moved);
                return true;
              },
              step, options);
          const Eigen::VectorXd jet = DifferentiateTerm<TypeParam>(element, numbers, column);
          const double scale = std::max(Largest(difference.derivative), options.floor);
          EXPECT_LE(Largest(jet - difference.derivative), 1e-6 * scale) << "column " << column;
          if (Largest(difference.derivative) > options.floor) seen[column] += 1.0;
        }
      });
  EXPECT_GE(count, 60);
  for (int i = Layout::kParameter; i < Layout::kDensity; ++i)
    EXPECT_GT(seen[i], 0.0) << TypeParam::kParameters[i - Layout::kParameter].name;
}

TYPED_TEST(TrialTerm, AddsNothingWhenOff) {
  const int count = ForEachSample<TypeParam>(
      true, [](const auto& element, const Eigen::VectorXd& numbers, const TermScene&) {
        EXPECT_EQ(Largest(EvaluateTerm<TypeParam, double>(element, numbers)), 0.0);
      });
  EXPECT_GE(count, 60);
}

TYPED_TEST(TrialTerm, InternalForcesAloneBalance) {
  int unbalanced = 0;
  ForEachSample<TypeParam>(
      false, [&](const auto& element, const Eigen::VectorXd& numbers, const TermScene&) {
        const Eigen::VectorXd force = EvaluateTerm<TypeParam, double>(element, numbers);
        Eigen::Vector3d net = Eigen::Vector3d::Zero(), moment = net;
        for (int n = 0; n < TypeParam::kNodes; ++n) {
          const Eigen::Vector3d f = force.segment<3>(3 * n), x = numbers.segment<3>(3 * n);
          net += f;
          moment += x.cross(f);
        }
        // Some hundred operations' roundoff of the largest force; arms are below 1 m.
        const double roundoff = 1e-13 * Largest(force);
        if (Largest(net) > roundoff || Largest(moment) > roundoff) ++unbalanced;
      });
  EXPECT_EQ(unbalanced == 0, TypeParam::kInternal);
}

TEST(DiagonalThread, RunsFromCornerToCorner) {
  for (const std::array<int, 2>& count : {std::array<int, 2>{6, 6}, std::array<int, 2>{4, 9}}) {
    const ClothMesh mesh = MakeGrid({0.3, 0.5}, count);
    const std::vector<ThreadPiece> pieces = DiagonalThreadPieces(mesh);
    ASSERT_FALSE(pieces.empty());
    EXPECT_EQ(pieces.front().nodes[0], 0);
    EXPECT_EQ(pieces.back().nodes[1], mesh.num_particles() - 1);
    for (std::size_t i = 1; i < pieces.size(); ++i)
      EXPECT_EQ(pieces[i - 1].nodes[1], pieces[i].nodes[0]);
    for (const ThreadPiece& piece : pieces) EXPECT_GT(piece.length, 0.0);
  }
}

// As it says in vortex.h: the air is fastest at the core's radius and goes round anticlockwise.
TEST(Vortex, GoesRoundItsAxis) {
  using Layout = TermLayout<Vortex>;
  const auto force_at = [](double radius) {
    // A triangle in the plane y = 0, whose normal is along y, at x = radius.
    Eigen::VectorXd numbers = Eigen::VectorXd::Zero(Layout::kSize);
    const Eigen::Vector3d middle(radius, 0.0, 0.0);
    numbers.segment<3>(0) = middle + Eigen::Vector3d(-1e-3, 0.0, -1e-3);
    numbers.segment<3>(3) = middle + Eigen::Vector3d(1e-3, 0.0, -1e-3);
    numbers.segment<3>(6) = middle + Eigen::Vector3d(0.0, 0.0, 2e-3);
    numbers[Layout::kParameter] = 1.0;      // m/s
    numbers[Layout::kParameter + 3] = 0.2;  // m, the core
    numbers[Layout::kRead] = 0.5;           // kg/m^3
    const Eigen::VectorXd force = EvaluateTerm<Vortex, double>({{0, 1, 2}}, numbers);
    EXPECT_NEAR(force[0], 0.0, 1e-12);  // along the normal only
    return force[1];
  };
  EXPECT_GT(force_at(0.2), 0.0);
  EXPECT_LT(force_at(-0.2), 0.0);
  EXPECT_GT(force_at(0.2), force_at(0.15));
  EXPECT_GT(force_at(0.2), force_at(0.25));
  // A third of 3e-6 m^2 times 0.5 kg/m^3 times (1 m/s)^2, without saturation.
  EXPECT_NEAR(force_at(0.2), 3e-6 * 0.5 / 3.0, 1e-12);
}

TEST(StickyPoint, DrawsAndSlowsDown) {
  using Layout = TermLayout<StickyPoint>;
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(Layout::kSize);
  numbers[0] = 0.03;                       // m, along x from the place
  numbers[Layout::kParameter] = 2.0;       // Pa
  numbers[Layout::kParameter + 5] = 0.05;  // m
  AreaElement element{{0}, 1e-4};
  EXPECT_LT((EvaluateTerm<StickyPoint, double>(element, numbers)[0]), 0.0);
  numbers[Layout::kParameter] = 0.0;
  numbers[Layout::kParameter + 1] = 3.0;  // Pa s/m
  numbers[0] = 0.0;
  numbers[Layout::kV + 1] = 0.5;  // m/s
  EXPECT_NEAR((EvaluateTerm<StickyPoint, double>(element, numbers)[1]), -3.0 * 0.5 * 1e-4, 1e-15);
}

}  // namespace
}  // namespace clothfit
