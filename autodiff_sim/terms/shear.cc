// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/shear.h"

namespace clothfit {

// The two of a cell follow one another.
std::vector<BiasSprings> PairBiasSprings(const TermContext& context) {
  const std::vector<Spring>& springs = context.topology.shear;
  std::vector<BiasSprings> pairs;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const auto [a, b] = springs[i].nodes;
    BiasSprings pair = {{a, b, b, b}, 1, {springs[i], {}}};
    if (context.mesh.is_grid()) {
      const Spring& other = springs[++i];
      pair = {{a, b, other.nodes[0], other.nodes[1]}, 2, {springs[i - 1], other}};
    }
    pairs.push_back(pair);
  }
  return pairs;
}

double Shear::Energy(const Element& element, const ElementInput<Shear, double>& in) {
  const SpringLaw<double> law = {in.parameter[0], 0.0, in.read[0]};
  const Eigen::Vector3d dx = in.x[1] - in.x[0];
  if (element.springs == 1) return SpringEnergy(element.bias[0], law, in.shrinkage, dx);
  std::array<double, 2> strain;
  for (int i = 0; i < 2; ++i) {
    strain[i] =
        (in.x[2 * i + 1] - in.x[2 * i]).norm() / RestLength<double>(element.bias[i], in.shrinkage) -
        1.0;
  }
  const double rest_length = RestLength<double>(element.bias[0], in.shrinkage);
  const double area = element.bias[0].weight * rest_length * rest_length;
  const double mean = 0.5 * (strain[0] + strain[1]), shear = 0.5 * (strain[0] - strain[1]);
  double energy = law.stiffness * shear * shear;
  if (Buckles(element.bias[0], law)) {
    energy +=
        2.0 * BuckledEnergy(
                  law.stiffness,
                  BucklingLoad(law.bending, law.stiffness, element.bias[0].buckling_length), mean);
  } else {
    energy += law.stiffness * mean * mean;
  }
  return area * energy;
}

}  // namespace clothfit
