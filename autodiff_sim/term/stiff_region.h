// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What terms of stiffer places have in common: their parameters, and how much of the extra
// stiffness an element gets. Stiffness is that of the term it adds to, times 1 + factor at the
// middle.
#pragma once

#include "autodiff_sim/term/cloth_region.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

constexpr Parameter kExtraStiffness = {"extra",
                                       "1",
                                       "stiffness in its middle beside the cloth's own, over that",
                                       0.0,
                                       0.0,
                                       -0.9,
                                       1000.0,
                                       Scale::kLinear,
                                       3.0};

// A patch: extra stiffness, u, v, radius.
constexpr std::array<Parameter, 4> kStiffPatchParameters = {{
    kExtraStiffness,
    kPatchU,
    kPatchV,
    kPatchRadius,
}};

// A seam: extra stiffness, angle, offset, width.
constexpr std::array<Parameter, 4> kStiffSeamParameters = {{
    kExtraStiffness,
    kLineAngle,
    kLineOffset,
    Shape({"width", "m", "distance at which it has fallen to 61 %", 0.01, 0.01, 1e-3, 1.0,
           Scale::kLog, 2.0},
          Meaning::kClothDistance, 0.02, 0.1),
}};

// An elastic element and where it is.
template <class Elastic>
struct Placed {
  std::array<int, std::tuple_size_v<decltype(Elastic::nodes)>> nodes;
  Elastic elastic;
  Eigen::Vector2d uv;           // m, its middle
  Eigen::Vector2d from_middle;  // m, the same from the middle of the cloth
};

template <class Elastic>
std::vector<Placed<Elastic>> Place(const std::vector<Elastic>& elements, const ClothMesh& mesh) {
  const Eigen::Vector2d middle = MiddleOfCloth(mesh);
  std::vector<Placed<Elastic>> placed;
  for (const Elastic& element : elements) {
    const Eigen::Vector2d uv = MiddleOf(element.nodes, mesh);
    placed.push_back({element.nodes, element, uv, uv - middle});
  }
  return placed;
}

template <class T>
T StiffPatchFactor(const Eigen::Vector2d& uv, const std::array<T, 4>& p) {
  return p[0] * PatchWeight<T>(uv, p[1], p[2], p[3]);
}

template <class T>
T StiffSeamFactor(const Eigen::Vector2d& from_middle, const std::array<T, 4>& p) {
  return p[0] * SeamWeight<T>(from_middle, p[1], p[2], p[3]);
}

}  // namespace clothfit
