// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A physical parameter: its name, unit, meaning, bounds and scale, written once, with its term.
#pragma once

namespace clothfit {

// How a fit moves a parameter: by adding, or by multiplying (for what is positive and spans
// decades).
enum class Scale { kLinear, kLog };

struct Parameter {
  const char* name;  // within its term; the full name is term.name
  const char* unit;
  const char* doc;
  double initial;  // what a simulation uses unless told otherwise
  double off;      // at which the term adds no force
  double lower;    // bounds that a fit respects
  double upper;
  Scale scale;
  double prior_factor;  // one sigma of the default prior: a factor for kLog, an amount for kLinear
};

}  // namespace clothfit
