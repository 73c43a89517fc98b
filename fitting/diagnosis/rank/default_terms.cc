// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/default_terms.h"

#include <algorithm>

#include "fitting/diagnosis/fitted/named_parameter.h"
#include "tracking/text/text.h"

namespace clothfit {

bool IsDefaultTerm(const RankedCandidate& candidate) {
  if (candidate.summary.kind != CandidateKind::kPhysics) return false;
  return std::any_of(candidate.names.begin(), candidate.names.end(), [&](const std::string& name) {
    const Parameter parameter = ParameterNamed(name);
    return parameter.initial != parameter.off;
  });
}

RankedCandidate Together(const Ranking& ranking, const std::vector<std::string>& names) {
  RankedCandidate together;
  together.parts = names;
  together.summary.name = together.term.name = JoinNames(names);
  for (const RankedCandidate& part : ranking.candidates) {
    const std::string& name = part.summary.name;
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    together.summary.score = std::max(together.summary.score, part.summary.score);
    together.names.insert(together.names.end(), part.names.begin(), part.names.end());
    together.columns.insert(together.columns.end(), part.columns.begin(), part.columns.end());
    together.probe.insert(part.probe.begin(), part.probe.end());
  }
  const auto size = static_cast<Eigen::Index>(together.names.size());
  together.amounts.resize(size);
  together.sigma.setZero(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const std::string& name = together.names[static_cast<std::size_t>(i)];
    together.amounts[i] = ParameterNamed(name).initial;
  }
  return together;
}

std::optional<RankedCandidate> AllDefaultTerms(const Ranking& ranking) {
  std::vector<std::string> names;
  for (const RankedCandidate& candidate : ranking.candidates) {
    if (IsDefaultTerm(candidate)) names.push_back(candidate.summary.name);
  }
  if (names.size() < 2) return {};
  std::sort(names.begin(), names.end());
  return Together(ranking, names);
}

}  // namespace clothfit
