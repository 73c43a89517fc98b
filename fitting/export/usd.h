// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A motion as Universal Scene Description, in its text form.
// Reference: OpenUSD, UsdGeomMesh, UsdGeomPrimvarsAPI.
#pragma once

#include <string>

#include "fitting/export/run_motion.h"

namespace clothfit {

// A stage in metres with z up: /Cloth/Mesh, whose points and normals have a sample a frame, and
// whose primvar st is (u, v) in metres. A time code is a frame.
std::string MotionAsUsda(const RunMotion& motion);

}  // namespace clothfit
