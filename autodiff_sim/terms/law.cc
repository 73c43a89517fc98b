// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/law.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/mesh/cloth_box.h"

namespace clothfit {

std::vector<LawTension::Element> LawTension::Elements(const TermContext& context) {
  constexpr double kBand = 0.06;  // one sigma of its width, of the cloth's longer side
  const std::vector<Eigen::Vector2d>& uv = context.mesh.uv;
  const auto [low, high] = BoxOf(context.mesh);
  const Eigen::Vector2d middle = 0.5 * (low + high);
  const double width = kBand * (high - low).maxCoeff();
  const double half = std::sqrt(0.5);
  const std::array<Eigen::Vector2d, kDirections> directions = {
      Eigen::Vector2d(1, 0), Eigen::Vector2d(half, half), Eigen::Vector2d(0, 1),
      Eigen::Vector2d(-half, half)};
  std::vector<Element> elements;
  for (const std::array<int, 3>& t : context.mesh.triangles) {
    Eigen::Matrix2d edges;
    edges << uv[t[1]] - uv[t[0]], uv[t[2]] - uv[t[0]];
    // Rows: the gradients of the second and the third corner's share.
    const Eigen::Matrix2d gradients = edges.inverse();
    Element element{t, 0.5 * std::abs(edges.determinant()), {}, {}};
    for (int d = 0; d < kDirections; ++d) {
      const Eigen::Vector2d of_corners = gradients * directions[d];
      element.along[d] = {-of_corners.sum(), of_corners[0], of_corners[1]};
    }
    const Eigen::Vector2d place = (uv[t[0]] + uv[t[1]] + uv[t[2]]) / 3.0 - middle;
    for (int band = 0; band < 2; ++band) {
      const Eigen::Vector2d along = directions[2 * band + 1];
      const double away = place.x() * along.y() - place.y() * along.x();
      element.band[band] = std::exp(-0.5 * away * away / (width * width));
    }
    elements.push_back(element);
  }
  return elements;
}

}  // namespace clothfit
