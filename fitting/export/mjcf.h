// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted cloth as a model of MuJoCo. docs/material-elsewhere.md derives what stands in it.
#pragma once

#include <string>

#include "fitting/export/run_cloth.h"

namespace clothfit {

// A flex of MuJoCo: one isotropic elastic sheet, without Poisson's effect. Of 3.3.8 a sheet resists
// stretching by young t / 4 and bending by young t^3 / 16.
struct FlexMaterial {
  double young = 0.0;      // Pa, of a sheet of `thickness`
  double thickness = 0.0;  // m, which gives it the cloth's bending; not that of the fabric
  double damping = 0.0;    // s, stretch_damping / stretch
  double timestep = 0.0;   // s, small enough for a step that is explicit in the sheet's forces
};
FlexMaterial MaterialForMujoco(const ClothMaterial& material, double spacing);

// MJCF: particles with three slide joints each, a flex over them, mocap bodies for what is held,
// and a key a frame with the run's motion (qpos), its times and the handles' places (mpos). The
// numerics "drag" (kg/(m^2 s)) and "areas" (m^2, one a particle) are for the program that steps it.
std::string ClothAsMjcf(const RunCloth& cloth);

}  // namespace clothfit
