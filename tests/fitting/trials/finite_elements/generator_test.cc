// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The trials' second generator: its energy against its forces, a plate and a membrane by hand, and
// the cloth that it simulates against clothfit's own.
#include "fitting/trials/finite_elements/generator.h"

#include <cmath>
#include <functional>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "fitting/trials/finite_elements/cloth.h"
#include "fitting/trials/recording.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Vector2d kSize(0.4, 0.3);

FemParameters Elastic() {
  return {{"cloth.areal_density", 0.2},
          {"stretch.stiffness", 60.0},
          {"shear.stiffness", 9.0},
          {"bending.stiffness", 4e-4},
          {"gravity.scale", 0.0}};
}

FemCloth MakeCloth(const FemParameters& parameters, const VectorXd& x, const Eigen::Vector2i& cells,
                   std::vector<FemHandle> handles = {}) {
  FemMesh mesh = MakeFemMesh(kSize, cells, 3);
  FemLaws laws = MakeFemLaws(mesh, kSize, parameters);
  return FemCloth(std::move(mesh), std::move(laws), std::move(handles), {}, x);
}

template <class Place>
VectorXd Placed(const Eigen::Vector2i& cells, const Place& place) {
  const FemMesh mesh = MakeFemMesh(kSize, cells, 3);
  VectorXd x(3 * static_cast<Eigen::Index>(mesh.uv.size()));
  for (std::size_t i = 0; i < mesh.uv.size(); ++i)
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) = place(mesh.uv[i]);
  return x;
}

Vector3d Crumpled(const Vector2d& uv) {
  return {1.02 * uv.x() + 0.03 * uv.y(), 0.97 * uv.y(),
          0.02 * std::sin(20.0 * uv.x()) * std::cos(15.0 * uv.y())};
}

TEST(FiniteElements, ForcesAreMinusTheEnergysGradient) {
  const Eigen::Vector2i cells(4, 3);
  const VectorXd x = Placed(cells, Crumpled);
  const VectorXd force = MakeCloth(Elastic(), x, cells).Forces();
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    VectorXd up = x, down = x;
    up[i] += kStep;
    down[i] -= kStep;
    const double slope = (MakeCloth(Elastic(), up, cells).ElasticEnergy() -
                          MakeCloth(Elastic(), down, cells).ElasticEnergy()) /
                         (2.0 * kStep);
    EXPECT_NEAR(force[i], -slope, 1e-6 * force.norm()) << i;
  }
}

TEST(FiniteElements, TheClothDoesNotPushItself) {
  FemParameters parameters = Elastic();
  parameters.insert({{"stretch.damping", 0.5},
                     {"shear.damping", 0.2},
                     {"bending.damping", 2e-5},
                     {"shear_friction.stress", 1.0},
                     {"shear_friction.onset", 0.02},
                     {"stretch_relaxation.share", 0.4},
                     {"stretch_stiffening.cubic", 1e4},
                     {"diagonal_thread.stiffness", 2.0},
                     {"diagonal_thread.gather", 0.04}});
  const Eigen::Vector2i cells(5, 4);
  FemCloth cloth = MakeCloth(parameters, Placed(cells, Crumpled), cells);
  for (int k = 0; k < 50; ++k) cloth.Step(cloth.StableStep());
  const VectorXd force = cloth.Forces();
  Vector3d net = Vector3d::Zero(), moment = net;
  for (Eigen::Index i = 0; i < force.size(); i += 3) {
    net += force.segment<3>(i);
    moment += cloth.positions().segment<3>(i).cross(force.segment<3>(i));
  }
  EXPECT_GT(force.norm(), 1e-3);
  EXPECT_LT(net.norm(), 1e-9 * force.norm());
  // Where the cloth is nearly flat bending's damping is along the normal.
  EXPECT_LT(moment.norm(), 1e-3 * force.norm() * kSize.norm());
}

// A bent cloth that turns as a whole keeps its shape: nothing in it is damped.
TEST(FiniteElements, ATurningClothIsNotDamped) {
  const Eigen::Vector2i cells(16, 12);
  constexpr double kCurvature = 20.0;  // 1/m
  FemParameters damped = Elastic();
  damped.insert({{"stretch.damping", 0.5}, {"shear.damping", 0.2}, {"bending.damping", 2e-5}});
  const VectorXd x = Placed(cells, [&](const Vector2d& uv) {
    return Vector3d(std::sin(kCurvature * uv.x()) / kCurvature, uv.y(),
                    (1.0 - std::cos(kCurvature * uv.x())) / kCurvature);
  });
  const Vector3d axes[] = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
  const auto damping_in = [&](const std::function<Vector3d(const Vector3d&)>& velocity) {
    FemCloth cloth = MakeCloth(damped, x, cells);
    const VectorXd at_rest = cloth.Forces();
    VectorXd v(x.size());
    for (Eigen::Index i = 0; i < x.size(); i += 3) v.segment<3>(i) = velocity(x.segment<3>(i));
    cloth.SetVelocities(v);
    return (cloth.Forces() - at_rest).norm();
  };
  const double bending =
      damping_in([](const Vector3d& place) { return Vector3d(0.0, 0.0, place.x() * place.x()); });
  for (const Vector3d& axis : axes) {
    const double turning =
        damping_in([&](const Vector3d& place) -> Vector3d { return axis.cross(place); });
    EXPECT_LT(turning, 0.01 * bending);
  }
}

