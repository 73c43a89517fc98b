// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Setting up and advancing simulations, for tests of their motion.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "autodiff_sim/step/simulation.h"

namespace clothfit {

constexpr double kStep = 1.0 / 120.0;  // s, of tests that choose no other

// Parameters by their full name.
inline void Set(const std::string& name, double value, Simulation* simulation) {
  const int index = FindParameter(simulation->model().parameters(), name);
  ASSERT_GE(index, 0) << name;
  Eigen::VectorXd parameters = simulation->parameters();
  parameters[index] = value;
  simulation->SetParameters(parameters);
}

inline double Get(const std::string& name, const Simulation& simulation) {
  return simulation.parameters()[RequireParameter(simulation.model().parameters(), name)];
}

// Every term but these off.
inline void KeepOnly(const std::vector<std::string>& terms, Simulation* simulation) {
  for (const NamedParameter& p : simulation->model().parameters()) {
    if (p.term == "cloth" || std::find(terms.begin(), terms.end(), p.term) != terms.end()) continue;
    Set(p.name, p.parameter.off, simulation);
  }
}

// Steps that must converge, none of them halved.
inline void Advance(double step, int steps, const Drive& drive, Simulation* simulation,
                    State* state) {
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation->Advance(step, drive, state);
    ASSERT_EQ(report.status, StepStatus::kConverged);
    ASSERT_EQ(report.halvings, 0);
  }
}

}  // namespace clothfit
