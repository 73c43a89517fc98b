// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of a config by names, as the command line makes them.
#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/config.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kDefaultAttraction =
    1.0;  // N/m, about the weight of a marker's cloth a centimetre

// The nearest right name; for a parameter without its term the one that ends so.
[[noreturn]] void FailUnknown(const std::string& place, const std::string& name,
                              const std::vector<std::string>& right_names) {
  const std::string ending = "." + name;
  for (const std::string& right : right_names) {
    const bool ends_so = right.size() > ending.size() &&
                         right.compare(right.size() - ending.size(), ending.size(), ending) == 0;
    if (ends_so) throw InputError(place, fmt::format("'{}': did you mean '{}'?", name, right));
  }
  throw InputError(place, fmt::format("'{}': {}", name, Suggestion(name, right_names)));
}

void CheckBounds(const std::string& place, const NamedParameter& named,
                 const ParameterSetting& setting) {
  const bool inside = setting.value >= setting.lower && setting.value <= setting.upper;
  if (inside || setting.value == named.parameter.off) return;
  throw InputError(
      place, fmt::format("{} = {} {}: expected {} to {}, or {} for off", named.name, setting.value,
                         named.parameter.unit, setting.lower, setting.upper, named.parameter.off));
}

bool IsOff(const std::string& name, FitConfig* config) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  const auto index = static_cast<std::size_t>(RequireParameter(table, name));
  return config->parameters[name].value == table[index].parameter.off;
}

}  // namespace

void SetParameter(const std::string& place, const std::string& assignment, FitConfig* config) {
  const size_t equals = assignment.find('=');
  const std::string name(TrimBlanks(assignment.substr(0, equals)));
  const std::vector<NamedParameter> table = MakeParameterTable();
  const int index = FindParameter(table, name);
  if (index < 0) FailUnknown(place, name, NamesOf(table));
  const std::optional<double> value =
      equals == std::string::npos ? std::nullopt : ParseNumber(assignment.substr(equals + 1));
  if (!value) {
    throw InputError(place, fmt::format("'{}': expected {}=NUMBER", assignment, name));
  }
  ParameterSetting& setting = config->parameters[name];
  setting.value = *value;
  CheckBounds(place, table[static_cast<size_t>(index)], setting);
}

void SetFree(const std::string& place, const std::string& name, bool free, FitConfig* config) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  bool is_known = false;
  for (const NamedParameter& named : table) {
    if (named.name != name && named.term != name) continue;
    is_known = true;
    ParameterSetting& setting = config->parameters[named.name];
    setting.free = free;
    const bool inside = setting.value >= setting.lower && setting.value <= setting.upper;
    if (!free || inside) continue;
    throw InputError(place, fmt::format("{} = {} {}: a free parameter starts inside its bounds, {} "
                                        "to {}; give it a start with --set",
                                        named.name, setting.value, named.parameter.unit,
                                        setting.lower, setting.upper));
  }
  if (is_known) return;
  std::vector<std::string> names = NamesOf(table);
  for (const std::string& term : NamesOf(AllTerms())) names.push_back(term);
  FailUnknown(place, name, names);
}

void SwitchOff(const std::string& place, const std::string& term, FitConfig* config) {
  const std::vector<std::string> terms = NamesOf(AllTerms());
  if (std::find(terms.begin(), terms.end(), term) == terms.end()) FailUnknown(place, term, terms);
  for (const NamedParameter& named : MakeParameterTable()) {
    if (named.term != term) continue;
    ParameterSetting& setting = config->parameters[named.name];
    setting.value = named.parameter.off;
    setting.free = false;
  }
}

void Attract(FitConfig* config) {
  config->attract = true;
  for (const TermInfo& term : AllTerms()) {
    if (term.role != Role::kGuide) continue;
    const std::string linear = term.name + ".linear", reciprocal = term.name + ".reciprocal";
    if (IsOff(linear, config) && IsOff(reciprocal, config))
      config->parameters[linear].value = kDefaultAttraction;
  }
}

}  // namespace clothfit
