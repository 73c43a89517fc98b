// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds for every force term of the list `Terms`: a new term is tested by being listed.
// CLOTHFIT_TESTED_TERMS, where it is defined, are tested instead of all.
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "autodiff_sim/base/gradient_check.h"
#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

template <class List>
struct AsTestTypes;
template <class... Terms>
struct AsTestTypes<TypeList<Terms...>> {
  using Types = ::testing::Types<Terms...>;
};

struct TermName {
  template <class Term>
  static std::string GetName(int) {
    return Term::kName;
  }
};

// Calls check(scene, element, parameters) for elements of every scene at random parameters.
// Returns how many calls that were.
template <class Term, class Check>
int ForEachSample(const Check& check, const std::vector<TermScene>& scenes = MakeTermScenes()) {
  int count = 0;
  std::mt19937 random(7);
  for (const TermScene& scene : scenes) {
    const auto elements = SceneElements<Term>(scene);
    for (int sample = 0; sample < 40 && !elements.empty(); ++sample) {
      const std::size_t which = random() % elements.size();
      const Eigen::VectorXd parameters = RandomParameters<Term>(scene, &random);
      SCOPED_TRACE(scene.name + ", element " + std::to_string(which));
      check(scene, which, parameters);
      ++count;
    }
  }
  return count;
}

template <class Term>
class ForceTerm : public ::testing::Test {};
#ifndef CLOTHFIT_TESTED_TERMS
#define CLOTHFIT_TESTED_TERMS Terms
#endif
TYPED_TEST_SUITE(ForceTerm, AsTestTypes<CLOTHFIT_TESTED_TERMS>::Types, TermName);

template <class Derived>
double Largest(const Eigen::MatrixBase<Derived>& values) {
  return values.template lpNorm<Eigen::Infinity>();
}

// A first step for differences along one of an element's numbers, in its unit. Positions: small
// beside the smallest radius of an attraction, 0.1 mm. The others: one per cent.
template <class Term>
double FirstStep(const TermScene& scene, const Eigen::VectorXd& numbers, int column) {
  using Layout = TermLayout<Term>;
  if (column < Layout::kV) return 1e-5;
  if (column < Layout::kParameter) return 1e-2 * scene.speed;
  const auto is_number = [](Meaning m) { return m == Meaning::kNumber || m == Meaning::kTilt; };
  if (column < Layout::kDensity &&
      !is_number(Term::kParameters[column - Layout::kParameter].meaning))
    return 1e-4;  // m, m/s or s: small beside the cloth's edges
  if (column < Layout::kDensity && numbers[column] == 0.0)
    return 1e-2 * Term::kParameters[column - Layout::kParameter].prior_factor;
  if (column >= Layout::kRead) return 1e-2 * std::max(std::abs(numbers[column]), 1e-3);
  if (column >= Layout::kStart) return 1e-5;
  if (column >= Layout::kA) return 1e-2 * scene.speed;
  if (column >= Layout::kInput) return 1e-5;  // positions (m) and directions (1)
  return 1e-2 * std::abs(numbers[column]);
}

// Whether a term is a part of the force of another, whose parameters it reads.
template <class Term>
constexpr bool kIsPartOfAnother = Term::kReads.size() > 0 && Term::kRole != Role::kOrdinary;

// N: forces of which a term that adds to another's is the difference, and to whose roundoff it is
// known only.
template <class Term>
constexpr double kCancelling = kIsPartOfAnother<Term> ? 1e-4 : 0.0;
// Roundoff of a drag of 0.1 N over a step of 5e-7 m/s is 2.5e-11.
template <>
constexpr double kCancelling<LawAir> = 2e-4;
// A strain is the difference of two lengths, known to 1e-16, over triangles of some mm.
template <>
constexpr double kCancelling<LawTension> = 1e-9;

// A slip has the elements of what holds the cloth, and moves the place whatever that is.
template <class Term>
constexpr int kFirstUsed =
    std::is_same_v<Term, GripSlip> ? TermLayout<Term>::kMemory : TermLayout<Term>::kInput;

// Whether the term's force depends on ClothMesh::buckles.
template <class Term>
constexpr bool kBuckles =
    std::is_same_v<Term, StretchSpring> || std::is_same_v<Term, Shear> ||
    std::is_same_v<Term, StretchOrthotropy> || std::is_same_v<Term, ShearOrthotropy> ||
    std::is_same_v<Term, StiffPatchStretch> || std::is_same_v<Term, StiffSeamStretch>;

