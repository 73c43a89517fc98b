// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A cloth that hangs from two corners in a wind that comes and goes: what moved it is found again
// from its motion. The wind is a force term of this problem's own.
#pragma once

#include <string>
#include <vector>

namespace clothfit {

struct WindProblem {
  int particles = 30;  // along each side of a square metre
  int steps = 100;
  double step = 1.0 / 90.0;  // s
};

struct WindUnknown {
  std::string name;
  double truth, start, found;
};

struct WindRecovery {
  std::vector<WindUnknown> unknowns;
  bool converged = false;
  int iterations = 0;            // of Levenberg-Marquardt
  int simulations = 0;           // without derivatives
  int differentiated = 0;        // with all of them
  double seconds = 0.0;          // in all
  double rms_before, rms_after;  // m, of all positions at all times
  std::vector<std::string> statements;

  const WindUnknown& Find(const std::string& name) const;
};

// Fits stretch, bending and areal density of the cloth and strength, direction, frequency and phase
// of the wind to the positions of all particles after every step, from starts that are 10 to 30 %
// off. Priors are weak: a factor of e, a radian. Stretch and shear stiffness have one factor, and
// each damping that of its stiffness.
WindRecovery RecoverWind(const WindProblem& problem);

// A table of the unknowns, and what it took.
std::string WindAsMarkdown(const WindProblem& problem, const WindRecovery& recovery);

}  // namespace clothfit
