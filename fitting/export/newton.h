// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted cloth as a script for Newton, the simulator on top of Warp. docs/material-elsewhere.md
// derives what stands in it.
#pragma once

#include <string>

#include "fitting/export/run_cloth.h"

namespace clothfit {

// Arguments of ModelBuilder.add_cloth_mesh.
struct NewtonCloth {
  double density = 0.0;  // kg/m^2
  double tri_ke = 0.0;   // N/m, Lame's mu times thickness
  double tri_ka = 0.0;   // N/m, Lame's lambda times thickness; 0: no Poisson's effect
  double tri_kd = 0.0;   // N s/m
  double edge_ke = 0.0;  // N, per length of an edge and angle
  double edge_kd = 0.0;  // N s
};
NewtonCloth ClothForNewton(const RunCloth& cloth);

// Python: `python FILE OUT.npy` simulates and writes frames x particles x 3, in m; `--springs` has
// clothfit's own springs in the place of Newton's triangles.
std::string ClothAsNewtonScript(const RunCloth& cloth);

}  // namespace clothfit
