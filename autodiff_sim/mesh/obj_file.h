// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Cloth meshes from Wavefront OBJ files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

struct ObjCloth {
  ClothMesh mesh;                          // (u, v) from the file's vt, metres
  std::vector<Eigen::Vector3d> positions;  // m, world frame: the file's v, one per particle
};

// Reads v, vt and f; faces of more than three corners are fanned. A corner needs a vt, and a v has
// one vt (a seam is two particles). Throws InputError with file and line; the mesh is validated.
ObjCloth ReadObj(const std::string& path);

// Any surface: positions (m) and triangles.
struct ObjSurface {
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::array<int, 3>> triangles;
};

// Reads v and f alone. Throws InputError with file and line, and where there is no triangle.
ObjSurface ReadObjSurface(const std::string& path);

}  // namespace clothfit