// Compares jets with differences whose first steps are scaled, to within a share; forces are known
// to the roundoff of `cancelling` (N). Returns in how
// many samples each number has a derivative, and writes how many samples that were.
template <class TypeParam>
Eigen::VectorXd CompareJets(const std::vector<TermScene>& scenes, double step_scale, double share,
                            double cancelling, int* count) {
  using Layout = TermLayout<TypeParam>;
  Eigen::VectorXd seen = Eigen::VectorXd::Zero(Layout::kSize);
  *count = ForEachSample<TypeParam>(
      [&](const TermScene& scene, std::size_t which, const Eigen::VectorXd& parameters) {
        const auto element = SceneElements<TypeParam>(scene)[which];
        const Eigen::VectorXd numbers = ElementNumbers<TypeParam>(element, scene, parameters);
        const double size =
            std::max(Largest(EvaluateTerm<TypeParam, double>(element, numbers)), cancelling);
        for (int column = 0; column < Layout::kSize; ++column) {
          const double step = step_scale * FirstStep<TypeParam>(scene, numbers, column);
          GradientCheckOptions options;
          options.tolerance = 1e-6;
          options.max_steps = 12;
          // Roundoff of f, 1e-15 f, over the step: derivatives that are smaller than this are
          // compared with this.
          options.floor = std::max(1e-300, 1e-8 * size / step);
          const Difference d = RiddersDifference(
              [&](double s, Eigen::VectorXd* f) {
                Eigen::VectorXd moved = numbers;
                moved[column] += s;
                *f = EvaluateTerm<TypeParam, double>(element, moved);
                return true;
              },
              step, options);
          const Eigen::VectorXd jet = DifferentiateTerm<TypeParam>(element, numbers, column);
          const double scale = std::max(Largest(d.derivative), options.floor);
          EXPECT_LE(Largest(jet - d.derivative), share * scale)
              << "column " << column << ", the difference's own error " << d.error / scale
              << ", of " << Largest(d.derivative);
          if (Largest(d.derivative) > options.floor) seen[column] += 1.0;
        }
      },
      scenes);
  return seen;
}

TYPED_TEST(ForceTerm, JetsAgreeWithDifferences) {
  using Layout = TermLayout<TypeParam>;
  int count = 0;
  Eigen::VectorXd seen =
      CompareJets<TypeParam>(MakeTermScenes(), 1.0, 1e-6, kCancelling<TypeParam>, &count);
  // Where cloth buckles below its mesh strains of 1e-5 matter, so that the steps are small and the
  // differences rough; and so does the bending stiffness.
  if constexpr (kBuckles<TypeParam>) {
    int more = 0;
    seen += CompareJets<TypeParam>(MakeBucklingTermScenes(), 1e-2, 1e-4, 1e-2, &more);
    EXPECT_GE(more, 6);
  }
  EXPECT_GE(count, 6);
  for (int i = 0; i < Layout::kDensity - Layout::kParameter; ++i) {
    EXPECT_GT(seen[Layout::kParameter + i], 0.0) << TypeParam::kParameters[i].name;
  }
  EXPECT_EQ(seen[Layout::kDensity] > 0.0, TypeParam::kUsesDensity);
  EXPECT_EQ(seen[Layout::kShrinkage] > 0.0, TypeParam::kUsesShrinkage);
  EXPECT_EQ(seen[Layout::kShrinkage + 1] > 0.0, TypeParam::kUsesShrinkage);
  for (int i = kFirstUsed<TypeParam>; i < Layout::kSize; ++i)
    EXPECT_GT(seen[i], 0.0) << "input or memory, column " << i;
}

TYPED_TEST(ForceTerm, AddsNothingWhenOff) {
  std::mt19937 random(8);
  const int count = ForEachSample<TypeParam>(
      [&](const TermScene& scene, std::size_t which, const Eigen::VectorXd&) {
        const auto element = SceneElements<TypeParam>(scene)[which];
        const Eigen::VectorXd numbers =
            ElementNumbers<TypeParam>(element, scene, OffParameters<TypeParam>(scene, &random));
        const Eigen::VectorXd force =
            EvaluateTerm<TypeParam, double>(element, numbers).head(TermLayout<TypeParam>::kForces);
        EXPECT_EQ(Largest(force), 0.0);
      });
  EXPECT_GE(count, 6);
}

