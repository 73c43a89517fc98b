// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How wide the vector registers are that the compiler may use. It keeps a vector that is wider than
// a register in memory, so that loops on vectors are 4 to 8 times slower then.
#pragma once

namespace clothfit {

#if defined(__AVX512F__)
inline constexpr int kVectorBytes = 64;
#elif defined(__AVX__)
inline constexpr int kVectorBytes = 32;
#else
inline constexpr int kVectorBytes = 16;
#endif

}  // namespace clothfit
