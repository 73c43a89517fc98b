// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds for a list of terms, found out when it is compiled.
#pragma once

#include <string_view>

#include "autodiff_sim/term/term.h"

namespace clothfit {

// Whether a full name, term.parameter, is one of the term's parameters.
template <class Term>
constexpr bool HasParameter(std::string_view name) {
  constexpr std::string_view kTerm = Term::kName;
  if (name.substr(0, kTerm.size()) != kTerm) return false;
  name.remove_prefix(kTerm.size());
  if (name.empty() || name.front() != '.') return false;
  name.remove_prefix(1);
  for (const Parameter& parameter : Term::kParameters) {
    if (name == parameter.name) return true;
  }
  return false;
}

// Whether all that a term reads is there, be it the term's own or of another one.
template <class Term, class... Terms>
constexpr bool CanRead() {
  for (const char* name : Term::kReads) {
    if (!(HasParameter<Terms>(name) || ...)) return false;
  }
  return true;
}

// Whether a term's initial values are those at which it adds nothing.
template <class Term>
constexpr bool IsOffAtFirst() {
  for (const Parameter& p : Term::kParameters) {
    if (SwitchesOff(p) && p.initial != p.off) return false;
  }
  return true;
}

// Whether a parameter is a direction, a place or a time outside the cloth.
template <class Term>
constexpr bool HasPlaceInWorldOrTime() {
  for (const Parameter& p : Term::kParameters) {
    const bool is_of_cloth = p.meaning == Meaning::kNumber || p.meaning == Meaning::kClothU ||
                             p.meaning == Meaning::kClothV || p.meaning == Meaning::kClothDistance;
    if (!is_of_cloth) return true;
  }
  return false;
}

template <class Term>
constexpr bool IsOfMaterialOnly() {
  return Term::kTies.size() == 1 && Term::kTies[0] == Tie::kMaterial;
}

template <class Term, class... Terms>
constexpr bool CheckTerm() {
  constexpr int kSameName = ((std::string_view(Terms::kName) == Term::kName ? 1 : 0) + ...);
  static_assert(kSameName == 1, "the list has another term of this kName");
  static_assert(CanRead<Term, Terms...>(), "kReads has what is no parameter of the list's terms");
  static_assert(Term::kRole != Role::kMayBeMissing || IsOffAtFirst<Term>(),
                "what may be missing has initial values at which it is off");
  static_assert(Term::kMemory == 0 || Term::kWork != Work::kConserves,
                "what remembers conserves nothing: say in kWork what it does");
  static_assert(!HasPlaceInWorldOrTime<Term>() || !IsOfMaterialOnly<Term>(),
                "a term with a direction, a place in the world or a time says in kTies what holds");
  return true;
}

// Does not compile where a term of the list is not as it has to be.
template <class... Terms>
constexpr bool CheckTerms(TypeList<Terms...>) {
  return (CheckTerm<Terms, Terms...>() && ...);
}

}  // namespace clothfit
