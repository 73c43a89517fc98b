// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The obstacles of a scene as surfaces that a report can draw.
#pragma once

#include "fitting/run_folder.h"
#include "fitting/scene.h"

namespace clothfit {

// Writes report/obstacles.json and report/obstacle_N.npy (frames x vertices x 3, m) into the run;
// nothing where the scene has no obstacles. Round ones are drawn with flat faces.
void WriteObstacles(const Scene& scene, const RunFolder& run);

}  // namespace clothfit
