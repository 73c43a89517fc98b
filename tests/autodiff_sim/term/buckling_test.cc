// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The law of a membrane that buckles below its mesh, and a strip in compression.
#include "autodiff_sim/term/buckling.h"

#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "autodiff_sim/base/dual.h"
#include "autodiff_sim/scenes/cloth_scene.h"
#include "tests/autodiff_sim/step/motion.h"

namespace clothfit {
namespace {

constexpr PlaneStress<double> kNoStress = {0.0, 0.0, 0.0};

// Strains from far below a buckling strain to far beyond it.
PlaneStress<double> RandomStrain(std::mt19937* random) {
  std::normal_distribution<double> normal;
  const double size = std::pow(10.0, std::uniform_real_distribution<double>(-5.0, -0.5)(*random));
  return {size * normal(*random), size * normal(*random), size * normal(*random)};
}

PlaneStress<double> RandomStiffness(std::mt19937* random) {
  std::uniform_real_distribution<double> decades(0.0, 3.0);
  const double shear = (*random)() % 8 == 0 ? 0.0 : std::pow(10.0, decades(*random));
  return {std::pow(10.0, decades(*random)), std::pow(10.0, decades(*random)), shear};
}

TEST(Buckling, WrinklesSolveTheirEquationsAndShortenTheCloth) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20000; ++trial) {
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(-6.0, 6.0)(random));
    std::array<double, 3> stress, stiffness;
    for (double& s : stress) s = size * normal(random);
    for (double& c : stiffness)
      c = std::pow(10.0, std::uniform_real_distribution<double>(-6.0, -1.0)(random));
    const Wrinkles w = FindWrinkles(stress, stiffness);
    const double d = w.determinant;
    EXPECT_NEAR(d, w.x * w.y - w.z * w.z, 1e-12 * w.x * w.y);
    ASSERT_GT(w.x, 0.0);
    ASSERT_GT(d, 0.0);
    const double along_warp = w.y / d, along_weft = w.x / d, of_shear = -w.z / d;
    const double largest = 1.0 + size + std::abs(along_warp) + std::abs(along_weft);
    EXPECT_NEAR(stiffness[0] * (w.x - 1.0) + stress[0] + 1.0, along_warp, 1e-9 * largest);
    EXPECT_NEAR(stiffness[1] * (w.y - 1.0) + stress[1] + 1.0, along_weft, 1e-9 * largest);
    EXPECT_NEAR(stiffness[2] * w.z + stress[2], of_shear, 1e-9 * largest);
  }
}

// But for the share of the stress that wrinkles keep.
TEST(Buckling, NoDirectionCarriesMoreThanEulersLoad) {
  std::mt19937 random(2);
  int limited = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const PlaneStress<double> strain = RandomStrain(&random), stiffness = RandomStiffness(&random);
    const double load = std::pow(10.0, std::uniform_real_distribution<double>(-3.0, 1.0)(random));
    const PlaneStress<double> stress = BuckledStress<double>(stiffness, load, strain, kNoStress);
    std::array<double, 3> s;
    for (int i = 0; i < 3; ++i)
      s[i] = (stress[i] - kBuckledShare * stiffness[i] * strain[i]) / (1.0 - kBuckledShare);
    Eigen::Matrix2d tensor;
    tensor << s[0], s[2], s[2], s[1];
    const double least = tensor.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
    EXPECT_GE(least, -load * (1.0 + 1e-9));
    if (least < -0.9 * load) ++limited;
  }
  EXPECT_GT(limited, 500);
}

