// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/verdict.h"

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/compare/two_meshes.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/gate/gate.h"
#include "fitting/diagnosis/model/explained_share.h"

namespace clothfit {

double MostOfIt(double unexplained, bool is_lost) {
  return is_lost || unexplained > kUnusableResidual ? kHalfOfIt : kMostOfIt;
}

bool IsOnItsWay(const Diagnosis& diagnosis, double unexplained) {
  constexpr double kMost = 0.5;
  const double beyond = unexplained * unexplained;
  return diagnosis.promised * (1.0 + beyond) >= kMost * beyond;
}

bool IsDetermined(const Diagnosis& diagnosis) {
  if (!diagnosis.answer) return true;
  const std::vector<NamedParameter>& table = MakeParameterTable();
  bool has_amount = false;
  for (const EffectParameter& p : diagnosis.answer->parameters) {
    const int index = FindParameter(table, p.name);  // none of a fault's
    if (index < 0 || !SwitchesOff(table[static_cast<std::size_t>(index)].parameter)) continue;
    const double off = table[static_cast<std::size_t>(index)].parameter.off;
    if (!(p.lower90 <= off && off <= p.upper90)) return true;
    has_amount = true;
  }
  return !has_amount;
}

Verdict VerdictOf(const Diagnosis& diagnosis, const Outcome& outcome) {
  if (diagnosis.law) return Verdict::kNoneOfTheAbove;
  const bool is_most = outcome.explained >= outcome.most;
  const bool makes_it = outcome.unexplained < outcome.mesh;  // another mesh, all that is left
  if (outcome.has_physics) {
    // Of what mesh and step may leave, physics has to have taken half.
    const bool may_be_mesh =
        outcome.unexplained < kTooLittle || (makes_it && outcome.explained >= kHalfOfIt);
    const bool is_enough = outcome.is_explained || is_most || may_be_mesh;
    return is_enough && IsDetermined(diagnosis) ? Verdict::kNamed : Verdict::kNoneOfTheAbove;
  }
  if (!diagnosis.effects.empty()) return Verdict::kObservationFault;
  if (outcome.is_explained || outcome.unexplained < kTooLittle) return Verdict::kNothingMissing;
  // Mesh and step alone may leave as much: of outlines that is asked of the coarse mesh.
  const bool may_be_null = outcome.mesh > 0.0 ? makes_it : diagnosis.gate_p_value >= kGate;
  return may_be_null || IsOnItsWay(diagnosis, outcome.unexplained) ? Verdict::kUndecided
                                                                   : Verdict::kNoneOfTheAbove;
}

std::string ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNothingMissing:
      return "nothing is missing";
    case Verdict::kNamed:
      return "named";
    case Verdict::kObservationFault:
      return "observation fault";
    case Verdict::kNoneOfTheAbove:
      return "none of the above";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kInterrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace clothfit
