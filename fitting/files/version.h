// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The version of clothfit, as CMakeLists.txt states it.
#pragma once

#include <string>

namespace clothfit {

inline std::string Version() { return CLOTHFIT_VERSION; }

}  // namespace clothfit
