// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cases' numbers. The cloth that swings is a square of 0.3 m that falls from z = 0.3 m.
#include "tests/autodiff_sim/catalogue_cases.h"

namespace clothfit {

const std::vector<CatalogueCase>& CatalogueCases() {
  static const std::vector<CatalogueCase> cases = {
      {"bending_friction", false, {{"moment", 1e-3}, {"onset", 3.0}}},
      {"shear_friction", false, {{"stress", 0.5}, {"onset", 0.03}}},
      {"stretch_relaxation", false, {{"share", 0.5}, {"time", 0.2}}},
      {"shear_relaxation", false, {{"share", 0.5}, {"time", 0.2}}},
      {"bending_relaxation", false, {{"share", 0.5}, {"time", 0.2}}},
  };
  return cases;
}

std::vector<std::string> CatalogueTerms() {
  std::vector<std::string> terms;
  for (const CatalogueCase& one : CatalogueCases()) terms.push_back(one.term);
  return terms;
}

}  // namespace clothfit
