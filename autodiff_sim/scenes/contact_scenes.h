// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Cloths that get into their own way. All are at rest and clear of themselves at time 0.
#pragma once

#include "autodiff_sim/scenes/cloth_scene.h"

namespace clothfit {

// A square cloth of this side (m), n x n particles, that stands on end above the ground, a little
// bent, and drops down on its edge in folds. Nothing holds it.
ClothScene DroppedCloth(int n, double side);

// A square cloth that is folded in the middle, the upper layer `gap` (m) above the lower. It lies
// on the ground, and the far corners of the upper layer are drawn back and over the lower one.
ClothScene FoldedCloth(int n, double side, double gap);

// A square cloth on the ground, one corner of which is lifted and drawn far over the rest, down to
// just above it.
ClothScene CornerDrawnOver(int n, double side);

// A square cloth that falls flat on a ball above the ground, not quite in its middle.
ClothScene ClothOverBall(int n, double side);

// A square cloth that lies flat above a bar and is drawn over it and off at one side.
ClothScene ClothOverBar(int n, double side);

// A square cloth held at four corners, two of which turn about its middle line by `turns`, and come
// closer, within a second.
ClothScene TwistedCloth(int n, double side, double turns);

// A square cloth that hangs by two corners while a box, on a path and turning, runs into it.
ClothScene BoxIntoCloth(int n, double side);

}  // namespace clothfit
