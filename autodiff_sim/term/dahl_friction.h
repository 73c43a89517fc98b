// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Friction inside a material, Dahl 1968 (A solid friction model, with exponent 1) as in Bliman and
// Sorine 1995 and, for cloth, Miguel et al. 2013: the friction force is its limit times z, and z
// follows the slide s by
//   dz = (ds - z |ds|) / onset,
// so that it is elastic with slope 1 / onset at first, tends to +-1, and turns around with the
// motion. It knows no rate: only the path matters, not the time it takes.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

// z after a slide that does not turn around, from z before; `slide` is over the onset. Exact,
// whatever the slide's size: a loop closes after two steps as after thousands. Where the slide
// turns, z is continuous and its slope is not, which is the law's own.
template <class T>
T SlideFriction(const T& before, const T& slide) {
  using std::exp;
  const bool forward = Value(slide) >= 0.0;
  const T limit = T(forward ? 1.0 : -1.0);
  const T left = exp(forward ? T(-slide) : slide);
  return before + (limit - before) * (1.0 - left);  // exactly as before without a slide
}

}  // namespace clothfit
