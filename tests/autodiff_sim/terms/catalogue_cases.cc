// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cases' numbers. The cloth that swings is a square of 0.3 m that falls from z = 0.3 m.
#include "tests/autodiff_sim/terms/catalogue_cases.h"

#include <algorithm>

#include "autodiff_sim/term/extent.h"
#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

namespace {

std::vector<CatalogueCase> ChosenCases() {
  return {
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
      {"obstacle_table",
       false,
       {{"stiffness", 3e3},
        {"x1", 0.2},
        {"y1", 0.1},
        {"z1", 0.15},
        {"x2", 0.15},
        {"y2", 0.3},
        {"z2", 0.16}}},
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
      {"grip", false, {{"compliance", 5e-3}}},
      {"grip_slip",
       false,
       {{"x", 0.01},
        {"y", -0.02},
        {"z", -0.015},
        {"onset", 0.1},
        {"duration", 0.2},
        {"u", 0.25},
        {"v", 0.02},
        {"radius", 0.15}}},
      {"law_field",
       false,
       {{"c_x", 0.4},
        {"c_y", -0.3},
        {"c_z", 0.2},
        {"g_xx", -2.0},
        {"g_xy", 1.0},
        {"g_xz", 0.5},
        {"g_yx", -1.0},
        {"g_yy", -1.0},
        {"g_yz", 0.3},
        {"g_zx", 0.2},
        {"g_zy", -0.4},
        {"g_zz", -3.0},
        {"drag", 0.2},
        {"x", 0.1},
        {"y", 0.1},
        {"z", 0.2}}},
      {"law_air",
       false,
       {{"w_x", 0.4},
        {"w_y", -0.7},
        {"w_z", 0.3},
        {"g_xx", 0.5},
        {"g_xy", -3.0},
        {"g_xz", 1.0},
        {"g_yx", 3.0},
        {"g_yy", -0.5},
        {"g_yz", 0.7},
        {"g_zx", 0.3},
        {"g_zy", -0.6},
        {"g_zz", 1.0},
        {"x", 0.1},
        {"y", 0.1},
        {"z", 0.2}}},
      {"law_tension",
       false,
       {{"c_0", 0.1},
        {"k_0", 20.0},
        {"m_0", 0.1},
        {"c_45", 0.2},
        {"k_45", 30.0},
        {"m_45", 0.2},
        {"c_90", 0.15},
        {"k_90", 10.0},
        {"m_90", 0.05},
        {"c_135", 0.1},
        {"k_135", 15.0},
        {"m_135", 0.1},
        {"band_c_45", 0.5},
        {"band_k_45", 25.0},
        {"band_c_135", 0.3},
        {"band_k_135", 40.0}}},
  };
}

}  // namespace

CatalogueCase DefaultCase(const TermInfo& term) {
  const Extent extent{{0.0, 0.0, 0.0}, {0.3, 0.3, 0.3}, {0.3, 0.3}, 0.5};
  const std::map<std::string, double> shape = MiddleShape(term, extent);
  CatalogueCase made{term.name, term.needs == Needs::kGround, {}};
  for (const Parameter& p : term.parameters)
    made.on.emplace_back(p.name, SwitchesOff(p) ? AwayFromOff(p, 1.0) : shape.at(p.name));
  return made;
}

const std::vector<CatalogueCase>& CatalogueCases() {
  static const std::vector<CatalogueCase> cases = [] {
    std::vector<CatalogueCase> all = ChosenCases();
    for (const TermInfo& term : AllTerms()) {
      const bool is_chosen = std::any_of(
          all.begin(), all.end(), [&](const CatalogueCase& one) { return one.term == term.name; });
      if (term.role == Role::kMayBeMissing && !is_chosen) all.push_back(DefaultCase(term));
    }
    return all;
  }();
  return cases;
}

std::vector<std::string> CatalogueTerms() {
  std::vector<std::string> terms;
  for (const CatalogueCase& one : CatalogueCases()) terms.push_back(one.term);
  return terms;
}

}  // namespace clothfit
