// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Every term of the catalogue of effects that a cloth model may lack, each switched on so strongly
// that it shows in a rollout of half a second.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "autodiff_sim/step/simulation.h"

namespace clothfit {

// Tests print the name only.
struct CatalogueCase {
  std::string term;
  bool on_ground;  // on a cloth that is lifted from the ground, else on one that swings
  std::vector<std::pair<std::string, double>> on;  // every parameter of the term
  friend void PrintTo(const CatalogueCase& one, std::ostream* out) { *out << one.term; }
};

const std::vector<CatalogueCase>& CatalogueCases();
std::vector<std::string> CatalogueTerms();

}  // namespace clothfit
