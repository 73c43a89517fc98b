// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Parameters with what is known of them before and after the fit.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/report/sections/sections.h"
#include "tracking/recording/surface/truth.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kSigmas = 1.96;  // of a 95 % interval

// The 95 % interval of the prior.
std::array<double, 2> PriorInterval(const ParameterSetting& setting, bool is_log) {
  if (is_log) {
    const double factor = std::pow(setting.prior_sigma, kSigmas);
    return {setting.prior / factor, setting.prior * factor};
  }
  return {setting.prior - kSigmas * setting.prior_sigma,
          setting.prior + kSigmas * setting.prior_sigma};
}

std::map<std::string, double> TrueParameters(const ReportScene& report) {
  const Recording& recording = report.scene().recording;
  if (HasTruthParameters(recording.path)) return ReadTruthParameters(recording.path);
  if (report.pictures && HasTruthParameters(report.pictures->path)) {
    return ReadTruthParameters(report.pictures->path);
  }
  return {};
}

std::string Note(const ReportJson& estimate) {
  std::string note;
  if (estimate.at("determined") == false) note = "left to its prior";
  if (estimate.at("at_bound") == true) note += note.empty() ? "at its bound" : ", at its bound";
  return note;
}

ReportJson IntervalItem(const NamedParameter& named, const ReportJson& estimate,
                        const ParameterSetting& setting,
                        const std::map<std::string, double>& truth) {
  const bool is_log = named.parameter.scale == Scale::kLog;
  const auto true_value = truth.find(named.name);
  return {{"name", named.name},
          {"doc", named.parameter.doc},
          {"unit", named.parameter.unit},
          {"scale", is_log ? "log" : "linear"},
          {"bounds", {setting.lower, setting.upper}},
          {"prior", PriorInterval(setting, is_log)},
          {"start", estimate.at("start")},
          {"value", estimate.at("value")},
          {"interval", estimate.at("interval")},
          {"truth", true_value == truth.end() ? ReportJson() : ReportJson(true_value->second)},
          {"muted", estimate.at("determined") == false},
          {"note", Note(estimate)}};
}

// "9 of 10 intervals hold the truth." of what the data determine; empty where no truth is known.
std::string CountTruth(const ReportJson& items) {
  int known = 0, held = 0;
  for (const ReportJson& item : items) {
    const ReportJson& truth = item.at("truth");
    const ReportJson& ends = item.at("interval");
    if (item.at("muted") == true || !truth.is_number() || !ends.at(0).is_number()) continue;
    ++known;
    held += truth >= ends.at(0) && truth <= ends.at(1) ? 1 : 0;
  }
  return known == 0 ? "" : fmt::format("{} of {} intervals hold the truth.", held, known);
}

// Parameters that were held, and what they were held at.
ReportJson FixedTable(const ReportJson& parameters, const std::vector<NamedParameter>& table) {
  ReportJson rows = ReportJson::array();
  for (const NamedParameter& named : table) {
    const auto estimate = parameters.find(named.name);
    if (estimate == parameters.end() || estimate->at("free") == true) continue;
    rows.push_back({named.name, estimate->at("value"), named.parameter.unit, named.parameter.doc});
  }
  return {{"kind", "table"},
          {"title", "Held fixed"},
          {"folded", true},
          {"columns",
           {{{"title", "parameter"}, {"code", true}},
            {{"title", "value"}, {"number", true}},
            {{"title", "unit"}},
            {{"title", "meaning"}}}},
          {"rows", rows}};
}

std::vector<std::string> Statements(const ReportJson& summary) {
  std::vector<std::string> statements;
  for (const ReportJson& statement : summary.value("statements", ReportJson::array()))
    statements.push_back(AsSentence(statement.get<std::string>()));
  return statements;
}

}  // namespace

ReportJson ParameterSection(const ReportScene& report) {
  return ParameterSection(report.record.summary, report.fitted.config, TrueParameters(report));
}

ReportJson ParameterSection(const ReportJson& summary, const FitConfig& config,
                            const std::map<std::string, double>& truth) {
  const ReportJson& parameters = summary.at("parameters");
  const std::vector<NamedParameter> table = MakeParameterTable();
  ReportJson items = ReportJson::array();
  for (const NamedParameter& named : table) {
    const auto estimate = parameters.find(named.name);
    if (estimate == parameters.end() || estimate->at("free") != true) continue;
    items.push_back(IntervalItem(named, *estimate, config.parameters.at(named.name), truth));
  }
  ReportJson blocks = ReportJson::array();
  const std::vector<std::string> statements = Statements(summary);
  if (!statements.empty()) blocks.push_back(TextBlock(statements));
  if (!items.empty()) blocks.push_back({{"kind", "intervals"}, {"items", items}});
  const std::string count = CountTruth(items);
  if (!count.empty()) blocks.push_back(TextBlock({count}));
  int others = 0;
  for (const auto& [name, estimate] : parameters.items()) {
    others += estimate.at("free") == true && FindParameter(table, name) < 0 ? 1 : 0;
  }
  if (others > 0) {
    blocks.push_back(TextBlock({fmt::format(
        "Besides, {} numbers of hidden handle paths and the initial state were found.", others)}));
  }
  blocks.push_back(FixedTable(parameters, table));
  ReportJson section = SectionOf("parameters", "Parameters", blocks);
  section["lead"] =
      "Each bar is a 95 % interval on the parameter's own scale: pale what was known before the "
      "fit, strong what is known after it. A strong bar as wide as the pale one means that the "
      "recording says nothing. A strong bar holds noise, and what mesh and step leave where that "
      "was measured; it does not hold physics that the model lacks.";
  return section;
}

}  // namespace clothfit
