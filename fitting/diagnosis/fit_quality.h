// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How well a fit explains a recording.
#pragma once

namespace clothfit {

// Share of the cost that a full step may promise of a fit that has come to rest.
inline constexpr double kAtMinimum = 0.05;

}  // namespace clothfit
