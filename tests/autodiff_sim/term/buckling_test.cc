// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The law of threads that buckle below their mesh, and a strip in compression.
#include "autodiff_sim/term/buckling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "autodiff_sim/base/dual.h"
#include "autodiff_sim/scenes/cloth_scene.h"
#include "autodiff_sim/terms/shear.h"
#include "tests/autodiff_sim/step/motion.h"

namespace clothfit {
namespace {

double LogUniform(double first, double last, std::mt19937* random) {
  return std::pow(10.0, std::uniform_real_distribution<double>(first, last)(*random));
}

// But for the share of the tension that wrinkles keep; in tension it is the material's.
TEST(Buckling, NoCompressionIsMoreThanEulersLoad) {
  std::mt19937 random(2);
  int limited = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const double stiffness = LogUniform(0.0, 3.0, &random), load = LogUniform(-3.0, 1.0, &random);
    const double strain = LogUniform(-5.0, -0.5, &random) * (random() % 2 == 0 ? 1.0 : -1.0);
    const double plain = stiffness * strain;
    const double tension =
        (BuckledTension(plain, load) - kBuckledShare * plain) / (1.0 - kBuckledShare);
    EXPECT_GE(tension, -load * (1.0 + 1e-9));
    if (tension < -0.9 * load) ++limited;
    if (strain > 0.0) {
      EXPECT_NEAR(tension, plain, 1e-9 * plain);
    }
  }
  EXPECT_GT(limited, 500);
}

TEST(Buckling, IsTheMaterialsWhereTheLoadIsLarge) {
  double before = 0.0;
  for (const double load : {1e2, 1e3, 1e4}) {
    const double error = std::abs(BuckledTension(-1.0, load) + 1.0);
    EXPECT_LT(error, 1.0 / (load * load));
    if (before > 0.0) {
      EXPECT_NEAR(error, before / 100.0, before / 1000.0) << load;
    }
    before = error;
  }
}

// By strain, stiffness and load, and the tension is the energy's derivative by the strain.
TEST(Buckling, DerivativesAreThoseOfDifferences) {
  std::mt19937 random(4);
  using T = Dual<8>;
  for (int trial = 0; trial < 500; ++trial) {
    const std::array<double, 3> at = {
        LogUniform(-5.0, -0.5, &random) * (random() % 2 == 0 ? 1.0 : -1.0),
        LogUniform(0.0, 3.0, &random), LogUniform(-2.0, 1.0, &random)};
    std::array<T, 3> number;
    for (int i = 0; i < 3; ++i) {
      number[i] = T(at[i]);
      number[i].SetDerivative(i, 1.0);
    }
    const T tension = BuckledTension<T>(number[1] * number[0], number[2]);
    for (int i = 0; i < 3; ++i) {
      const double h = i == 0 ? 1e-5 * at[2] / at[1] : 1e-5 * at[i];
      std::array<double, 3> more = at, less = at;
      more[i] += h;
      less[i] -= h;
      const auto tension_at = [](const std::array<double, 3>& n) {
        return BuckledTension(n[1] * n[0], n[2]);
      };
      const double scale =
          1e-6 * std::abs(tension.derivative(i)) + 1e-13 * std::abs(at[1] * at[0]) / h + 1e-12 / h;
      EXPECT_NEAR(tension.derivative(i), (tension_at(more) - tension_at(less)) / (2.0 * h), scale)
          << trial << " by " << i;
      if (i > 0) continue;
      const double energy =
          (BuckledEnergy(at[1], at[2], more[0]) - BuckledEnergy(at[1], at[2], less[0])) / (2.0 * h);
      EXPECT_NEAR(tension.a, energy, 1e-4 * std::abs(tension.a) + 1e-7);
    }
  }
}

// The stiffness is positive everywhere, so that Newton's method finds its way.
TEST(Buckling, TheEnergyIsConvex) {
  using T = Dual<8>;
  for (double strain = -0.3; strain < 0.3; strain += 1e-3) {
    T e(strain);
    e.SetDerivative(0, 1.0);
    const double slope = BuckledTension<T>(500.0 * e, T(0.3)).derivative(0);
    EXPECT_GE(slope, kBuckledShare * 500.0) << strain;
    EXPECT_LE(slope, 500.0 * (1.0 + 1e-12)) << strain;
  }
}

constexpr double kShear = 20.0, kBending = 1e-5, kDiagonal = 0.1;  // N/m, N m, m

// The tensions per width of two springs of kDiagonal that cross, of their strains.
template <class T>
std::array<T, 2> BiasTensions(const std::array<T, 2>& stiffness, const std::array<T, 2>& strain) {
  BiasSprings springs = {{0, 1, 2, 3}, 2, {}};
  std::array<T, 2> length2;
  for (int i = 0; i < 2; ++i) {
    springs.bias[i].rest_length = springs.bias[i].buckling_length = kDiagonal;
    springs.bias[i].weight = 1.0;
    length2[i] = kDiagonal * kDiagonal * (1.0 + strain[i]) * (1.0 + strain[i]);
  }
  std::array<T, 2> tensions = BiasPulls<T>(springs, stiffness, T(0.0), T(kBending),
                                           {T(0.0), T(0.0)}, length2, {T(0.0), T(0.0)});
  for (int i = 0; i < 2; ++i) tensions[i] = tensions[i] * (1.0 + strain[i]);
  return tensions;
}

// Whatever the load, where no area is lost; and of a fold along a bias it resists with a half.
TEST(Buckling, TautClothKeepsItsShearStiffness) {
  const double load = BucklingLoad(kBending, kShear, kDiagonal);
  for (const double strain : {0.02, 0.1, 0.3}) {
    ASSERT_GT(kShear * strain, 10.0 * load);
    const auto [along, across] = BiasTensions<double>({kShear, kShear}, {strain, -strain});
    EXPECT_NEAR(along, kShear * strain, 1e-12 * kShear);
    EXPECT_NEAR(across, -kShear * strain, 1e-12 * kShear);
    const auto [crease, folded] = BiasTensions<double>({kShear, kShear}, {0.0, -strain});
    EXPECT_NEAR(crease, 0.5 * kShear * strain, load + kBuckledShare * kShear * strain);
    EXPECT_NEAR(folded, -0.5 * kShear * strain, load + kBuckledShare * kShear * strain);
    const auto [first, second] = BiasTensions<double>({kShear, kShear}, {-strain, -strain});
    EXPECT_NEAR(first, -load, kBuckledShare * kShear * strain + 0.01 * load);
    EXPECT_EQ(first, second);
  }
}

// Of the two springs of a cell together, alike or not: their tensions' derivatives are a symmetric,
// positive definite matrix.
TEST(Buckling, TheEnergyOfACellIsConvex) {
  using T = Dual<8>;
  std::mt19937 random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<T, 2> stiffness, strain;
    for (int i = 0; i < 2; ++i) {
      stiffness[i] = T(kShear * (trial % 2 == 0 ? 1.0 : LogUniform(-0.5, 0.5, &random)));
      strain[i] = T(LogUniform(-4.0, -0.5, &random) * (random() % 2 == 0 ? 1.0 : -1.0));
      strain[i].SetDerivative(i, 1.0);
    }
    const std::array<T, 2> tension = BiasTensions<T>(stiffness, strain);
    Eigen::Matrix2d slope;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) slope(i, j) = tension[i].derivative(j);
    EXPECT_NEAR(slope(0, 1), slope(1, 0), 1e-9 * slope.norm());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(slope).eigenvalues()[0],
              0.9 * kBuckledShare * std::min(stiffness[0].a, stiffness[1].a));
  }
}

