// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether frames that no fit has seen are predicted better.
#pragma once

#include <cstdint>
#include <optional>

#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// Open-loop prediction of frames that the fit has not seen, root mean squares (m; px where there
// are no markers, or where a camera's fault is validated by what that camera tracks).
struct HeldOutValidation {
  double before = 0.0, after = 0.0;
  double improvement_lower95 = 0.0;  // of before - after, by a block bootstrap
  double noise = 0.0;                // of the observations alone
  double irreducible = 0.0;  // the part of `before` that noise and discretisation error may make
  bool is_validated = false;
  bool is_in_pixels = false;
  // Of a fault of one source: the errors are its own alone, along a motion that follows whatever
  // else was seen in those frames, not a prediction's.
  bool is_against_others = false;
};

// Errors that no model of the physics takes away, in the unit of the errors.
struct IrreducibleError {
  double noise = 0.0, discretisation = 0.0;  // of the observations; D_h
};

// The fall of the root mean square error and the lower end of its one-sided 95 % interval, by a
// moving-block bootstrap (Kuensch 1989) over frames. Validated if that end exceeds 0.05 of the
// noise and the lower end of the fall of the mean square exceeds floor.numerical squared.
HeldOutValidation Validate(const HeldOutErrors& before, const HeldOutErrors& after, int block,
                           const IrreducibleError& irreducible, std::uint64_t seed);

}  // namespace clothfit
