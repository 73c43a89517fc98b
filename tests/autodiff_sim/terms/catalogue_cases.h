// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Every term that a cloth model may lack, each switched on so strongly that it shows in a rollout
// of half a second: with numbers that were chosen, or, for a term without such, that follow from
// what it says of itself.
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
// What follows from the term: one sigma of its prior from off, in the middle of its probes.
CatalogueCase DefaultCase(const TermInfo& term);
std::vector<std::string> CatalogueTerms();

}  // namespace clothfit