// A strip between two hinges that approach each other, so slowly that its load is one of rest. It
// is slightly bowed from the start.
double LoadOfStrip(int cells, bool buckles) {
  constexpr double kLength = 0.4, kWidth = 0.8, kBow = 0.004;
  ClothScene scene;
  scene.mesh = MakeGrid({kLength, kWidth}, {cells + 1, 2 * cells + 1});
  scene.mesh.buckles = buckles;
  scene.world.gravity.setZero();
  std::vector<Eigen::Vector2d> held;
  scene.x.resize(3 * scene.mesh.num_particles());
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const Eigen::Vector2d& uv = scene.mesh.uv[i];
    const double slope = kBow * M_PI / kLength;
    // Shortened by the bow's slope squared over four.
    scene.x.segment<3>(3 * i) << uv.x() * (1.0 - 0.25 * slope * slope), uv.y(),
        kBow * std::sin(M_PI * uv.x() / kLength);
    if (uv.x() == 0.0 || uv.x() > kLength - 1e-9) held.push_back(uv);
  }
  scene.handles = LocateOnCloth(scene.mesh, held);
  std::vector<Eigen::Vector3d> places;
  for (const SurfacePoint& handle : scene.handles) places.push_back(handle.At(scene.x));
  scene.path = [places](double time) {
    std::vector<Eigen::Vector3d> moved = places;
    for (Eigen::Vector3d& place : moved)
      if (place.x() > 0.2) place.x() -= 0.004 * std::min(time, 1.0);
    return moved;
  };
  SimulationOptions options;
  options.integrator = Integrator::kBackwardEuler;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  UseSuppleCloth(&simulation);
  KeepOnly({"stretch", "shear", "bending"}, &simulation);
  Set("stretch.stiffness", 500.0, &simulation);
  Set("bending.stiffness", 4e-3, &simulation);
  State state = simulation.MakeState(scene.x);
  Advance(0.02, 400, scene.MakeDrive(), &simulation, &state);
  double force = 0.0;
  for (int i = 0; i < scene.mesh.num_particles(); ++i)
    if (scene.mesh.uv[i].x() == 0.0) force += simulation.handle_forces()[3 * i];
  return force / kWidth;
}

TEST(Buckling, AStripCarriesEulersLoad) {
  const double euler = 1e-3 * M_PI * M_PI / (0.4 * 0.4);  // N/m, B = 4e-3 / 4
  for (const int cells : {8, 16}) {
    const double of_springs = LoadOfStrip(cells, false);
    EXPECT_NEAR(of_springs, euler, 0.02 * euler) << cells;
    // A cell carries many times more, and leaves it alone.
    EXPECT_NEAR(LoadOfStrip(cells, true), of_springs, 1e-3 * euler) << cells;
  }
}

// A single cell along the load buckles below the mesh under Euler's load of its own side, where
// springs go on to resist.
TEST(Buckling, ACellCarriesItsOwnEulersLoad) {
  const double load = BucklingLoad(4e-3, 500.0, 0.1), strain = -0.01;
  EXPECT_NEAR(load, 1e-3 * M_PI * M_PI / 0.01 + 0.25, 1e-12);
  const double tension = BuckledTension(500.0 * strain, load);
  EXPECT_LT(tension, -0.9 * load);
  EXPECT_GT(tension, -load + kBuckledShare * 500.0 * strain);
}

}  // namespace
}  // namespace clothfit