// A fit that asks whether a term that is off would help reads the derivatives there: they must be
// those of switching on (parameters that only shape the force have none).
TYPED_TEST(ForceTerm, DerivativesWhenOffAreThoseOfSwitchingOn) {
  using Layout = TermLayout<TypeParam>;
  if (std::is_same_v<TypeParam, Grip>) GTEST_SKIP() << "a rigid grip is no force, see grip_test";
  int nonzero = 0;
  std::mt19937 random(9);
  ForEachSample<TypeParam>([&](const TermScene& scene, std::size_t which, const Eigen::VectorXd&) {
    const auto element = SceneElements<TypeParam>(scene)[which];
    const Eigen::VectorXd off =
        ElementNumbers<TypeParam>(element, scene, OffParameters<TypeParam>(scene, &random));
    for (int column = Layout::kParameter; column < Layout::kDensity; ++column) {
      // One-sided, of order h^2. f is exactly zero when off, so the tiny step cancels nothing but
      // in terms that are the difference of two forces.
      const double scale = TypeParam::kParameters[column - Layout::kParameter].prior_factor;
      const double h = 1e-6 * scale, floor = std::max(1e-12, kCancelling<TypeParam> / scale);
      Eigen::VectorXd once = off, twice = off;
      once[column] += h;
      twice[column] += 2.0 * h;
      const Eigen::VectorXd difference = (4.0 * EvaluateTerm<TypeParam, double>(element, once) -
                                          EvaluateTerm<TypeParam, double>(element, twice)) /
                                         (2.0 * h);
      const Eigen::VectorXd jet = DifferentiateTerm<TypeParam>(element, off, column);
      // The step itself is rounded to 1e-16 / 1e-8 where the parameter is off at a value.
      EXPECT_LE(Largest((jet - difference).head(Layout::kForces)),
                1e-7 * std::max(Largest(difference.head(Layout::kForces)), floor))
          << TypeParam::kParameters[column - Layout::kParameter].name;
      if (Largest(difference.head(Layout::kForces)) > 0.0) ++nonzero;
    }
  });
  EXPECT_GT(nonzero, 0);
}

// Net force and net moment of internal forces vanish.
TYPED_TEST(ForceTerm, InternalForcesBalance) {
  if (!TypeParam::kInternal) GTEST_SKIP() << "not an internal force";
  int acting = 0;
  ForEachSample<TypeParam>(
      [&](const TermScene& scene, std::size_t which, const Eigen::VectorXd& parameters) {
        const auto element = SceneElements<TypeParam>(scene)[which];
        const Eigen::VectorXd numbers = ElementNumbers<TypeParam>(element, scene, parameters);
        const Eigen::VectorXd force = EvaluateTerm<TypeParam, double>(element, numbers);
        Eigen::Vector3d net = Eigen::Vector3d::Zero(), moment = net;
        for (int n = 0; n < TypeParam::kNodes; ++n) {
          const Eigen::Vector3d f = force.segment<3>(3 * n), x = numbers.segment<3>(3 * n);
          net += f;
          moment += x.cross(f);
        }
        // Some hundred operations' roundoff of the largest force; arms are below 1 m.
        const double roundoff = 1e-13 * Largest(force);
        EXPECT_LE(Largest(net), roundoff);
        EXPECT_LE(Largest(moment), roundoff);
        if (Largest(force) > 0.0) ++acting;
      });
  EXPECT_GE(acting, 6);
}

