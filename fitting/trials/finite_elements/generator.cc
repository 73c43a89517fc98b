// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/finite_elements/generator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/scenes/cloth_scene.h"
#include "fitting/trials/finite_elements/cloth.h"

namespace clothfit {
namespace {

std::vector<FemHandle> HandlesOf(const SyntheticMotion& motion, const FemMesh& mesh) {
  std::vector<FemHandle> handles;
  for (const SyntheticHandle& handle : motion.handles) {
    const auto nearest = std::min_element(
        mesh.uv.begin(), mesh.uv.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          return (a - handle.uv).squaredNorm() < (b - handle.uv).squaredNorm();
        });
    constexpr double kSame = 1e-9;  // m
    if ((*nearest - handle.uv).norm() > kSame)
      throw InputError(handle.name, "finite elements are held at corners only");
    handles.push_back({static_cast<int>(nearest - mesh.uv.begin()), handle.path});
  }
  return handles;
}

FemCloth MakeCloth(const SyntheticOptions& options, const SyntheticMotion& motion,
                   const FemParameters& parameters) {
  const Eigen::Vector2i cells = options.refinement * (options.resolution.array() - 1).matrix();
  FemMesh mesh = MakeFemMesh(options.size, cells, options.seed);
  const FlatPlacement& flat = motion.initial;
  Eigen::VectorXd x = LayFlat(mesh.uv, flat.origin, flat.u_axis, flat.v_axis);
  std::optional<FemGround> ground;
  if (motion.ground_height) {
    ground = FemGround{*motion.ground_height, parameters.at("ground.stiffness"),
                       parameters.at("ground.distance"), parameters.at("ground.friction"),
                       parameters.at("ground.slip_speed")};
  }
  FemLaws laws = MakeFemLaws(mesh, options.size, parameters);
  std::vector<FemHandle> handles = HandlesOf(motion, mesh);
  return FemCloth(std::move(mesh), std::move(laws), std::move(handles), ground, std::move(x));
}

}  // namespace

SyntheticGenerator FiniteElementGenerator(const std::map<std::string, double>& unlisted,
                                          const std::vector<std::string>& terms,
                                          ActingForce* force) {
  SyntheticGenerator generator;
  generator.parameters = unlisted;
  generator.simulate = [terms, force](const SyntheticOptions& options,
                                      const SyntheticMotion& motion,
                                      const std::map<std::string, double>& parameters,
                                      const SyntheticProgress& progress) {
    FemCloth cloth = MakeCloth(options, motion, parameters);
    const FemLaws without =
        MakeFemLaws(cloth.mesh(), options.size, WithoutTerms(parameters, terms));
    ForceMeter meter(VertexAreas(cloth.mesh()), options.frame_count);
    const double interval = 1.0 / options.frame_rate;
    const int steps = static_cast<int>(std::ceil(interval / cloth.StableStep()));
    SyntheticSurface surface{{}, interval, {cloth.positions()}};
    surface.mesh.uv = cloth.mesh().uv;
    surface.mesh.triangles = cloth.mesh().triangles;
    for (int frame = 1; frame < options.frame_count; ++frame) {
      for (int k = 0; k < steps; ++k) cloth.Step(interval / steps);
      surface.positions.push_back(cloth.positions());
      if (force != nullptr) {
        meter.Add(frame, cloth.ForceBeyond(without), cloth.positions(), cloth.velocities(),
                  interval);
      }
      if (progress) progress(static_cast<double>(frame) / (options.frame_count - 1), "simulation");
    }
    if (force != nullptr) *force = meter.Result(surface.mesh);
    return surface;
  };
  return generator;
}

}  // namespace clothfit
