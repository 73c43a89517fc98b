// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether anything is missing.
#pragma once

namespace clothfit {

// p-value of the baseline's residuals below which something is missing.
inline constexpr double kGate = 0.01;

}  // namespace clothfit
