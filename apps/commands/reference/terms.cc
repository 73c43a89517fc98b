// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit terms: the force terms and their parameters, from the one place where they stand.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "apps/commands/commands.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {
namespace {

const char* ScaleName(const Parameter& parameter) {
  return parameter.scale == Scale::kLog ? "log" : "linear";
}

const char* MeaningName(Meaning meaning) {
  switch (meaning) {
    case Meaning::kVectorX:
      return "vector x";
    case Meaning::kVectorY:
      return "vector y";
    case Meaning::kVectorZ:
      return "vector z";
    case Meaning::kPlaceX:
      return "place x";
    case Meaning::kPlaceY:
      return "place y";
    case Meaning::kPlaceZ:
      return "place z";
    case Meaning::kClothU:
      return "place on the cloth u";
    case Meaning::kClothV:
      return "place on the cloth v";
    case Meaning::kClothDistance:
      return "distance on the cloth";
    case Meaning::kTime:
      return "time";
    case Meaning::kTilt:
      return "tilt";
    case Meaning::kAlongTilt:
      return "place along the tilted direction";
    case Meaning::kNumber:
      break;
  }
  return "number";
}

std::vector<double> ProbeValues(const Parameter& p) {
  return {p.probes.values.begin(), p.probes.values.begin() + p.probes.count};
}

// What is tried while the term is off; places and times in shares of what was recorded.
std::string ProbeText(const Parameter& p) {
  if (p.probes.count == 0) return "";
  const bool is_share = p.meaning != Meaning::kNumber && p.meaning != Meaning::kTilt;
  return fmt::format(" (tried{}: {:g})", is_share ? " at shares" : "",
                     fmt::join(ProbeValues(p), ", "));
}

std::string ParameterRow(const std::string& name, const Parameter& p) {
  return fmt::format("  {:<28}{:<12}{:>10g}{:>10g}  {:<22}{:<8}{}{}\n", name, p.unit, p.initial,
                     p.off, fmt::format("{:g} .. {:g}", p.lower, p.upper), ScaleName(p), p.doc,
                     ProbeText(p));
}

std::vector<std::string> TieNames(const TermInfo& term) {
  std::vector<std::string> names;
  for (const Tie tie : term.ties) names.emplace_back(ToString(tie));
  return names;
}

// "may be missing; drives; tied to world"
std::string KindOf(const TermInfo& term) {
  std::string kind = fmt::format("{}; {}; tied to {}", ToString(term.role), ToString(term.work),
                                 fmt::join(TieNames(term), " and "));
  if (term.needs != Needs::kNothing) kind += fmt::format("; needs {}", ToString(term.needs));
  return kind;
}

constexpr const char* kCloth = "cloth";  // what the cloth is, beside the terms

void PrintTerm(const TermInfo& term) {
  Print("\n{}: {} ({})\n  {}\n", term.name, term.doc, term.reference, KindOf(term));
  for (const Parameter& p : term.parameters) Print("{}", ParameterRow(term.name + "." + p.name, p));
}

void PrintCloth() {
  const std::vector<NamedParameter> table = MakeParameterTable();
  Print("\n{}: what the cloth is\n", kCloth);
  for (int i = 0; i < kNumClothParameters; ++i)
    Print("{}", ParameterRow(table[i].name, table[i].parameter));
}

// How these parameters, or those of any term, are used.
void PrintUse(const std::vector<std::string>& names) {
  std::string term = "TERM", parameter = "TERM.PARAMETER";
  if (names.size() == 1) {
    term = names[0];
    for (const NamedParameter& named : MakeParameterTable()) {
      if (named.term != term) continue;
      parameter = named.name;
      break;
    }
  }
  PrintNext(fmt::format("clothfit fit RECORDING --set {}=VALUE --free {}", parameter, term));
}

void PrintSummary() {
  Print("{:<22}{}\n", kCloth, "what the cloth is");
  for (const TermInfo& term : AllTerms()) Print("{:<22}{}\n", term.name, term.doc);
  PrintNext("clothfit terms TERM for its parameters, --all for those of all");
}

// Those that are named, or all.
void PrintTables(const std::vector<std::string>& names) {
  std::vector<std::string> right = {kCloth};
  for (const TermInfo& term : AllTerms()) right.emplace_back(term.name);
  for (const std::string& name : names) {
    if (std::find(right.begin(), right.end(), name) == right.end())
      throw InputError("TERM", "'" + name + "': " + Suggestion(name, right));
  }
  const auto is_asked = [&names](const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  Print("  {:<28}{:<12}{:>10}{:>10}  {:<22}{:<8}{}\n", "parameter", "unit", "initial", "off",
        "bounds", "scale", "meaning");
  if (is_asked(kCloth)) PrintCloth();
  for (const TermInfo& term : AllTerms()) {
    if (is_asked(term.name)) PrintTerm(term);
  }
  PrintUse(names);
}

nlohmann::ordered_json ParameterAsJson(const std::string& name, const Parameter& p) {
  return {{"name", name},
          {"unit", p.unit},
          {"doc", p.doc},
          {"initial", p.initial},
          {"off", p.off},
          {"lower", p.lower},
          {"upper", p.upper},
          {"scale", ScaleName(p)},
          {"prior_sigma", p.prior_factor},
          {"meaning", MeaningName(p.meaning)},
          {"probes", ProbeValues(p)},
          {"free", p.is_free}};
}

void PrintJson() {
  const std::vector<NamedParameter> table = MakeParameterTable();
  nlohmann::ordered_json json;
  json["cloth"] = nlohmann::ordered_json::array();
  for (int i = 0; i < kNumClothParameters; ++i) {
    json["cloth"].push_back(ParameterAsJson(table[i].name, table[i].parameter));
  }
  json["terms"] = nlohmann::ordered_json::array();
  for (const TermInfo& term : AllTerms()) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const Parameter& p : term.parameters) {
      parameters.push_back(ParameterAsJson(term.name + "." + p.name, p));
    }
    json["terms"].push_back({{"name", term.name},
                             {"doc", term.doc},
                             {"reference", term.reference},
                             {"role", ToString(term.role)},
                             {"work", ToString(term.work)},
                             {"tied_to", TieNames(term)},
                             {"needs", ToString(term.needs)},
                             {"parameters", std::move(parameters)}});
  }
  Print("{}\n", json.dump(2));
}

}  // namespace

void AddTermsCommand(CLI::App* app, Action* action) {
  struct TermsOptions {
    std::vector<std::string> terms;
    bool all = false, json = false;
  };
  CLI::App* const command =
      app->add_subcommand("terms", "list the force terms, or the parameters of some");
  const auto options = std::make_shared<TermsOptions>();
  command->add_option("TERM", options->terms, "terms whose parameters are listed");
  command->add_flag("--all", options->all, "list the parameters of all terms");
  command->add_flag("--json", options->json, "all terms and parameters as JSON");
  command->footer("Examples:\n  clothfit terms\n  clothfit terms air_drag wind");
  command->callback([options, action] {
    *action = [options] {
      if (options->json) {
        PrintJson();
      } else if (options->terms.empty() && !options->all) {
        PrintSummary();
      } else {
        PrintTables(options->terms);
      }
      return kExitSuccess;
    };
  });
}

}  // namespace clothfit
