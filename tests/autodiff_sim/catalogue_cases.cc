// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cases' numbers. The cloth that swings is a square of 0.3 m that falls from z = 0.3 m.
#include "tests/autodiff_sim/catalogue_cases.h"

namespace clothfit {

const std::vector<CatalogueCase>& CatalogueCases() {
  static const std::vector<CatalogueCase> cases = {
      {"wind", false, {{"x", 0.4}, {"y", -0.7}, {"z", 0.3}}},
      {"gust",
       false,
       {{"x", 0.5},
        {"y", -1.5},
        {"z", 0.5},
        {"onset", 0.2},
        {"duration", 0.5},
        {"u", 0.2},
        {"v", 0.25},
        {"radius", 0.1}}},
      {"bending_friction", false, {{"moment", 1e-3}, {"onset", 3.0}}},
      {"shear_friction", false, {{"stress", 0.5}, {"onset", 0.03}}},
      {"stretch_relaxation", false, {{"share", 0.5}, {"time", 0.2}}},
      {"shear_relaxation", false, {{"share", 0.5}, {"time", 0.2}}},
      {"bending_relaxation", false, {{"share", 0.5}, {"time", 0.2}}},
      {"crease", false, {{"curvature", 30.0}, {"angle", 0.4}, {"offset", 0.03}, {"width", 0.02}}},
      {"stretch_stiffening", false, {{"cubic", 1e6}, {"onset", 0.002}}},
      {"strain_limit", false, {{"stiffness", 1e4}, {"stretch", 0.003}, {"compression", 0.004}}},
      {"stretch_orthotropy", false, {{"ratio", 2.0}}},
      {"shear_orthotropy", false, {{"ratio", 2.0}}},
      {"bending_orthotropy", false, {{"ratio", 3.0}}},
      {"hem", false, {{"low_u", 0.01}, {"high_u", 0.02}, {"low_v", 0.015}, {"high_v", 0.03}}},
      {"heavy_patch", false, {{"share", 1.0}, {"u", 0.2}, {"v", 0.2}, {"radius", 0.08}}},
      {"stiff_patch_stretch", false, {{"extra", 2.0}, {"u", 0.1}, {"v", 0.1}, {"radius", 0.08}}},
      {"stiff_patch_bending", false, {{"extra", 5.0}, {"u", 0.2}, {"v", 0.2}, {"radius", 0.08}}},
      {"stiff_seam_stretch",
       false,
       {{"extra", 2.0}, {"angle", 0.3}, {"offset", -0.02}, {"width", 0.05}}},
      {"stiff_seam_bending",
       false,
       {{"extra", 5.0}, {"angle", 1.2}, {"offset", 0.02}, {"width", 0.05}}},
      {"adhesion", true, {{"pressure", 4.0}, {"range", 0.004}}},
      {"sticky_patch",
       true,
       {{"pressure", 5.0}, {"range", 0.004}, {"u", 0.1}, {"v", 0.1}, {"radius", 0.1}}},
      {"obstacle_plane",
       false,
       {{"stiffness", 3e3}, {"height", 0.15}, {"angle_1", 0.1}, {"angle_2", 0.05}}},
      {"obstacle_sphere",
       false,
       {{"stiffness", 3e3}, {"x", 0.14}, {"y", 0.2}, {"z", 0.15}, {"radius", 0.1}}},
      {"obstacle_capsule",
       false,
       {{"stiffness", 3e3},
        {"x1", 0.05},
        {"y1", 0.2},
        {"z1", 0.12},
        {"x2", 0.28},
        {"y2", 0.17},
        {"z2", 0.16},
        {"radius", 0.07}}},
      {"gravity_tilt", false, {{"angle_1", 0.05}, {"angle_2", -0.03}}},
      {"attractor",
       false,
       {{"stiffness", 20.0}, {"x", 0.1}, {"y", 0.1}, {"z", 0.1}, {"range", 0.1}}},
  };
  return cases;
}

std::vector<std::string> CatalogueTerms() {
  std::vector<std::string> terms;
  for (const CatalogueCase& one : CatalogueCases()) terms.push_back(one.term);
  return terms;
}

}  // namespace clothfit
