// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far cloth on a coarse mesh is from the same cloth on a fine one, with springs and with a
// membrane that buckles below the mesh, and what a step costs: the table of
// docs/adr/0022-each-spring-buckles-by-itself.md.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "autodiff_sim/base/names.h"
#include "autodiff_sim/scenes/cloth_scene.h"
#include "autodiff_sim/step/simulation.h"
#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

constexpr double kSide = 0.9;  // m
constexpr int kCommon = 6;     // edges along a side between the points that are compared
constexpr int kFinest = 49;    // particles along a side
constexpr int kSteps = 300;    // of 1/120 s
constexpr int kBetween = 15;   // steps between the moments that are compared

// Hangs by two corners, bowed by 3 cm, and is swung by them across its plane.
ClothScene SwungCloth(int n) {
  constexpr double kBow = 0.03;
  ClothScene scene;
  scene.mesh = MakeGrid({kSide, kSide}, {n, n});
  scene.x.resize(3 * scene.mesh.num_particles());
  const auto along = [](double u) {  // of an arc of length u of the bow
    constexpr int kPieces = 200;
    double x = 0.0;
    for (int k = 0; k < kPieces; ++k) {
      const double slope = kBow * M_PI / kSide * std::cos(M_PI * u * (k + 0.5) / kPieces / kSide);
      x += std::sqrt(1.0 - slope * slope) * u / kPieces;
    }
    return x;
  };
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const Eigen::Vector2d& uv = scene.mesh.uv[i];
    scene.x.segment<3>(3 * i) << along(uv.x()), kBow * std::sin(M_PI * uv.x() / kSide),
        1.2 - uv.y();
  }
  scene.handles = LocateOnCloth(scene.mesh, {{0.0, 0.0}, {kSide, 0.0}});
  const double width = along(kSide);
  scene.path = [width](double time) {
    const double swing = 0.12 * std::sin(2.0 * M_PI * 1.3 * time) * std::min(1.0, time / 0.3);
    return std::vector<Eigen::Vector3d>{{0.0, swing, 1.2}, {width, 0.6 * swing, 1.2}};
  };
  return scene;
}

struct Course {
  std::vector<Eigen::Vector3d> points;  // m, of all moments
  StepReport report;
  double seconds = 0.0;
};

Course Follow(ClothScene scene, bool buckles) {
  scene.mesh.buckles = buckles;
  SimulationOptions options;
  options.tolerance = 1e-7;
  Simulation simulation(scene.mesh, scene.world, scene.handles, options);
  Eigen::VectorXd parameters = simulation.parameters();
  const auto set = [&](const char* name, double value) {
    parameters[RequireParameter(simulation.model().parameters(), name)] = value;
  };
  set("cloth.areal_density", 0.2);
  set("stretch.stiffness", 600.0);
  set("stretch.damping", 1.0);
  set("shear.stiffness", 60.0);
  set("shear.damping", 0.3);
  set("bending.stiffness", 1.4e-3);
  set("bending.damping", 4e-6);
  set("air_drag.normal", 0.7);
  set("air_drag.saturation", 0.1);
  set("air_drag.tangential", 0.02);
  simulation.SetParameters(parameters);
  State state = simulation.MakeState(scene.x);
  const Drive drive = scene.MakeDrive();
  Course course;
  const int n = scene.mesh.grid[0], stride = (n - 1) / kCommon;
  const auto start = std::chrono::steady_clock::now();
  for (int step = 1; step <= kSteps; ++step) {
    course.report += simulation.Advance(1.0 / 120.0, drive, &state);
    if (step % kBetween != 0) continue;
    for (int j = 0; j <= kCommon; ++j) {
      for (int i = 0; i <= kCommon; ++i)
        course.points.emplace_back(state.x.segment<3>(3 * stride * (i + j * n)));
    }
  }
  course.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return course;
}

double RmsDistance(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

template <class MakeScene>
void Compare(const char* name, const MakeScene& make_scene) {
  const Course springs = Follow(make_scene(kFinest), false);
  const Course buckling = Follow(make_scene(kFinest), true);
  std::printf("%s: on %d x %d the two are %.2f mm apart\n", name, kFinest, kFinest,
              1e3 * RmsDistance(springs.points, buckling.points));
  std::printf(
      "  particles  membrane  mm from springs  mm from buckling  ms/step  newton  halved\n");
  for (const int n : {7, 13, 25}) {
    for (const bool buckles : {false, true}) {
      const Course course = Follow(make_scene(n), buckles);
      std::printf(
          "  %3d x %3d  %-8s  %15.2f  %16.2f  %7.2f  %6.1f  %6d%s\n", n, n,
          buckles ? "buckling" : "springs", 1e3 * RmsDistance(course.points, springs.points),
          1e3 * RmsDistance(course.points, buckling.points), 1e3 * course.seconds / kSteps,
          static_cast<double>(course.report.newton_iterations) / kSteps, course.report.halvings,
          course.report.status == StepStatus::kConverged ? "" : "  did not converge");
    }
  }
}

}  // namespace
}  // namespace clothfit

int main() {
  using namespace clothfit;
  Compare("lifted by a corner", [](int n) { return LiftedCloth(n, kSide); });
  Compare("swung by two corners", SwungCloth);
  return 0;
}
