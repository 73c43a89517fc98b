// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/initial_placement.h"

#include <stdexcept>
#include <utility>

#include "autodiff_sim/mesh/obj_file.h"
#include "tracking/recording/surface/thin_plate_spline.h"

namespace clothfit {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

Positions PlaceAt(const FlatPlacement& flat, const std::vector<Eigen::Vector2d>& uv) {
  Positions positions;
  positions.reserve(uv.size());
  for (const Eigen::Vector2d& point : uv) {
    positions.emplace_back(flat.origin + point.x() * flat.u_axis + point.y() * flat.v_axis);
  }
  return positions;
}

Positions PlaceAt(const PointPlacement& placement, const std::vector<Eigen::Vector2d>& uv) {
  Eigen::Matrix2Xd sites(2, placement.points.size());
  Eigen::Matrix3Xd values(3, placement.points.size());
  for (size_t i = 0; i < placement.points.size(); ++i) {
    sites.col(static_cast<Eigen::Index>(i)) = placement.points[i].uv;
    values.col(static_cast<Eigen::Index>(i)) = placement.points[i].position;
  }
  const ThinPlateSpline surface(sites, values);
  Positions positions;
  positions.reserve(uv.size());
  for (const Eigen::Vector2d& point : uv) positions.push_back(surface(point));
  return positions;
}

Positions PlaceAt(const MeshPlacement&, const std::vector<Eigen::Vector2d>&) {
  throw std::logic_error("the initial positions of a mesh are its own vertices");
}

}  // namespace

Positions InitialPositions(const Recording& recording, const std::vector<Eigen::Vector2d>& uv) {
  return std::visit([&](const auto& placement) { return PlaceAt(placement, uv); },
                    recording.cloth.initial);
}

PlacedCloth PlaceCloth(const Recording& recording, const std::array<int, 2>& resolution) {
  PlacedCloth placed;
  std::vector<Eigen::Vector3d> positions;
  if (const MeshPlacement* mesh = std::get_if<MeshPlacement>(&recording.cloth.initial)) {
    ObjCloth cloth = ReadObj(mesh->file.string());
    placed.mesh = std::move(cloth.mesh);
    positions = std::move(cloth.positions);
  } else {
    std::array<int, 2> particles = resolution;
    for (int k = 0; k < 2; ++k) {
      if (particles[k] == 0) particles[k] = recording.cloth.resolution[k];
    }
    std::vector<Eigen::Vector2d> held;
    for (const HandleDescription& handle : recording.handles) held.push_back(handle.uv);
    placed.mesh = MakeGrid(recording.cloth.size, particles, held);
    positions = InitialPositions(recording, placed.mesh.uv);
  }
  placed.x.resize(3 * placed.mesh.num_particles());
  for (int i = 0; i < placed.mesh.num_particles(); ++i) placed.x.segment<3>(3 * i) = positions[i];
  return placed;
}

}  // namespace clothfit
