// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Friction and relaxation against what is known of their laws.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

// z after the path through these places (over the onset), each stretch in `steps` steps; work gets
// the sum of z ds, by the mean of each step.
double Follow(const std::vector<double>& places, int steps, double z, double* work) {
  double at = 0.0;
  *work = 0.0;
  for (const double place : places) {
    const double slide = (place - at) / steps;
    for (int i = 0; i < steps; ++i) {
      const double before = z;
      z = SlideFriction<double>(z, slide);
      *work += 0.5 * (z + before) * slide;
    }
    at = place;
  }
  return z;
}

TEST(DahlFriction, DependsOnThePathAndNotOnItsSteps) {
  double work = 0.0;
  const std::vector<double> path = {1.3, -0.4, 0.2, 0.1, 3.0, -2.0};
  const double once = Follow(path, 1, 0.2, &work);
  EXPECT_NEAR(Follow(path, 1000, 0.2, &work), once, 1e-12);
}

TEST(DahlFriction, IsElasticAtFirstAndThenLimited) {
  EXPECT_NEAR(SlideFriction<double>(0.0, 1e-6), 1e-6, 1e-12);
  EXPECT_NEAR(SlideFriction<double>(0.0, -1e-6), -1e-6, 1e-12);
  EXPECT_NEAR(SlideFriction<double>(0.0, 40.0), 1.0, 1e-15);
  EXPECT_NEAR(SlideFriction<double>(0.5, -40.0), -1.0, 1e-15);
  EXPECT_EQ(SlideFriction<double>(0.3, 0.0), 0.3);
}

// A loop to and fro by 2 a, far beyond the onset c, costs twice 2 a - 2 c (1 - exp(-2 a / c)), the
// integral of 1 - 2 exp(-s / c) on either way (limit 1).
TEST(DahlFriction, LoopTakesItsArea) {
  const double a = 10.0;
  // From a to -a and back, in steps fine enough for the mean of each: 1e-3 squared, over 12.
  double z = 1.0, total = 0.0, work = 0.0;
  for (const double way : {-2.0 * a, 2.0 * a}) {
    z = Follow({way}, 20000, z, &work);
    total += work;
  }
  const double expected = 2.0 * (2.0 * a - 2.0 * (1.0 - std::exp(-2.0 * a)));
  EXPECT_NEAR(total, expected, 1e-6);
  EXPECT_NEAR(z, 1.0, 1e-8);
}

// Two triangles of a strip, the second turned about their edge by an angle.
Eigen::Matrix<double, 3, 4> Folded(double angle) {
  Eigen::Matrix<double, 3, 4> x;
  x.col(0) << -0.02, 0.01, 0.0;
  x.col(1) << 0.02 * std::cos(angle), 0.01, 0.02 * std::sin(angle);
  x.col(2) << 0.0, 0.02, 0.0;
  x.col(3) << 0.0, 0.0, 0.0;
  return x;
}
const Hinge kHinge = {{0, 1, 2, 3}, 0.02 / (0.02 + 0.02), 0.02};

// Numbers of a hinge that is turned from one angle to another, the rest zero.
template <class Term>
Eigen::VectorXd HingeNumbers(double from, double to, const Eigen::VectorXd& parameters,
                             double memory) {
  using Layout = TermLayout<Term>;
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(Layout::kSize);
  const Eigen::Matrix<double, 3, 4> x = Folded(to), start = Folded(from);
  numbers.head<12>() = Eigen::Map<const Eigen::VectorXd>(x.data(), 12);
  numbers.segment<12>(Layout::kStart) = Eigen::Map<const Eigen::VectorXd>(start.data(), 12);
  numbers.segment(Layout::kParameter, parameters.size()) = parameters;
  numbers[Layout::kMemory] = memory;
  return numbers;
}

// The moment about the edge on the second triangle's tip, 0.02 m from it, along the way it turns.
double MomentOnTip(const Eigen::VectorXd& outputs, double angle) {
  const Eigen::Vector3d turning(-std::sin(angle), 0.0, std::cos(angle));
  return 0.02 * outputs.segment<3>(3).dot(turning);
}

TEST(BendingFriction, ResistsWithItsLimitTimesTheWidth) {
  for (const double sign : {1.0, -1.0}) {
    const double angle = sign * 0.5;  // curvature 25 1/m, far beyond an onset of 0.5 1/m
    const Eigen::VectorXd outputs = EvaluateTerm<BendingFriction, double>(
        kHinge, HingeNumbers<BendingFriction>(0.0, angle, Numbers({1e-3, 0.5}), 0.0));
    EXPECT_NEAR(MomentOnTip(outputs, angle), -sign * 1e-3 * 0.02, 1e-15);
  }
}

TEST(BendingFriction, BuildsUpOverTheCurvature) {
  const double angle = 0.05;  // over a mean height of 0.02 m
  const Eigen::VectorXd outputs = EvaluateTerm<BendingFriction, double>(
      kHinge, HingeNumbers<BendingFriction>(0.0, angle, Numbers({1e-3, 4.0}), 0.0));
  const double expected = 1.0 - std::exp(-angle / 0.02 / 4.0);
  EXPECT_NEAR(std::abs(outputs[12]), expected, 1e-12);
  EXPECT_NEAR(MomentOnTip(outputs, angle), -expected * 1e-3 * 0.02, 1e-15);
}

