// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that clothfit offers to other programs, in the namespace clothfit.
//
//   #include <clothfit/clothfit.h>
//   clothfit::Run run = clothfit::Fit(clothfit::Recording::Read("data/demo"), ...);
//
// With CMake: find_package(clothfit REQUIRED), target_link_libraries(... clothfit::clothfit).
#pragma once

#include "clothfit/base.h"
#include "clothfit/config.h"
#include "clothfit/diagnosis.h"
#include "clothfit/recording.h"
#include "clothfit/run.h"
#include "clothfit/simulation.h"
#include "clothfit/term.h"

// The library has names of its own in the outer namespace, which no program sees.
namespace clothfit {
using namespace v0;  // NOLINT(google-build-using-namespace): this is the interface
}
