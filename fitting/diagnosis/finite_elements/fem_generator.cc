// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/finite_elements/fem_generator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "autodiff_sim/error.h"
#include "fitting/diagnosis/finite_elements/fem_cloth.h"

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
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(mesh.uv.size()));
  const FlatPlacement& flat = motion.initial;
  for (std::size_t i = 0; i < mesh.uv.size(); ++i) {
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        flat.origin + mesh.uv[i].x() * flat.u_axis + mesh.uv[i].y() * flat.v_axis;
  }
  std::optional<FemGround> ground;
  if (motion.ground_height) {
    const auto value = [&](const char* name, double otherwise) {
      const auto found = parameters.find(name);
      return found == parameters.end() ? otherwise : found->second;
    };
    ground.emplace();
    ground->height = *motion.ground_height;
    ground->stiffness = value("ground.stiffness", ground->stiffness);
    ground->distance = value("ground.distance", ground->distance);
    ground->friction = value("ground.friction", ground->friction);
    ground->slip_speed = value("ground.slip_speed", ground->slip_speed);
  }
  FemLaws laws =
      MakeFemLaws(mesh, options.size, parameters, options.size.x() / (options.resolution.x() - 1));
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
    const FemLaws without = MakeFemLaws(cloth.mesh(), options.size, WithoutTerms(parameters, terms),
                                        options.size.x() / (options.resolution.x() - 1));
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
