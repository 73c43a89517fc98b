// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Classes of forces, before they have a name.
#pragma once

#include <string>

namespace clothfit {

// Of what class the missing force is, each with how sure that is.
struct DiscrepancyClass {
  bool is_from_outside = false;  // false: it may be the cloth's own or come from outside
  bool is_dissipative = false;   // takes energy out wherever it acts
  bool is_driving = false;       // puts energy in
  double net_force_sigmas = 0.0, net_moment_sigmas = 0.0;  // how far each is from nothing
  double power = 0.0, power_sigma = 0.0;                   // W, mean over the time where it acts
  std::string tied_to;  // "world", "material", "contact", "clock" or empty where it cannot be told
  std::string words;    // one sentence
};

// Of what class the terms of a named effect are, measured by their own force.
struct ActingClass {
  bool is_internal = false;  // no net force, no net moment
  bool is_dissipative = false, is_driving = false;
  std::string words;  // where, when and how they act: one or two sentences
};

}  // namespace clothfit