// Internal forces do not resist a rigid motion: a velocity field v + w x r changes nothing.
TYPED_TEST(ForceTerm, InternalForcesIgnoreRigidVelocities) {
  if (!TypeParam::kInternal) GTEST_SKIP() << "not an internal force";
  const int count = ForEachSample<TypeParam>(
      [&](const TermScene& scene, std::size_t which, const Eigen::VectorXd& parameters) {
        const auto element = SceneElements<TypeParam>(scene)[which];
        TermScene turning = scene;
        const Eigen::Vector3d shift(0.3, -0.2, 0.5), spin(1.0, -2.0, 0.7);
        for (int i = 0; i < scene.mesh.num_particles(); ++i) {
          turning.v.segment<3>(3 * i) += shift + spin.cross(scene.x.segment<3>(3 * i));
        }
        const Eigen::VectorXd a = EvaluateTerm<TypeParam, double>(
            element, ElementNumbers<TypeParam>(element, scene, parameters));
        const Eigen::VectorXd b = EvaluateTerm<TypeParam, double>(
            element, ElementNumbers<TypeParam>(element, turning, parameters));
        // Roundoff of a velocity of 1 m/s acts through the damping; for damping that dominates
        // (velocities down to 0.1 mm/s) it is 1e-12 of the force.
        EXPECT_LE(Largest(a - b), 1e-10 * Largest(a) + 1e-12);
      });
  EXPECT_GE(count, 6);
}

// Vectors and places in the world turn and move with the cloth.
template <class Term>
Eigen::VectorXd MovedParameters(Eigen::VectorXd parameters, const Eigen::Matrix3d& rotation,
                                const Eigen::Vector3d& shift) {
  for (int i = 0; i + 2 < parameters.size(); ++i) {
    const Meaning meaning = Term::kParameters[i].meaning;
    const bool is_place = meaning == Meaning::kPlaceX;
    if (!is_place && meaning != Meaning::kVectorX) continue;
    const Eigen::Vector3d turned = rotation * parameters.segment<3>(i);
    parameters.segment<3>(i) = turned + (is_place ? shift : Eigen::Vector3d::Zero());
  }
  return parameters;
}

// The same cloth turned and moved feels the same forces, turned. The ground allows only turns about
// the vertical and horizontal moves; what takes no notice of it allows all.
template <class Term>
void ExpectEquivariance(bool with_ground, const Eigen::Matrix3d& rotation,
                        const Eigen::Vector3d& shift) {
  if (Term::kPrefersAxes) GTEST_SKIP() << "parameters are bound to the world's axes";
  std::mt19937 random(11);
  int acting = 0, elements_seen = 0;
  for (TermScene scene : MakeTermScenes()) {
    SCOPED_TRACE(scene.name);
    if (!with_ground) RemoveGround(&scene);
    const TermScene moved = Moved(scene, rotation, shift);
    const auto elements = SceneElements<Term>(scene), moved_elements = SceneElements<Term>(moved);
    ASSERT_EQ(elements.size(), moved_elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const Eigen::VectorXd parameters = RandomParameters<Term>(scene, &random);
      const Eigen::VectorXd moved_parameters = MovedParameters<Term>(parameters, rotation, shift);
      const Eigen::VectorXd force = EvaluateTerm<Term, double>(
          elements[e], ElementNumbers<Term>(elements[e], scene, parameters));
      const Eigen::VectorXd moved_force = EvaluateTerm<Term, double>(
          moved_elements[e], ElementNumbers<Term>(moved_elements[e], moved, moved_parameters));
      ++elements_seen;
      for (int n = 0; n < Term::kNodes; ++n) {
        const Eigen::Vector3d turned = rotation * force.segment<3>(3 * n);
        // Positions of up to 2 m are rounded to 4e-16 m; strains of 1e-4 of a 2 cm edge and
        // attractions within 0.1 mm make 1e-10 of a force of that.
        EXPECT_LE(Largest(moved_force.segment<3>(3 * n) - turned), 1e-9 * Largest(force) + 1e-10);
      }
      if (Largest(force) > 1e-6) ++acting;
    }
  }
  // A term without elements here lives on the ground, and is tested there.
  if (with_ground || elements_seen > 0) {
    EXPECT_GT(acting, 6);
  }
}

TYPED_TEST(ForceTerm, TurnsAboutTheVerticalWithTheCloth) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  ExpectEquivariance<TypeParam>(true, rotation, {0.4, -0.3, 0.0});
}

TYPED_TEST(ForceTerm, TurnsWithTheClothWhereThereIsNoGround) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(2.3, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
  ExpectEquivariance<TypeParam>(false, rotation, {0.4, -0.3, 0.8});
}

