// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Creases, stiffening, orthotropy and stiff places against their laws written another way.
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/autodiff_sim/terms/force_of_energy.h"
#include "tests/autodiff_sim/terms/term_sample.h"

namespace clothfit {
namespace {

// The largest force on any particle of a cloth at rest with these heights (m), of bending alone and
// of bending with the crease (N).
struct CreaseForces {
  double bending = 0.0, both = 0.0;
};

template <class Height>
CreaseForces ForcesOfHeights(const ClothMesh& mesh, const Eigen::VectorXd& crease,
                             const Height& height) {
  TermScene scene;
  scene.mesh = mesh;
  scene.topology = BuildTopology(mesh);
  scene.x.resize(3 * mesh.num_particles());
  scene.v.setZero(scene.x.size());
  for (int i = 0; i < mesh.num_particles(); ++i)
    scene.x.segment<3>(3 * i) << mesh.uv[i], height(mesh.uv[i] - MiddleOfCloth(mesh));
  Eigen::VectorXd bending = Eigen::VectorXd::Zero(scene.x.size()), both = bending;
  const double stiffness = InitialValue("bending.stiffness");
  const auto creases = SceneElements<Crease>(scene);
  for (std::size_t h = 0; h < creases.size(); ++h) {
    const Hinge& hinge = scene.topology.hinges[h];
    const Eigen::VectorXd elastic = EvaluateTerm<Bending, double>(
        hinge, ElementNumbers<Bending>(hinge, scene, Numbers({stiffness, 0.0})));
    const Eigen::VectorXd extra =
        EvaluateTerm<Crease, double>(creases[h], ElementNumbers<Crease>(creases[h], scene, crease));
    for (int n = 0; n < 4; ++n) {
      bending.segment<3>(3 * hinge.nodes[n]) += elastic.segment<3>(3 * n);
      both.segment<3>(3 * hinge.nodes[n]) += (elastic + extra).segment<3>(3 * n);
    }
  }
  return {bending.lpNorm<Eigen::Infinity>(), both.lpNorm<Eigen::Infinity>()};
}

// A cloth in the crease's own shape feels nothing, whatever the crease's direction and whether the
// mesh resolves its width. Curvatures of 1e-2 1/m make slopes of 1e-4, whose squares are neglected.
TEST(CreasePhysics, ItsShapeIsFreeOfForce) {
  const ClothMesh mesh = MakeGrid({0.2, 0.14}, {11, 8});
  int count = 0;
  for (const double angle : {0.0, 0.5, M_PI / 2, 2.0}) {
    for (const double width : {0.03, 0.002}) {
      SCOPED_TRACE(std::to_string(angle) + ", width " + std::to_string(width));
      const double curvature = 1e-2, offset = 0.013;
      const auto shape = [&](const Eigen::Vector2d& p) {
        const double s = p.y() * std::cos(angle) - p.x() * std::sin(angle) - offset;
        return curvature * width * width * std::log(std::cosh(s / width));
      };
      const CreaseForces forces =
          ForcesOfHeights(mesh, Numbers({curvature, angle, offset, width}), shape);
      EXPECT_GT(forces.bending, 0.0);
      EXPECT_LE(forces.both, 1e-6 * forces.bending);
      ++count;
    }
  }
  EXPECT_EQ(count, 8);
}

// Far from the line the sides stand at twice curvature times width to each other.
TEST(CreasePhysics, TurnsBySoMuchInAll) {
  const double curvature = 0.1, width = 0.004;
  const auto height = [&](double s) {
    return curvature * width * width * LogCosh<double>(s / width);
  };
  EXPECT_NEAR((height(0.2) - height(0.1)) / 0.1, curvature * width, 1e-15);
  EXPECT_NEAR((height(-0.2) - height(-0.1)) / 0.1, curvature * width, 1e-15);
  EXPECT_EQ(LogCosh<double>(0.0), 0.0);
  EXPECT_NEAR(LogCosh<double>(-0.3), std::log(std::cosh(0.3)), 1e-16);
}

TEST(StretchStiffeningPhysics, ForceIsThatOfTheEnergy) {
  ExpectForceOfEnergy<StretchStiffening>(
      Numbers({1e6, 0.01}), [](const Spring& spring, const Eigen::VectorXd& n) {
        const double length = (Node<1>(n) - Node<0>(n)).norm();
        const double warp = std::sqrt(spring.warp_share) * (1.0 - kSampleShrinkage[0]);
        const double weft = std::sqrt(1.0 - spring.warp_share) * (1.0 - kSampleShrinkage[1]);
        const double rest = spring.rest_length * std::hypot(warp, weft);
        const double beyond = std::max(0.0, length / rest - 1.0 - 0.01);
        return 0.25 * 1e6 * std::pow(beyond, 4) * rest * rest * spring.weight;
      });
}

// Both limits, within and beyond the part where the slope sets in.
TEST(StrainLimitPhysics, ForceIsThatOfTheEnergy) {
  const double stretch = 0.004, compression = 0.006, soft = StrainLimit::kSoft;
  const auto beyond = [soft](double z) {
    if (z < 0.0) return 0.0;
    if (z < soft) return z * z * z / (6.0 * soft);
    return 0.5 * (z * z - soft * soft) - 0.5 * soft * (z - soft) + soft * soft / 6.0;
  };
  ExpectForceOfEnergy<StrainLimit>(
      Numbers({1e3, stretch, compression}), [&](const Spring& spring, const Eigen::VectorXd& n) {
        const double length = (Node<1>(n) - Node<0>(n)).norm();
        const double warp = std::sqrt(spring.warp_share) * (1.0 - kSampleShrinkage[0]);
        const double weft = std::sqrt(1.0 - spring.warp_share) * (1.0 - kSampleShrinkage[1]);
        const double rest = spring.rest_length * std::hypot(warp, weft);
        const double strain = length / rest - 1.0;
        return 1e3 * (beyond(strain - stretch) + beyond(-strain - compression)) * rest * rest *
               spring.weight;
      });
}

// The largest strain along warp and weft, after half a second, of a cloth that hangs by two corners
// and is far too heavy for its springs.
double StrainOfHeavyCloth(double limiting_stiffness) {
  const TestScene scene = SwingingCloth(7, 0.3);
  Simulation simulation(scene.mesh, scene.world, scene.handles);
  UseSuppleCloth(&simulation);
  Set("gravity.scale", 10.0, &simulation);
  Set("stretch.stiffness", 30.0, &simulation);
  Set("strain_limit.stiffness", limiting_stiffness, &simulation);
  Set("strain_limit.stretch", 0.05, &simulation);
  State state = simulation.MakeState(scene.x);
  Advance(1.0 / 120.0, 60, scene.MakeDrive(), &simulation, &state);
  double largest = 0.0;
  for (const Spring& spring : simulation.model().topology().structural) {
    const double length =
        (state.x.segment<3>(3 * spring.nodes[1]) - state.x.segment<3>(3 * spring.nodes[0])).norm();
    largest = std::max(largest, length / spring.rest_length - 1.0);
  }
  return largest;
}

TEST(StrainLimitPhysics, HoldsWhatSpringsDoNot) {
  EXPECT_GT(StrainOfHeavyCloth(0.0), 0.3);
  // At the corners a few newtons hang on a width of 25 mm: 1e4 N/m give way by a few per cent.
  EXPECT_LT(StrainOfHeavyCloth(1e4), 0.1);
}

// Forces of a term's element at rest-free numbers; parameters of others at the initial values.
template <class Term>
Eigen::VectorXd Force(const typename Term::Element& element, TermScene scene,
                      const Eigen::VectorXd& parameters) {
  scene.v.setZero();
  return EvaluateTerm<Term, double>(element, ElementNumbers<Term>(element, scene, parameters));
}

// Elastic force of springs and folds at the initial stiffness, times a factor.
template <class Base, class Elastic>
Eigen::VectorXd BaseForce(const Elastic& elastic, const TermScene& scene, double factor) {
  const double stiffness = InitialValue(std::string(Base::kName) + "." + Base::kParameters[0].name);
  return Force<Base>(elastic, scene, Numbers({factor * stiffness, 0.0}));
}

// The extra force of every element is what its base force gains where the stiffness is multiplied
// by factor(element).
template <class Term, class Base, class Factor>
void ExpectScales(const Eigen::VectorXd& parameters, const Factor& factor) {
  int count = 0;
  for (const TermScene& scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<Term>(scene)) {
      const Eigen::VectorXd extra = Force<Term>(element, scene, parameters);
      const double times = factor(element, scene);
      const Eigen::VectorXd base = BaseForce<Base>(element.elastic, scene, 1.0);
      const Eigen::VectorXd scaled = BaseForce<Base>(element.elastic, scene, times);
      EXPECT_LE((extra - (scaled - base)).norm(), 1e-12 * (1.0 + times) * base.norm());
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

// Along the warp times the ratio's root, along the weft over it; diagonals and bias folds as
// before.
TEST(OrthotropyPhysics, SplitsStiffnessByTheRatiosRoot) {
  const Eigen::VectorXd ratio = Numbers({4.0});
  const auto of_direction = [](const Eigen::Vector2d& d) {
    return std::abs(d.y()) < 1e-9 ? 2.0 : std::abs(d.x()) < 1e-9 ? 0.5 : 1.0;
  };
  const auto edge = [](const TermScene& scene, int a, int b) -> Eigen::Vector2d {
    return scene.mesh.uv[b] - scene.mesh.uv[a];
  };
  ExpectScales<StretchOrthotropy, StretchSpring>(ratio, [&](const auto& e, const auto& scene) {
    return of_direction(edge(scene, e.nodes[0], e.nodes[1]));
  });
  // A fold bends across its edge.
  ExpectScales<BendingOrthotropy, Bending>(ratio, [&](const auto& e, const auto& scene) {
    const Eigen::Vector2d d = edge(scene, e.nodes[2], e.nodes[3]);
    return of_direction({d.y(), d.x()});
  });
  // Springs along the bias.
  const double shear = InitialValue("shear.stiffness");
  for (const TermScene& scene : MakeTermScenes()) {
    for (const auto& element : SceneElements<ShearOrthotropy>(scene)) {
      const BiasSprings& springs = element.elastic;
      ASSERT_EQ(springs.bias[0].buckling_length, 0.0);  // so that each pulls by itself
      Eigen::VectorXd expected = 0.0 * Force<ShearOrthotropy>(element, scene, ratio);
      for (int i = 0; i < springs.springs; ++i) {
        const Eigen::Vector2d d = edge(scene, springs.nodes[2 * i], springs.nodes[2 * i + 1]);
        const double extra = d.x() * d.y() > 0.0 ? shear : -0.5 * shear;
        expected.segment<6>(6 * i) =
            Force<StretchSpring>(springs.bias[i], scene, Numbers({extra, 0.0})).head<6>();
      }
      EXPECT_LE((Force<ShearOrthotropy>(element, scene, ratio) - expected).norm(),
                1e-12 * expected.norm());
    }
  }
}

TEST(StiffPlaces, ScaleTheStiffnessByTheirGaussCurves) {
  const double extra = 5.0, u = 0.03, v = 0.02, radius = 0.025;
  const auto of_patch = [&](const auto& e, const auto&) {
    return 1.0 + extra * std::exp(-0.5 * (e.uv - Eigen::Vector2d(u, v)).squaredNorm() /
                                  (radius * radius));
  };
  const Eigen::VectorXd patch = Numbers({extra, u, v, radius});
  ExpectScales<StiffPatchStretch, StretchSpring>(patch, of_patch);
  ExpectScales<StiffPatchBending, Bending>(patch, of_patch);
  // A seam through (0.05, 0.03), the cloth's middle being (0.04, 0.03), at 90 degrees to the warp.
  const auto of_seam = [&](const auto& e, const auto&) {
    return 1.0 + extra * std::exp(-0.5 * std::pow((e.uv.x() - 0.05) / 0.01, 2));
  };
  const Eigen::VectorXd seam = Numbers({extra, M_PI / 2, -0.01, 0.01});
  ExpectScales<StiffSeamStretch, StretchSpring>(seam, of_seam);
  ExpectScales<StiffSeamBending, Bending>(seam, of_seam);
}

}  // namespace
}  // namespace clothfit
