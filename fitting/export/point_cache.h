// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A motion as a point cache: the places of all vertices, frame by frame, for a mesh that the other
// program has already (the run's mesh.obj).
#pragma once

#include <string>

#include "fitting/export/run_motion.h"

namespace clothfit {

// PC2, "POINTCACHE2" version 1: 32 bytes of header, then little-endian floats. One sample a frame.
std::string MotionAsPc2(const RunMotion& motion);

// MDD of LightWave: big-endian; the frames' times in seconds, then floats.
std::string MotionAsMdd(const RunMotion& motion);

}  // namespace clothfit