TEST(FiniteElements, BendsLikeAPlateInEveryDirection) {
  const Eigen::Vector2i cells(32, 24);
  constexpr double kCurvature = 1.0;  // 1/m
  for (const double degrees : {0.0, 30.0, 45.0, 90.0}) {
    const double angle = degrees * M_PI / 180.0;
    const VectorXd x = Placed(cells, [&](const Vector2d& uv) {
      // Rolled up, so that nothing stretches.
      const double s = std::cos(angle) * uv.x() + std::sin(angle) * uv.y();
      const double t = std::cos(angle) * uv.y() - std::sin(angle) * uv.x();
      return Vector3d(std::sin(kCurvature * s) / kCurvature, t,
                      (1.0 - std::cos(kCurvature * s)) / kCurvature);
    });
    FemParameters plate = Elastic();
    plate["stretch.stiffness"] = plate["shear.stiffness"] = 0.0;
    const double energy = MakeCloth(plate, x, cells).ElasticEnergy();
    const double expected =
        0.5 * 0.25 * plate["bending.stiffness"] * kCurvature * kCurvature * kSize.prod();
    // The sides, half a cell wide, do not bend.
    const double inside = (1.0 - 1.0 / cells.x()) * (1.0 - 1.0 / cells.y());
    EXPECT_NEAR(energy / (inside * expected), 1.0, 0.03) << degrees;
  }
}

TEST(FiniteElements, StretchesAndShearsAsTold) {
  const Eigen::Vector2i cells(3, 3);
  FemParameters parameters = Elastic();
  parameters["stretch_orthotropy.ratio"] = 4.0;
  const double e = 0.01, area = kSize.prod();
  const auto energy = [&](double u, double v, double shear) {
    const VectorXd x = Placed(cells, [&](const Vector2d& uv) {
      return Vector3d((1.0 + u) * uv.x() + shear * uv.y(), (1.0 + v) * uv.y(), 0.0);
    });
    return MakeCloth(parameters, x, cells).ElasticEnergy();
  };
  EXPECT_NEAR(energy(e, 0.0, 0.0), 0.5 * 120.0 * e * e * area, 1e-12);
  EXPECT_NEAR(energy(0.0, e, 0.0), 0.5 * 30.0 * e * e * area, 1e-12);
  EXPECT_NEAR(energy(0.0, 0.0, e), 0.5 * 9.0 * e * e * area, 1e-7);
}

TEST(FiniteElements, KeepsEnergyWithoutDamping) {
  const Eigen::Vector2i cells(4, 4);
  FemCloth cloth = MakeCloth(Elastic(), Placed(cells, Crumpled), cells);
  const double before = cloth.ElasticEnergy();
  double largest = 0.0, least = 1e9;
  while (cloth.time() < 0.1) {
    cloth.Step(0.1 * cloth.StableStep());
    const double energy = cloth.ElasticEnergy() + cloth.KineticEnergy();
    largest = std::max(largest, energy);
    least = std::min(least, energy);
  }
  EXPECT_GT(before, 1e-4);
  EXPECT_LT(largest, 1.03 * before);
  EXPECT_GT(least, 0.97 * before);
}

Trial SwingTrial(const std::string& plan, bool finite_elements) {
  TrialPlanOptions options;
  options.frame_count = 25;
  options.resolution = 7;
  options.finite_elements = finite_elements;
  options.match = plan == "clean" ? "stiff-two-corner-swing-markers" : "swing-markers-large";
  if (plan == "listed") options.only = {"wind"};
  return MakeTrialPlan("PLAN", plan, options).front();
}

// Two codes without a line in common, and one cloth; a stiff one, as a soft one wrinkles anew on
// every mesh.
TEST(FiniteElements, AgreeWithClothfitsOwnSimulation) {
  const std::vector<TruthPoint> own = TruePoints(SwingTrial("clean", false));
  const std::vector<TruthPoint> fem = TruePoints(SwingTrial("clean", true));
  EXPECT_LT(DistanceBetween(own, fem), 0.01);  // m, of a cloth that swings by more than 0.1 m
}

TEST(FiniteElements, MeasureTheForceThatWasPlanted) {
  const TrialRecording made = MakeTrialRecording(SwingTrial("listed", true));
  const TrialRecording own = MakeTrialRecording(SwingTrial("listed", false));
  EXPECT_TRUE(made.truth.force.acts);
  EXPECT_NEAR(made.truth.force.peak, own.truth.force.peak, 0.3 * own.truth.force.peak);
  EXPECT_GT(made.truth.force.mean_direction.dot(own.truth.force.mean_direction), 0.0);
}

TEST(FiniteElements, LeaveOutWhatTheyCannotPlant) {
  TrialPlanOptions options;
  const auto all = MakeTrialPlan("PLAN", "listed", options).size();
  options.finite_elements = true;
  const std::vector<Trial> known = MakeTrialPlan("PLAN", "listed", options);
  EXPECT_LT(known.size(), all);
  for (const Trial& trial : known) {
    EXPECT_TRUE(FemKnows(trial.effects.front().term)) << trial.name;
    EXPECT_TRUE(trial.finite_elements);
  }
}

}  // namespace
}  // namespace clothfit