// What a term says that it does to the energy, as far as that shows in one element.
TYPED_TEST(ForceTerm, ConservativeForcesTakeNoNoticeOfVelocities) {
  if (TypeParam::kWork != Work::kConserves) GTEST_SKIP() << "does not conserve energy";
  if (TypeParam::kUsesAcceleration) GTEST_SKIP() << "an inertia";
  using Layout = TermLayout<TypeParam>;
  const int count = ForEachSample<TypeParam>(
      [](const TermScene& scene, std::size_t which, const Eigen::VectorXd& parameters) {
        const auto element = SceneElements<TypeParam>(scene)[which];
        const Eigen::VectorXd moving = ElementNumbers<TypeParam>(element, scene, parameters);
        Eigen::VectorXd still = moving;
        still.segment(Layout::kV, Layout::kForces).setZero();
        const Eigen::VectorXd of_moving = EvaluateTerm<TypeParam, double>(element, moving);
        EXPECT_EQ(of_moving, (EvaluateTerm<TypeParam, double>(element, still)));
      });
  EXPECT_GE(count, 6);
}

// What a force owes to the velocity takes energy from the cloth, never gives it any.
TYPED_TEST(ForceTerm, VelocitiesAreResisted) {
  if (TypeParam::kMemory > 0) GTEST_SKIP() << "what is remembered may push";
  if (TypeParam::kUsesAcceleration) GTEST_SKIP() << "an inertia gives back what it took";
  if (kIsPartOfAnother<TypeParam>) GTEST_SKIP() << "resists only with the term it belongs to";
  using Layout = TermLayout<TypeParam>;
  const int count = ForEachSample<TypeParam>(
      [](const TermScene& scene, std::size_t which, const Eigen::VectorXd& parameters) {
        const auto element = SceneElements<TypeParam>(scene)[which];
        const Eigen::VectorXd moving = ElementNumbers<TypeParam>(element, scene, parameters);
        Eigen::VectorXd still = moving;
        still.segment(Layout::kV, Layout::kForces).setZero();
        const Eigen::VectorXd f = EvaluateTerm<TypeParam, double>(element, moving);
        const Eigen::VectorXd difference =
            (f - EvaluateTerm<TypeParam, double>(element, still)).head(Layout::kForces);
        const Eigen::VectorXd velocity = moving.segment(Layout::kV, Layout::kForces);
        const double power = difference.dot(velocity);
        EXPECT_LE(power, 1e-14 * Largest(f) * velocity.norm());  // roundoff of the difference
      });
  EXPECT_GE(count, 6);
}

// Adds up what a term writes down, forces x an element's positions or velocities.
struct DenseSink {
  void operator()(int a, int b, int p, const JacobianRow& row) const {
    alignas(32) double values[4] = {};
    row.AddTo(values);
    for (int q = 0; q < 3; ++q) (*sum)(3 * a + p, 3 * b + q) += values[q];
  }
  Eigen::MatrixXd* sum;
};

TYPED_TEST(ForceTerm, WrittenJacobiansAreThoseOfJets) {
  if constexpr (kWritesJacobian<TypeParam>) {
    using Layout = TermLayout<TypeParam>;
    int written = 0;
    const auto check = [&](const TermScene& scene, std::size_t which,
                           const Eigen::VectorXd& parameters) {
      const auto element = SceneElements<TypeParam>(scene)[which];
      const Eigen::VectorXd numbers = ElementNumbers<TypeParam>(element, scene, parameters);
      const auto in = MakeElementInput<TypeParam, double>(numbers);
      for (const int first : {Layout::kX, Layout::kV}) {
        Eigen::MatrixXd jets(Layout::kForces, Layout::kForces);
        for (int column = 0; column < Layout::kForces; ++column) {
          jets.col(column) =
              DifferentiateTerm<TypeParam>(element, numbers, first + column).head(Layout::kForces);
        }
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(Layout::kForces, Layout::kForces);
        const bool by_x = first == Layout::kX;
        TypeParam::template AddJacobian<DenseSink>(
            element, in, {by_x ? 1.0 : 0.0, by_x ? 0.0 : 1.0, 0.0}, {&sum});
        // A fold that is nearly flat knows its sine to 1e-16 of its triangles.
        EXPECT_LE(Largest(sum - jets), 1e-8 * Largest(jets)) << "from number " << first << " on";
        ++written;
      }
    };
    ForEachSample<TypeParam>(check);
    ForEachSample<TypeParam>(check, MakeBucklingTermScenes());
    EXPECT_GE(written, 100);
  }
}

}  // namespace
}  // namespace clothfit
