// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted cloth as a script for Blender. docs/material-elsewhere.md derives what stands in it.
#pragma once

#include <string>

#include "fitting/export/run_cloth.h"

namespace clothfit {

// Settings of Blender's cloth. Its unit of time is 1/sqrt(1000) s, in which its gravity is a
// thousandth of the scene's; a stiffness in N/m is a thousandth there, a damping in N s/m a
// sqrt(1000)th.
struct BlenderCloth {
  double mass = 0.0;             // kg, of each vertex
  double tension = 0.0;          // tension_stiffness and compression_stiffness
  double tension_damping = 0.0;  // and compression_damping
  double shear = 0.0, shear_damping = 0.0;
  double bending = 0.0, bending_damping = 0.0;
  double air_damping = 0.0;
  double friction = 0.0;    // of the ground, cloth_friction
  double time_scale = 1.0;  // with which a frame lasts 1 / frame rate
};
BlenderCloth ClothForBlender(const RunCloth& cloth);

// Python for `blender -b --python FILE [-- OUT.npy]`: mesh, cloth modifier, vertices that are held
// and follow the run. With OUT.npy it simulates and writes frames x vertices x 3, in m.
std::string ClothAsBlenderScript(const RunCloth& cloth);

}  // namespace clothfit
