// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A motion as binary glTF 2.0: one mesh, a morph target a frame, and an animation of their weights.
#pragma once

#include <string>

#include "fitting/export/run_motion.h"

namespace clothfit {

// The bytes of a .glb file. Its y is up, as glTF has it: (x, y, z) becomes (x, z, -y), so that a
// world with z upwards stands upright. Texture coordinates run from 0 to 1 over the cloth.
std::string MotionAsGlb(const RunMotion& motion);

}  // namespace clothfit