TEST(Buckling, IsTheMaterialsWhereTheLoadIsLarge) {
  const PlaneStress<double> stiffness = {500.0, 300.0, 40.0}, strain = {-2e-3, 1e-3, 3e-3};
  double before = 0.0;
  for (const double load : {1e2, 1e3, 1e4}) {
    const PlaneStress<double> stress = BuckledStress<double>(stiffness, load, strain, kNoStress);
    double error = 0.0;
    for (int i = 0; i < 3; ++i)
      error = std::max(error, std::abs(stress[i] - stiffness[i] * strain[i]));
    if (before > 0.0) {
      EXPECT_NEAR(error, before / 10.0, before / 40.0) << load;
    }
    EXPECT_NEAR(BuckledTension(500.0, load, -2e-3, 0.0), -1.0, 0.1 / load);
    before = error;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(Buckling, WithoutShearWarpAndWeftAreApart) {
  for (const double strain : {-0.05, -1e-3, 0.0, 2e-4, 0.03}) {
    const PlaneStress<double> stress =
        BuckledStress<double>({400.0, 400.0, 0.0}, 0.5, {strain, -strain, 0.0}, {0.1, -0.3, 0.0});
    EXPECT_NEAR(stress[0], BuckledTension(400.0, 0.5, strain, 0.1), 1e-10);
    EXPECT_NEAR(stress[1], BuckledTension(400.0, 0.5, -strain, -0.3), 1e-10);
    EXPECT_EQ(stress[2], 0.0);
  }
}

// A material with 2 shear = warp = weft has no direction: its stress turns with the strain.
TEST(Buckling, AnIsotropicMembraneHasNoDirection) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const PlaneStress<double> strain = RandomStrain(&random);
    Eigen::Matrix2d e;
    e << strain[0], 0.5 * strain[2], 0.5 * strain[2], strain[1];
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.1 + trial).toRotationMatrix();
    const auto stress_of = [](const Eigen::Matrix2d& tensor) {
      const PlaneStress<double> s = BuckledStress<double>(
          {400.0, 400.0, 200.0}, 0.5, {tensor(0, 0), tensor(1, 1), 2.0 * tensor(0, 1)}, kNoStress);
      Eigen::Matrix2d stress;
      stress << s[0], s[2], s[2], s[1];
      return stress;
    };
    const Eigen::Matrix2d turned = turn * e * turn.transpose();
    const Eigen::Matrix2d expected = turn * stress_of(e) * turn.transpose();
    EXPECT_LT((stress_of(turned) - expected).norm(), 1e-9 * (1.0 + expected.norm()));
  }
}

// By strain, stiffness and load at once, and the stress is the energy's derivative by the strain.
TEST(Buckling, DerivativesAreThoseOfDifferences) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 500; ++trial) {
    std::array<double, 7> at;
    const PlaneStress<double> strain = RandomStrain(&random), stiffness = RandomStiffness(&random);
    for (int i = 0; i < 3; ++i) {
      at[i] = strain[i];
      at[3 + i] = stiffness[i];
    }
    at[6] = std::pow(10.0, std::uniform_real_distribution<double>(-2.0, 1.0)(random));
    using T = Dual<8>;
    std::array<T, 7> number;
    for (int i = 0; i < 7; ++i) {
      number[i] = T(at[i]);
      number[i].SetDerivative(i, 1.0);
    }
    const T none(0.0);
    const PlaneStress<T> stress =
        BuckledStress<T>({number[3], number[4], number[5]}, number[6],
                         {number[0], number[1], number[2]}, {none, none, none});
    const double size = std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
    for (int i = 0; i < 7; ++i) {
      const double h = i < 3 ? 1e-7 * at[6] : 1e-5 * at[i];  // small beside load over stiffness
      if (at[i] == 0.0) continue;
      std::array<double, 7> more = at, less = at;
      more[i] += h;
      less[i] -= h;
      const auto stress_at = [](const std::array<double, 7>& n) {
        return BuckledStress<double>({n[3], n[4], n[5]}, n[6], {n[0], n[1], n[2]}, kNoStress);
      };
      const auto energy_at = [](const std::array<double, 7>& n) {
        return BuckledEnergy({n[3], n[4], n[5]}, n[6], {n[0], n[1], n[2]});
      };
      const PlaneStress<double> high = stress_at(more), low = stress_at(less);
      double scale = 1e-9 / h, stiffest = at[3] + at[4] + at[5];
      for (int k = 0; k < 3; ++k) scale = std::max(scale, 1e-4 * (i < 3 ? stiffest : size));
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(stress[k].derivative(i), (high[k] - low[k]) / (2.0 * h), scale)
            << trial << ": " << k << " by " << i;
      if (i < 3) {
        const double energy = (energy_at(more) - energy_at(less)) / (2.0 * h);
        EXPECT_NEAR(stress[i].a, energy, 1e-4 * stiffest * size + 1e-7);
      }
    }
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
    // The folds of a cloth with free sides bend across as well, at the scale of the mesh: whatever
    // its resolution it carries a sixth less than a strip that bends along alone.
    EXPECT_NEAR(of_springs, 5.0 / 6.0 * euler, 0.02 * euler) << cells;
    // A cell carries many times more, and leaves it alone.
    EXPECT_NEAR(LoadOfStrip(cells, true), of_springs, 1e-3 * euler) << cells;
  }
}

// A single cell along the load buckles below the mesh under Euler's load of its own side, where
// springs go on to resist.
TEST(Buckling, ACellCarriesItsOwnEulersLoad) {
  const double load = BucklingLoad(4e-3, 500.0, 0.1), strain = -0.01;
  EXPECT_NEAR(load, 1e-3 * M_PI * M_PI / 0.01 + 0.05, 1e-12);
  const double tension = BuckledTension(500.0, load, strain, 0.0);
  EXPECT_LT(tension, -load * (1.0 - 2.0 * kBuckledShare));
  EXPECT_GT(tension, -load + kBuckledShare * 500.0 * strain);
}

}  // namespace
}  // namespace clothfit
