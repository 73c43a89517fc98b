// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/effect_words.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/answer/amount_words.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::optional<TermInfo> TermNamed(const std::string& name) {
  for (const TermInfo& term : AllTerms())
    if (term.name == name) return term;
  return {};
}

std::string TermOf(const std::string& parameter) {
  return parameter.substr(0, parameter.find('.'));
}

bool IsAmount(const EffectParameter& p) { return SwitchesOff(ParameterNamed(p.name)); }

// The parameters of one effect: how much of it there is, and where and of what shape it is.
struct OwnParameters {
  std::vector<EffectParameter> amounts, shapes;
};

OwnParameters OwnOf(const std::string& effect, const std::vector<EffectParameter>& parameters) {
  const bool is_term = TermNamed(effect).has_value();
  OwnParameters own;
  for (const EffectParameter& p : parameters) {
    const bool is_own = is_term ? TermOf(p.name) == effect : StartsWith(p.name, effect);
    if (is_own) (is_term && !IsAmount(p) ? own.shapes : own.amounts).push_back(p);
  }
  return own;
}

std::string TermInBrief(const OwnParameters& own) {
  const std::string place = FirstPlace(own.shapes);
  if (!place.empty()) return ", " + place;
  return own.amounts.empty() ? "" : " of " + AmountsOfTerm(own.amounts);
}

// Amounts of one unit are the parts of one number.
std::string FaultInBrief(const std::vector<EffectParameter>& amounts) {
  std::string words;
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    const auto is_of_unit = [&](const EffectParameter& p) { return p.unit == amounts[i].unit; };
    if (std::any_of(amounts.begin(), amounts.begin() + static_cast<std::ptrdiff_t>(i), is_of_unit))
      continue;
    std::vector<EffectParameter> parts;
    std::copy_if(amounts.begin(), amounts.end(), std::back_inserter(parts), is_of_unit);
    words += (words.empty() ? " off by " : " and ") + Alone(SizeOf(parts));
  }
  return words;
}

void AddUnlessTold(const std::string& part, const std::string& told, std::string* words) {
  if (told.find(" " + part) != std::string::npos) return;
  *words += (words->empty() ? "" : ", ") + part;
}

}  // namespace

std::string InBrief(const std::string& effect, const std::vector<EffectParameter>& parameters) {
  const OwnParameters own = OwnOf(effect, parameters);
  if (TermNamed(effect)) return TitleOf(effect) + TermInBrief(own);
  if (effect.find(": ") != std::string::npos) return TitleOf(effect) + FaultInBrief(own.amounts);
  return own.amounts.empty() ? TitleOf(effect)
                             : TitleOf(effect) + " of " + Alone(own.amounts.front());
}

std::string PlainName(const std::string& effect) {
  const std::optional<TermInfo> term = TermNamed(effect);
  return term ? fmt::format("{} ({})", term->doc, effect) : TitleOf(effect);
}

std::string PlainNames(const std::vector<std::string>& effects) {
  std::string names;
  for (const std::string& effect : effects)
    names += (names.empty() ? "" : "; ") + PlainName(effect);
  return names;
}

std::string AmountsInWords(const std::vector<std::string>& effects,
                           const std::vector<EffectParameter>& parameters,
                           const std::string& told) {
  std::string words;
  for (const std::string& effect : effects) {
    const bool is_term = TermNamed(effect).has_value();
    const OwnParameters own = OwnOf(effect, parameters);
    if (own.amounts.empty()) continue;
    std::string of_effect;
    if (is_term) {
      AddUnlessTold(AmountsOfTerm(own.amounts), told, &of_effect);
      if (!own.shapes.empty()) AddUnlessTold(ShapesOfTerm(own.shapes), told, &of_effect);
    } else {
      for (const EffectParameter& p : own.amounts) {
        const std::string part(TrimBlanks(std::string_view(p.name).substr(effect.size())));
        AddUnlessTold(part + (part.empty() ? "" : " ") + Alone(p), told, &of_effect);
      }
    }
    if (of_effect.empty()) continue;
    words +=
        fmt::format("{}{}: {}.", words.empty() ? "" : " ", Capitalised(TitleOf(effect)), of_effect);
  }
  return words;
}

}  // namespace clothfit
