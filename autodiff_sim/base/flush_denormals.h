// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes numbers too small for the normal range for zero while it lives. Where a cloth lies flat the
// Jacobian's entries fade to 1e-40 and below: normal in double precision, but in single precision
// each costs the processor a hundred cycles, which made factors and products two to six times
// slower. What is computed so is only ever a preconditioner or a correction.
#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace clothfit {

class FlushDenormals {
 public:
#ifdef __SSE2__
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | kFlushResults | kFlushInputs); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() {}
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#ifdef __SSE2__
  static constexpr unsigned kFlushResults = 0x8000, kFlushInputs = 0x0040;  // FTZ and DAZ
  unsigned before_;
#endif
};

}  // namespace clothfit
