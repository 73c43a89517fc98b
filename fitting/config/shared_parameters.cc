// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/config/shared_parameters.h"

#include <algorithm>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

bool IsOfRecording(const TermInfo& term) {
  if (term.role == Role::kContact) return false;  // friction with what is known to be there
  return std::any_of(term.ties.begin(), term.ties.end(),
                     [](Tie tie) { return tie == Tie::kWorld || tie == Tie::kClock; });
}

}  // namespace

bool IsShared(const FitConfig& config, const std::string& parameter) {
  const auto setting = config.parameters.find(parameter);
  if (setting != config.parameters.end() && setting->second.shared) return *setting->second.shared;
  const std::string term = parameter.substr(0, parameter.find('.'));
  for (const TermInfo& info : AllTerms())
    if (info.name == term) return !IsOfRecording(info);
  return true;  // the cloth's own
}

}  // namespace clothfit
