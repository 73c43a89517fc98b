// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Small cloths in small worlds, for tests and benchmarks. All are at rest at time 0.
#pragma once

#include "autodiff_sim/scenes/cloth_scene.h"

namespace clothfit {

using TestScene = ClothScene;

// A square cloth of this side (m), n x n particles, horizontal, held at the two corners of its edge
// v = 0, which swing to and fro by 5 cm; the rest falls and swings through.
TestScene SwingingCloth(int n, double side);

}  // namespace clothfit
