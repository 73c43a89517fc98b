// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/config/titles.h"

#include <algorithm>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

std::string TitleOf(const std::string& effect) {
  const std::vector<TermInfo>& terms = AllTerms();
  const auto term = std::find_if(terms.begin(), terms.end(),
                                 [&](const TermInfo& one) { return one.name == effect; });
  const bool is_term = term != terms.end();
  if (is_term && !term->title.empty()) return term->title;
  const std::size_t colon = effect.find(": ");
  if (colon != std::string::npos) {
    const std::string whose = effect.substr(0, colon);
    return effect.substr(colon + 2) + " of " + (whose == "markers" ? "the markers" : whose);
  }
  std::string title = effect;
  if (is_term || FindParameter(MakeParameterTable(), effect) >= 0) {
    std::replace(title.begin(), title.end(), '_', ' ');
    std::replace(title.begin(), title.end(), '.', ' ');
  }
  return title;
}

std::vector<std::string> TitlesOf(const std::vector<std::string>& effects) {
  std::vector<std::string> titles;
  for (const std::string& effect : effects) titles.push_back(TitleOf(effect));
  return titles;
}

}  // namespace clothfit
