// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A force per area that is given rather than modelled, by StepInputs::residual_force: what a model
// lacks is estimated as such a force. With the weights w_k of the grid's nodes at a triangle's
// middle, its area A at rest, unit normal n and unit warp t,
//   f = share A sum_k w_k (c_k0 n + c_k1 t + c_k2 n x t),
// and each corner gets a third. It moves and turns with the cloth, so that a cloth in the same
// shape elsewhere feels the same.
#pragma once

#include <algorithm>
#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

struct ResidualForce : TermDefaults {
  static constexpr const char* kName = "residual_force";
  static constexpr const char* kDoc = "a given force per area, in the cloth's own frame";
  static constexpr const char* kReference = "weak-constraint model error, Tremolet 2006";
  static constexpr Role kRole = Role::kEstimate;
  static constexpr Work kWork = Work::kMixed;
  static constexpr int kNodes = 3;
  static constexpr int kInputs = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 1> kParameters = {{
      {"share", "1", "of the given force that acts; without one it is nothing", 0.0, 0.0, 0.0, 1.0,
       Scale::kLinear, 1.0},
  }};

  // What one node of the grid does to one triangle.
  struct Element {
    std::array<int, 3> nodes;
    std::array<double, 3> input;  // N/m^2, along normal, warp and weft
    int first_input;
    double area;  // m^2 at rest, a third of the triangle's times the node's weight
    // x_u = slope_u[0] (x1 - x0) + slope_u[1] (x2 - x0), 1/m
    std::array<double, 2> slope_u;
  };

  static std::vector<Element> Elements(const TermContext& context) {
    std::vector<Element> elements;
    if (context.inputs == nullptr || context.inputs->residual_force.force.empty()) return elements;
    const ForceGrid& grid = context.inputs->residual_force;
    const int first = context.inputs->first_force_row();
    for (const std::array<int, 3>& t : context.mesh.triangles) {
      const std::vector<Eigen::Vector2d>& uv = context.mesh.uv;
      const Eigen::Vector2d side1 = uv[t[1]] - uv[t[0]], side2 = uv[t[2]] - uv[t[0]];
      const double twice_area = side1.x() * side2.y() - side1.y() * side2.x();
      const Eigen::Vector2d middle = (uv[t[0]] + uv[t[1]] + uv[t[2]]) / 3.0;
      const HatWeights u = WeightsAlong(grid, 0, middle), v = WeightsAlong(grid, 1, middle);
      for (int corner = 0; corner < 4; ++corner) {
        const int i = corner % 2, j = corner / 2;
        const double weight = u.weight[i] * v.weight[j];
        if (weight == 0.0) continue;
        const int node = u.first + i + (v.first + j) * grid.nodes[0];
        const Eigen::Vector3d& f = grid.force[node];
        elements.push_back({t,
                            {f[0], f[1], f[2]},
                            first + kInputs * node,
                            weight * twice_area / 6.0,
                            {side2.y() / twice_area, -side1.y() / twice_area}});
      }
    }
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<ResidualForce, T>& in,
                       ElementOutput<ResidualForce, T>* out) {
    using std::sqrt;
    const Vector3<T> side1 = in.x[1] - in.x[0], side2 = in.x[2] - in.x[0];
    const Vector3<T> across = side1.cross(side2);
    const T twice_area = sqrt(across.dot(across));
    const Vector3<T> warp = element.slope_u[0] * side1 + element.slope_u[1] * side2;
    const T stretch = sqrt(warp.dot(warp));
    const Vector3<T> weft = across.cross(warp);
    const T scale = in.parameter[0] * element.area;
    const T normal_part = scale * in.input[0] / twice_area;
    const T warp_part = scale * in.input[1] / stretch;
    const T weft_part = scale * in.input[2] / (twice_area * stretch);
    for (int k = 0; k < 3; ++k) {
      const T force = normal_part * across[k] + warp_part * warp[k] + weft_part * weft[k];
      for (Vector3<T>& corner : out->force) corner[k] += force;
    }
  }

 private:
  // The two nodes along u or v between which a place is, and their weights, which sum to 1.
  struct HatWeights {
    int first;
    std::array<double, 2> weight;
  };
  static HatWeights WeightsAlong(const ForceGrid& grid, int axis, const Eigen::Vector2d& uv) {
    const int cells = grid.nodes[axis] - 1;
    const double place =
        std::clamp((uv[axis] - grid.low[axis]) / (grid.high[axis] - grid.low[axis]), 0.0, 1.0) *
        cells;
    const int first = std::min(static_cast<int>(place), cells - 1);
    return {first, {1.0 - (place - first), place - first}};
  }
};

}  // namespace clothfit
