// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A small cloth in waves above the floor of a room, and a camera that looks at it.
#pragma once

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "tracking/synthetic/cameras.h"
#include "tracking/synthetic/renderer.h"

namespace clothfit {

struct RenderedScene {
  explicit RenderedScene(ClothPattern pattern = ClothPattern::kRich,
                         const std::array<double, 5>& distortion = {})
      : mesh(MakeGrid({1.0, 0.8}, {21, 17})),
        x(3 * mesh.num_particles()),
        surface(mesh),
        room(MakeRoom({0.5, 0.4, 0.0}, 1.0)),
        look{MakeClothTexture(pattern, {1.0, 0.8}, 1), 0.0},
        floor(MakeFloorTexture()) {
    std::vector<Eigen::Vector3d> region;
    for (int i = 0; i < mesh.num_particles(); ++i) {
      const Eigen::Vector2d uv = mesh.uv[i];
      const double height = 0.35 + 0.08 * std::sin(11.0 * uv.x()) + 0.3 * uv.y();
      x.segment<3>(3 * i) = Eigen::Vector3d(uv.x(), uv.y(), height);
      region.emplace_back(x.segment<3>(3 * i));
      region.emplace_back(uv.x(), uv.y(), 0.0);
    }
    surface.MoveTo(x);
    RoomCameras cameras;
    cameras.count = 1;
    cameras.size = {80, 60};
    cameras.distortion = distortion;
    camera = MakeRoomCameras(cameras, region, 0.0).front();
  }
  RenderedScene(const RenderedScene&) = delete;
  RenderedScene& operator=(const RenderedScene&) = delete;

  Renderer MakeRenderer(int samples, int num_threads = 1) const {
    return Renderer(camera, room, look, floor, samples, num_threads);
  }

  ClothMesh mesh;
  Eigen::VectorXd x;
  ClothSurface surface;
  Room room;
  ClothLook look;
  PlaneTexture floor;
  Camera camera;
};

}  // namespace clothfit
