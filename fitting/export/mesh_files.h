// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Single frames of a motion as mesh files, and all of it as a table.
#pragma once

#include <string>

#include "fitting/export/run_motion.h"

namespace clothfit {

// Wavefront OBJ with vt in metres and vn.
std::string FrameAsObj(const RunMotion& motion, std::size_t frame);

// PLY, binary and little-endian: x, y, z, nx, ny, nz, and u, v as "s" and "t" (m), all floats.
std::string FrameAsPly(const RunMotion& motion, std::size_t frame);

// Columns frame,time,particle,u,v,x,y,z.
std::string MotionAsCsv(const RunMotion& motion);

}  // namespace clothfit