// A cloth that turns and moves as a whole remembers what it did.
template <class Term>
void ExpectRigidMotionIsForgotten() {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  std::mt19937 random(5);
  int count = 0;
  for (TermScene scene : MakeTermScenes()) {
    for (int i = 0; i < scene.mesh.num_particles(); ++i) {
      scene.start.segment<3>(3 * i) =
          rotation * scene.x.segment<3>(3 * i) + Eigen::Vector3d(0.3, 0.1, -0.2);
    }
    for (const auto& element : SceneElements<Term>(scene)) {
      Eigen::VectorXd numbers =
          ElementNumbers<Term>(element, scene, RandomParameters<Term>(scene, &random));
      numbers[TermLayout<Term>::kMemory] = 0.0;
      const Eigen::VectorXd outputs = EvaluateTerm<Term, double>(element, numbers);
      // Roundoff of positions, 1e-16 m, over an onset of down to 1e-4 of an edge of 2 cm.
      EXPECT_NEAR(outputs[TermLayout<Term>::kForces], 0.0, 1e-10);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

TEST(MemoryTerms, ForgetRigidMotion) {
  ExpectRigidMotionIsForgotten<BendingFriction>();
  ExpectRigidMotionIsForgotten<ShearFriction>();
  ExpectRigidMotionIsForgotten<StretchRelaxation>();
  ExpectRigidMotionIsForgotten<ShearRelaxation>();
  ExpectRigidMotionIsForgotten<BendingRelaxation>();
}

// A sheared square, its two triangles together: the stress is a force per width of its sides.
TEST(ShearFriction, ResistsWithItsStressTimesTheWidth) {
  const ClothMesh mesh = MakeGrid({0.02, 0.02}, {2, 2});
  const double shear = 0.1, stress = 0.7;
  double along_u = 0.0;  // of the force on the side v = 0.02 m, which is moved along u
  for (const ShearTriangle& triangle : ShearTriangles(mesh)) {
    using Layout = TermLayout<ShearFriction>;
    Eigen::VectorXd numbers = Eigen::VectorXd::Zero(Layout::kSize);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d uv = mesh.uv[triangle.nodes[i]];
      numbers.segment<3>(Layout::kStart + 3 * i) << uv, 0.0;
      numbers.segment<3>(3 * i) << uv.x() + shear * uv.y(), uv.y(), 0.0;
    }
    numbers.segment<2>(Layout::kParameter) << stress, 1e-3;
    EXPECT_NEAR(ShearStrain<double>(triangle, {numbers.segment<3>(0), numbers.segment<3>(3),
                                               numbers.segment<3>(6)}),
                shear, 1e-15);
    const Eigen::VectorXd outputs = EvaluateTerm<ShearFriction, double>(triangle, numbers);
    for (int i = 0; i < 3; ++i) {
      if (mesh.uv[triangle.nodes[i]].y() > 0.01) along_u += outputs[3 * i];
    }
  }
  EXPECT_NEAR(along_u, -stress * 0.02, 1e-12);
}

TEST(Relaxation, StepsOfAnySizeAgreeOnAnEvenStrain) {
  const double once = RelaxStrain<double>(0.3, 0.5, 2.0);
  double q = 0.3;
  for (int i = 0; i < 1000; ++i) q = RelaxStrain<double>(q, 0.5 / 1000.0, 2.0 / 1000.0);
  EXPECT_NEAR(q, once, 1e-12);
  // The solution of dq/dt = rate - q / tau.
  EXPECT_NEAR(once, 0.3 * std::exp(-2.0) + 0.25 * (1.0 - std::exp(-2.0)), 1e-15);
  // Held still, it decays.
  EXPECT_NEAR(RelaxStrain<double>(0.3, 0.0, 0.7), 0.3 * std::exp(-0.7), 1e-16);
  // The series and the formula meet.
  EXPECT_NEAR(RelaxStrain<double>(0.0, 1.0, 0.00999999), RelaxStrain<double>(0.0, 1.0, 0.01000001),
              2e-8);
}

// What has had no time to relax is a spring of the share of the modulus.
TEST(Relaxation, IsASpringAtFirst) {
  const Spring spring = {{0, 1}, 0.02, 0.8, 1.0};
  using Layout = TermLayout<StretchRelaxation>;
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(Layout::kSize);
  numbers[3] = 0.021;
  numbers[Layout::kStart + 3] = 0.02;
  numbers.segment<2>(Layout::kParameter) << 0.3, 1e9;
  numbers[Layout::kRead] = 500.0;
  const Eigen::VectorXd outputs = EvaluateTerm<StretchRelaxation, double>(spring, numbers);
  EXPECT_NEAR(outputs[0], 0.3 * 500.0 * 0.8 * 0.001, 1e-12);

  Eigen::VectorXd hinge = HingeNumbers<BendingRelaxation>(0.0, 0.4, Numbers({0.3, 1e9}), 0.0);
  hinge[TermLayout<BendingRelaxation>::kRead] = 1e-3;
  Eigen::VectorXd elastic = Eigen::VectorXd::Zero(TermLayout<Bending>::kSize);
  elastic.head<12>() = hinge.head<12>();
  elastic[TermLayout<Bending>::kParameter] = 0.3 * 1e-3;
  const Eigen::VectorXd relaxing = EvaluateTerm<BendingRelaxation, double>(kHinge, hinge);
  const Eigen::VectorXd expected = EvaluateTerm<Bending, double>(kHinge, elastic);
  EXPECT_LE((relaxing.head<12>() - expected).norm(), 1e-9 * expected.norm());
}

}  // namespace
}  // namespace clothfit
