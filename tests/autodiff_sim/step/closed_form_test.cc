// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions and rests that have a closed form.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "autodiff_sim/step/simulation.h"
#include "tests/autodiff_sim/step/motion.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

// A horizontal plate that falls: m g = A k_n v^2 / (1 + k_f v^2).
TEST(ClosedForm, TerminalVelocityOfAFallingPlate) {
  for (const double saturation : {0.0, 0.2}) {
    const ClothMesh mesh = MakeGrid({0.3, 0.3}, {4, 4});
    Simulation simulation(mesh, World(), {});
    UseSuppleCloth(&simulation);
    // Alone with its drag every triangle's corner falls as its own mass and area say: keep it flat.
    Set("bending.stiffness", 0.1, &simulation);
    Set("bending.damping", 4e-4, &simulation);
    Set("air_drag.normal", 2.0, &simulation);
    Set("air_drag.saturation", saturation, &simulation);
    State state = simulation.MakeState(
        LayFlat(mesh, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
    Advance(1.0 / 60.0, 120, FreeDrive(), &simulation, &state);
    const double weight = 0.15 * 9.81;  // Pa
    const double terminal = std::sqrt(weight / (2.0 - saturation * weight));
    for (int i = 0; i < mesh.num_particles(); ++i) {
      // The approach is exp(-2 g t / v): nothing is left after 2 s. Areas and drag are lumped
      // alike, a third a corner, so the plate falls flat.
      EXPECT_NEAR(state.v[3 * i + 2], -terminal, 1e-7 * terminal);
    }
  }
}

// A horizontal plate that falls with the air that it moves: (rho + m) dv/dt = -rho g.
TEST(ClosedForm, AddedMassDelaysAFallingPlate) {
  const ClothMesh mesh = MakeGrid({0.3, 0.3}, {4, 4});
  Simulation simulation(mesh, World(), {});
  UseSuppleCloth(&simulation);
  KeepOnly({"stretch", "bending", "gravity"}, &simulation);
  Set("added_mass.normal", 0.05, &simulation);
  State state = simulation.MakeState(
      LayFlat(mesh, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
  Advance(1.0 / 60.0, 30, FreeDrive(), &simulation, &state);
  for (int i = 0; i < mesh.num_particles(); ++i)
    EXPECT_NEAR(state.v[3 * i + 2], -0.5 * 9.81 * 0.15 / 0.2, 1e-6);
}

// An upright plate that falls with the air that its sides drag along: the same.
TEST(ClosedForm, AirThatIsDraggedAlongDelaysAnUprightPlate) {
  const ClothMesh mesh = MakeGrid({0.3, 0.3}, {4, 4});
  Simulation simulation(mesh, World(), {});
  UseSuppleCloth(&simulation);
  KeepOnly({"stretch", "bending", "gravity"}, &simulation);
  Set("added_mass.tangential", 0.05, &simulation);
  Set("added_mass.normal", 0.3, &simulation);  // which an upright plate has no use for
  State state = simulation.MakeState(
      LayFlat(mesh, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()));
  Advance(1.0 / 60.0, 30, FreeDrive(), &simulation, &state);
  for (int i = 0; i < mesh.num_particles(); ++i)
    EXPECT_NEAR(state.v[3 * i + 2], -0.5 * 9.81 * 0.15 / 0.2, 1e-6);
}

// A square cloth of this side (m) hangs from its edge v = 0 under its own weight, shear off, until
// it rests. Returns how much lower its other edge hangs than at rest, the mean over its particles,
// and checks every thread link by link: it carries what is below it.
double Sag(const ClothMesh& mesh, double side) {
  std::vector<Eigen::Vector2d> top;
  for (const Eigen::Vector2d& uv : mesh.uv) {
    if (uv.y() == 0.0) top.push_back(uv);
  }
  SimulationOptions options;
  options.integrator = Integrator::kBackwardEuler;  // comes to rest soonest
  Simulation simulation(mesh, World(), LocateOnCloth(mesh, top), options);
  UseSuppleCloth(&simulation);
  KeepOnly({"stretch", "gravity"}, &simulation);
  Set("stretch.stiffness", 200.0, &simulation);
  TestScene scene;
  scene.handles = LocateOnCloth(mesh, top);
  scene.x =
      LayFlat(mesh, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
  std::vector<Eigen::Vector3d> places;
  for (const SurfacePoint& handle : scene.handles) places.push_back(handle.At(scene.x));
  scene.path = [places](double) { return places; };
  State state = simulation.MakeState(scene.x);
  Advance(0.1, 200, scene.MakeDrive(), &simulation, &state);
  EXPECT_LE(state.v.lpNorm<Eigen::Infinity>(), 1e-8);
  const ClothTopology& topology = simulation.model().topology();
  int links = 0;
  for (const Spring& link : topology.structural) {
    const Eigen::Vector2d a = mesh.uv[link.nodes[0]], b = mesh.uv[link.nodes[1]];
    if (std::abs(a.x() - b.x()) > 1e-12) continue;
    const double middle = 0.5 * (a.y() + b.y());
    double area_below = 0.0;
    for (int i = 0; i < mesh.num_particles(); ++i) {
      if (std::abs(mesh.uv[i].x() - a.x()) < 1e-12 && mesh.uv[i].y() > middle)
        area_below += topology.areas[i];
    }
    const double extension =
        (state.x.segment<3>(3 * link.nodes[1]) - state.x.segment<3>(3 * link.nodes[0])).norm() -
        link.rest_length;
    const double expected = 0.15 * 9.81 * area_below / (200.0 * link.weight);
    // Neighbouring threads are not equally heavy (the diagonals lump the mass unevenly), so threads
    // across tilt by up to 1e-3 and take a share of the order of the tilt's square.
    EXPECT_NEAR(extension, expected, 1e-3 * expected + 1e-9);
    ++links;
  }
  EXPECT_GT(links, 0);
  double sag = 0.0;
  int count = 0;
  for (int i = 0; i < mesh.num_particles(); ++i) {
    if (std::abs(mesh.uv[i].y() - side) > 1e-12) continue;
    sag -= state.x[3 * i + 2] + side;
    ++count;
  }
  return sag / count;
}

// A continuous cloth stretches by s g L^2 / (2 k), at any resolution, as a grid or as triangles.
TEST(ClosedForm, ClothUnderItsOwnWeight) {
  const double continuous = 0.15 * 9.81 * 0.4 * 0.4 / (2.0 * 200.0);
  for (const int n : {4, 7, 13}) {
    const ClothMesh grid = MakeGrid({0.4, 0.4}, {n, n});
    ClothMesh triangles = grid;
    triangles.grid = {0, 0};
    // Lumped masses: a border thread's share of its cells is uneven by a third of a cell, which is
    // 1 / (3 n) of the thread.
    EXPECT_NEAR(Sag(grid, 0.4), continuous, continuous / (3.0 * n)) << n;
    EXPECT_NEAR(Sag(triangles, 0.4), Sag(grid, 0.4), 1e-6 * continuous) << n;
  }
}

// Shearing a cloth between two clamped edges: force over width is shear stiffness times angle, at
// any resolution, for a grid and for triangles. Wide, so that the free ends count for little.
double ShearForce(const ClothMesh& mesh, double height) {
  TestScene scene;
  std::vector<Eigen::Vector2d> held;
  for (const Eigen::Vector2d& uv : mesh.uv) {
    if (uv.y() == 0.0 || std::abs(uv.y() - height) < 1e-12) held.push_back(uv);
  }
  scene.handles = LocateOnCloth(mesh, held);
  SimulationOptions options;
  options.integrator = Integrator::kBackwardEuler;
  Simulation simulation(mesh, World(), scene.handles, options);
  UseSuppleCloth(&simulation);
  KeepOnly({"stretch", "shear"}, &simulation);
  Set("stretch.stiffness", 200.0, &simulation);
  Set("shear.stiffness", 20.0, &simulation);
  scene.x =
      LayFlat(mesh, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  constexpr double kAngle = 1e-3;
  for (int i = 0; i < mesh.num_particles(); ++i) scene.x[3 * i] += kAngle * mesh.uv[i].y();
  std::vector<Eigen::Vector3d> places;
  for (const SurfacePoint& handle : scene.handles) places.push_back(handle.At(scene.x));
  scene.path = [places](double) { return places; };
  State state = simulation.MakeState(scene.x);
  Advance(0.1, 100, scene.MakeDrive(), &simulation, &state);
  double force = 0.0;
  for (int i = 0; i < mesh.num_particles(); ++i) {
    if (std::abs(mesh.uv[i].y() - height) < 1e-12) force += simulation.handle_forces()[3 * i];
  }
  return force / kAngle;
}

TEST(ClosedForm, ShearIsThatOfTheParameterAtAnyResolution) {
  for (const int n : {3, 5, 9}) {
    const ClothMesh grid = MakeGrid({0.8, 0.2}, {4 * (n - 1) + 1, n});
    ClothMesh triangles = grid;
    triangles.grid = {0, 0};
    // The free ends relax: about a height's worth of the width in all, of which a part is lost.
    EXPECT_NEAR(ShearForce(grid, 0.2), 20.0 * 0.8, 0.12 * 20.0 * 0.8) << n;
    EXPECT_NEAR(ShearForce(triangles, 0.2), ShearForce(grid, 0.2), 0.05 * 20.0 * 0.8) << n;
  }
}

// A sheet slides to rest: m dv/dt = -mu m g v / sqrt(v^2 + s^2), so that time and distance have
// closed forms; with s = 0, v0 / (mu g) and v0^2 / (2 mu g).
TEST(ClosedForm, SlidingSheetStops) {
  const double mu = 0.4, slip = 0.005, v0 = 0.6, g = 9.81;
  const ClothMesh mesh = MakeGrid({0.2, 0.2}, {4, 4});
  World world;
  world.ground_height = 0.0;
  Simulation simulation(mesh, world, {});
  UseSuppleCloth(&simulation);
  KeepOnly({"stretch", "shear", "bending", "gravity", "ground"}, &simulation);
  Set("ground.friction", mu, &simulation);
  Set("ground.slip_speed", slip, &simulation);
  // Where the ground bears the weight: s g = k depth^2 / d.
  const double depth = std::sqrt(0.15 * g * 0.002 / Get("ground.stiffness", simulation));
  State state = simulation.MakeState(
      LayFlat(mesh, {0.0, 0.0, 0.002 - depth}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
  for (Eigen::Index i = 0; i < state.v.size(); i += 3) state.v[i] = v0;
  const double x0 = state.x[0];
  // Separation of variables: F(v) = sqrt(v^2 + s^2) + s log(v / (s + sqrt(v^2 + s^2))) falls by
  // mu g t; distance from v dv / (dv/dt) = sqrt(v^2 + s^2) dv / (mu g).
  const auto time_left = [&](double v) {
    const double root = std::hypot(v, slip);
    return root + slip * std::log(v / (slip + root));
  };
  const auto way_left = [&](double v) {
    const double root = std::hypot(v, slip);
    return 0.5 * (v * root + slip * slip * std::log((v + root) / slip));
  };
  const double step = 1.0 / 960.0;
  int checks = 0;
  while (state.v[0] > 0.5 * slip && state.time < 0.5) {
    Advance(step, 1, FreeDrive(), &simulation, &state);
    const double v = state.v[0];
    if (v > slip) {
      EXPECT_NEAR(time_left(v0) - time_left(v), mu * g * state.time, 2e-3 * v0);
      EXPECT_NEAR((way_left(v0) - way_left(v)) / (mu * g), state.x[0] - x0, 2e-3 * 0.046);
      ++checks;
    }
  }
  EXPECT_GT(checks, 100);
  EXPECT_NEAR(state.time, v0 / (mu * g), 0.03 * v0 / (mu * g));
  EXPECT_NEAR(state.x[0] - x0, v0 * v0 / (2.0 * mu * g), 0.01 * v0 * v0 / (2.0 * mu * g));
}

}  // namespace
}  // namespace clothfit
