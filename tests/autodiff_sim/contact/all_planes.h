// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests of every number of planes that bounding volumes may have.
#pragma once

#include <type_traits>

#include <gtest/gtest.h>

namespace clothfit {

using AllPlanes = testing::Types<std::integral_constant<int, 6>, std::integral_constant<int, 14>,
                                 std::integral_constant<int, 18>, std::integral_constant<int, 26>>;

}  // namespace clothfit
