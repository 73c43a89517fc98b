// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/chosen_effects.h"

namespace clothfit {
namespace {

using Amounts = std::map<std::string, std::array<double, 3>>;
using Fixed = std::map<std::string, double>;
using Effects = std::vector<PlantableEffect>;

constexpr SyntheticScenario kSwing = SyntheticScenario::kTwoCornerSwing;
constexpr SyntheticScenario kShake = SyntheticScenario::kTwoCornerShake;
constexpr SyntheticScenario kTurn = SyntheticScenario::kTwoCornerTurn;
constexpr SyntheticScenario kSag = SyntheticScenario::kFourCornerSag;
constexpr SyntheticScenario kLift = SyntheticScenario::kCornerLift;
constexpr SyntheticScenario kLiftTwo = SyntheticScenario::kTwoCornerLift;
constexpr Fabric kWoven = Fabric::kWoven, kKnit = Fabric::kKnit, kStiff = Fabric::kStiff;
constexpr double kRight = M_PI / 2;  // rad

Effects AirEffects() {
  const Fixed gust = {{"duration", 0.8}, {"u", 0.25}, {"v", 0.35}, {"radius", 0.2}};
  const auto at = [](Fixed shape, double onset) {
    shape["onset"] = onset;
    return shape;
  };
  return {
      {"wind", kSwing, kWoven, {{"y", {0.06, 0.25, 0.8}}}, {}, true},
      {"wind", kTurn, kWoven, {{"y", {0.06, 0.25, 1.0}}}, {}, true},
      {"gust", kSwing, kWoven, {{"y", {0.25, 0.8, 2.5}}}, at(gust, 0.6), true},
      {"gust", kTurn, kWoven, {{"y", {0.25, 0.8, 3.0}}}, at(gust, 1.5), true},
      {"added_mass", kSwing, kWoven, {{"normal", {0.005, 0.02, 0.08}}}, {}, false},
      {"added_mass", kShake, kWoven, {{"normal", {0.008, 0.04, 0.3}}}, {}, false},
  };
}

Effects MemoryEffects() {
  const Fixed half = {{"time", 0.5}}, bend = {{"onset", 5.0}}, shear = {{"onset", 0.02}};
  return {
      {"bending_friction", kLift, kWoven, {{"moment", {4e-4, 1.5e-3, 5e-3}}}, bend, false},
      {"bending_friction", kLiftTwo, kWoven, {{"moment", {2e-4, 1e-3, 4e-3}}}, bend, false},
      {"shear_friction", kSwing, kWoven, {{"stress", {0.03, 0.3, 2.0}}}, shear, false},
      {"shear_friction", kSag, kWoven, {{"stress", {0.2, 1.0, 4.0}}}, shear, false},
      {"stretch_relaxation", kSwing, kKnit, {{"share", {0.2, 0.5, 0.9}}}, half, false},
      {"stretch_relaxation", kSag, kKnit, {{"share", {0.2, 0.5, 0.9}}}, half, false},
      {"shear_relaxation", kSwing, kKnit, {{"share", {0.1, 0.5, 0.9}}}, half, false},
      {"shear_relaxation", kSag, kKnit, {{"share", {0.2, 0.5, 0.9}}}, half, false},
      {"bending_relaxation", kLift, kStiff, {{"share", {0.2, 0.5, 0.9}}}, half, false},
      {"bending_relaxation", kLiftTwo, kStiff, {{"share", {0.2, 0.5, 0.9}}}, half, false},
  };
}

Effects ElasticEffects() {
  const Fixed fold = {{"angle", 0.3}, {"offset", 0.05}, {"width", 0.03}};
  const Fixed patch = {{"u", 0.3}, {"v", 0.2}, {"radius", 0.12}};
  const Fixed seam = {{"angle", kRight}, {"offset", 0.05}, {"width", 0.04}};
  const Fixed early = {{"onset", 0.01}};
  return {
      {"crease", kLiftTwo, kStiff, {{"curvature", {5.0, 20.0, 60.0}}}, fold, true},
      {"crease", kTurn, kStiff, {{"curvature", {5.0, 40.0, 100.0}}}, fold, true},
      {"stretch_stiffening", kSwing, kKnit, {{"cubic", {3e3, 3e4, 3e5}}}, early, false},
      {"stretch_stiffening", kSag, kKnit, {{"cubic", {3e3, 5e4, 1e6}}}, early, false},
      {"stretch_orthotropy", kSwing, kKnit, {{"ratio", {1.2, 1.8, 4.0}}}, {}, false},
      {"stretch_orthotropy", kSag, kKnit, {{"ratio", {1.5, 3.0, 8.0}}}, {}, false},
      {"shear_orthotropy", kSwing, kWoven, {{"ratio", {1.6, 4.0, 10.0}}}, {}, false},
      {"shear_orthotropy", kLiftTwo, kWoven, {{"ratio", {1.6, 4.0, 10.0}}}, {}, false},
      {"bending_orthotropy", kLift, kStiff, {{"ratio", {2.0, 5.0, 10.0}}}, {}, false},
      {"bending_orthotropy", kLiftTwo, kStiff, {{"ratio", {1.5, 4.0, 10.0}}}, {}, false},
      {"stiff_patch_stretch", kSwing, kKnit, {{"extra", {0.5, 2.0, 10.0}}}, patch, false},
      {"stiff_patch_stretch", kSag, kKnit, {{"extra", {1.0, 5.0, 25.0}}}, patch, false},
      {"stiff_patch_bending", kLift, kStiff, {{"extra", {2.0, 12.0, 40.0}}}, patch, false},
      {"stiff_patch_bending", kLiftTwo, kStiff, {{"extra", {2.0, 12.0, 40.0}}}, patch, false},
      {"stiff_seam_stretch", kSwing, kKnit, {{"extra", {0.5, 2.0, 10.0}}}, seam, false},
      {"stiff_seam_stretch", kSag, kKnit, {{"extra", {2.0, 10.0, 30.0}}}, seam, false},
      {"stiff_seam_bending", kLift, kStiff, {{"extra", {2.0, 12.0, 40.0}}}, seam, false},
      {"stiff_seam_bending", kLiftTwo, kStiff, {{"extra", {2.0, 12.0, 40.0}}}, seam, false},
  };
}

Effects MassEffects() {
  const Fixed patch = {{"u", 0.35}, {"v", 0.35}, {"radius", 0.1}};
  return {
      {"hem", kShake, kWoven, {{"high_v", {0.002, 0.01, 0.05}}}, {}, false},
      {"hem", kLiftTwo, kWoven, {{"high_v", {0.002, 0.01, 0.05}}}, {}, false},
      {"heavy_patch", kSwing, kWoven, {{"share", {0.2, 1.2, 5.0}}}, patch, false},
      {"heavy_patch", kSag, kWoven, {{"share", {0.6, 2.5, 8.0}}}, patch, false},
      {"gravity_tilt", kSwing, kWoven, {{"angle_1", {0.005, 0.02, 0.08}}}, {}, true},
      {"gravity_tilt", kTurn, kWoven, {{"angle_1", {0.005, 0.02, 0.08}}}, {}, true},
  };
}

Effects GroundEffects() {
  const Fixed near = {{"range", 0.004}};
  const Fixed patch = {{"range", 0.004}, {"u", 0.35}, {"v", 0.35}, {"radius", 0.1}};
  return {
      {"adhesion", kLift, kWoven, {{"pressure", {0.2, 1.0, 5.0}}}, near, false},
      {"adhesion", kLiftTwo, kWoven, {{"pressure", {0.2, 1.0, 5.0}}}, near, false},
      {"sticky_patch", kLift, kWoven, {{"pressure", {0.6, 3.0, 20.0}}}, patch, false},
      {"sticky_patch", kLiftTwo, kWoven, {{"pressure", {0.6, 3.0, 20.0}}}, patch, false},
  };
}

// Upwards no cloth slips, and sideways only a little.
Effects GripEffects() {
  const auto slip = [](double onset) {
    return Fixed{{"onset", onset}, {"duration", 0.2}, {"u", 0.5}, {"v", 0.0}, {"radius", 0.15}};
  };
  return {
      {"grip", kSwing, kWoven, {{"compliance", {0.004, 0.02, 0.08}}}, {}, false},
      {"grip", kShake, kWoven, {{"compliance", {0.004, 0.02, 0.08}}}, {}, false},
      {"grip_slip", kSwing, kWoven, {{"z", {-0.003, -0.01, -0.03}}}, slip(0.6), false},
      {"grip_slip", kTurn, kWoven, {{"z", {-0.003, -0.01, -0.03}}}, slip(1.5), false},
  };
}

// What varies of an obstacle is how far it reaches into the cloth's way; it is as hard always.
Effects WorldEffects() {
  const Fixed wall = {{"stiffness", 2e3}, {"angle_1", -kRight}};
  const Fixed table = {{"stiffness", 2e3}};
  // Behind the edges, towards -y and -x, the tables are.
  const Fixed edge_behind = {{"stiffness", 2e3}, {"x1", 0.5},  {"x2", -0.5},
                             {"y2", -0.16},      {"z1", -0.3}, {"z2", -0.3}};
  const Fixed edge = {{"stiffness", 2e3}, {"x1", 0.05}, {"x2", 0.05},
                      {"y1", -0.5},       {"y2", 0.5},  {"z2", -0.10}};
  const Fixed ball = {{"stiffness", 2e3}, {"x", 0.05}, {"z", -0.4}, {"radius", 0.08}};
  const Fixed under = {{"stiffness", 2e3}, {"x", 0.05}, {"y", 0.0}, {"radius", 0.08}};
  const Fixed bar = {{"stiffness", 2e3}, {"x1", -0.4},  {"x2", 0.4},     {"z1", -0.4},
                     {"z2", -0.4},       {"y2", -0.16}, {"radius", 0.03}};
  const Fixed bar_under = {{"stiffness", 2e3}, {"x1", -0.4},  {"x2", 0.4},     {"y1", 0.05},
                           {"y2", 0.05},       {"z2", -0.14}, {"radius", 0.03}};
  const Fixed charge = {{"x", 0.05}, {"y", 0.12}, {"z", -0.4}, {"range", 0.12}};
  return {
      {"obstacle_plane", kSwing, kWoven, {{"height", {-0.16, -0.13, -0.09}}}, wall, false},
      {"obstacle_plane", kSag, kWoven, {{"height", {-0.12, -0.10, -0.06}}}, table, false},
      {"obstacle_table", kSwing, kWoven, {{"y1", {-0.16, -0.13, -0.09}}}, edge_behind, false},
      {"obstacle_table", kSag, kWoven, {{"z1", {-0.12, -0.10, -0.06}}}, edge, false},
      {"obstacle_sphere", kSwing, kWoven, {{"y", {-0.24, -0.19, -0.12}}}, ball, false},
      {"obstacle_sphere", kSag, kWoven, {{"z", {-0.18, -0.15, -0.10}}}, under, false},
      {"obstacle_capsule", kSwing, kWoven, {{"y1", {-0.20, -0.16, -0.10}}}, bar, false},
      {"obstacle_capsule", kSag, kWoven, {{"z1", {-0.15, -0.12, -0.06}}}, bar_under, false},
      {"attractor", kSwing, kWoven, {{"stiffness", {0.15, 0.7, 4.0}}}, charge, false},
      {"attractor", kTurn, kWoven, {{"stiffness", {0.15, 0.8, 6.0}}}, charge, false},
  };
}

}  // namespace

Effects ChosenEffects() {
  Effects all;
  for (const auto& group : {AirEffects(), MemoryEffects(), ElasticEffects(), MassEffects(),
                            GroundEffects(), GripEffects(), WorldEffects()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

Effects ChosenUnlistedEffects() {
  const Fixed axis = {{"x", 0.1}, {"y", 0.1}, {"core", 0.15}};
  const Fixed web = {{"x", 0.05}, {"y", 0.05}, {"z", -0.42}, {"range", 0.06}};
  const Amounts glue = {{"pull", {0.1, 0.5, 4.0}}, {"viscosity", {0.4, 2.0, 15.0}}};
  return {
      {"vortex", kSwing, kWoven, {{"speed", {0.2, 0.45, 1.5}}}, axis, true},
      {"vortex", kTurn, kWoven, {{"speed", {0.2, 0.6, 1.5}}}, axis, true},
      {"diagonal_thread",
       kSwing,
       kKnit,
       {{"stiffness", {0.15, 0.6, 3.0}}},
       {{"gather", 0.04}},
       false},
      {"diagonal_thread",
       kSag,
       kKnit,
       {{"stiffness", {0.4, 2.0, 10.0}}},
       {{"gather", 0.04}},
       false},
      {"sticky_point", kSwing, kWoven, glue, web, false},
      {"sticky_point", kTurn, kWoven, glue, web, false},
  };
}

}  // namespace clothfit
