// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How the fit went: costs, time, and the configuration that decided it.
#include <algorithm>

#include <fmt/format.h>

#include "fitting/report/sections/sections.h"

namespace clothfit {
namespace {

struct Stage {
  std::string name;
  std::vector<const ProgressRow*> rows;
  double begin = 0.0, end = 0.0;  // s since the fit began
};

std::vector<Stage> StagesOf(const std::vector<ProgressRow>& progress) {
  std::vector<Stage> stages;
  double last = 0.0;
  for (const ProgressRow& row : progress) {
    if (stages.empty() || stages.back().name != row.stage) {
      stages.push_back({row.stage, {}, last, last});
    }
    stages.back().rows.push_back(&row);
    stages.back().end = last = row.seconds;
  }
  for (Stage& stage : stages) std::replace(stage.name.begin(), stage.name.end(), ';', ',');
  return stages;
}

// One series a stage, over the seconds of the whole fit.
ReportJson CostChart(const std::vector<Stage>& stages) {
  ReportJson x = ReportJson::array(), series = ReportJson::array();
  std::size_t done = 0, total = 0;
  for (const Stage& stage : stages) total += stage.rows.size();
  for (const Stage& stage : stages) {
    ReportJson values = ReportJson::array();
    for (std::size_t i = 0; i < total; ++i) {
      const bool inside = i >= done && i < done + stage.rows.size();
      values.push_back(inside ? ReportJson(stage.rows[i - done]->cost) : ReportJson());
    }
    for (const ProgressRow* row : stage.rows) x.push_back(row->seconds);
    done += stage.rows.size();
    series.push_back({{"name", stage.name}, {"points", true}, {"values", values}});
  }
  return {{"kind", "lines"},
          {"title", "Cost"},
          {"x", {{"title", "since the fit began"}, {"unit", "s"}, {"values", x}}},
          {"y", {{"title", "Cost"}, {"unit", ""}, {"log", true}}},
          {"series", series}};
}

std::string NumberIn(const ReportJson& summary, const char* key, const char* format) {
  const auto found = summary.find(key);
  if (found == summary.end() || !found->is_number()) return "not known";
  return fmt::format(fmt::runtime(format), found->get<double>());
}

ReportJson Facts(const ReportJson& summary) {
  ReportJson rows = ReportJson::array();
  rows.push_back({"status", summary.at("status")});
  rows.push_back({"iterations", NumberIn(summary, "iterations", "{:.0f}")});
  rows.push_back(
      {"simulations of the whole recording", NumberIn(summary, "simulations", "{:.0f}")});
  rows.push_back({"simulated frames", NumberIn(summary, "simulated_frames", "{:.0f}")});
  rows.push_back({"seconds", NumberIn(summary, "seconds", "{:.1f}")});
  rows.push_back({"steps halved in the last simulation", NumberIn(summary, "halvings", "{:.0f}")});
  return {{"kind", "table"},
          {"narrow", true},
          {"columns", {{{"title", ""}}, {{"title", ""}, {"number", true}}}},
          {"rows", rows}};
}

}  // namespace

ReportJson ConvergenceSection(const ReportScene& report) {
  ReportJson blocks = ReportJson::array();
  const std::vector<Stage> stages = StagesOf(report.record.progress);
  if (!stages.empty()) blocks.push_back(CostChart(stages));
  blocks.push_back(Facts(report.record.summary));
  ReportJson section = SectionOf("convergence", "Convergence", blocks);
  section["lead"] =
      "Half the sum of squared residuals, in their sigmas. Stages have costs of their own: a "
      "coarser mesh, or fewer frames, is another problem.";
  return section;
}

ReportJson TimeSection(const ReportScene& report) {
  ReportJson items = ReportJson::array();
  double end = 0.0;
  for (const Stage& stage : StagesOf(report.record.progress)) {
    items.push_back({{"name", stage.name},
                     {"value", stage.end - stage.begin},
                     {"note", fmt::format("{} iterations", stage.rows.size() - 1)}});
    end = stage.end;
  }
  const ReportJson seconds = report.record.summary.value("seconds", ReportJson());
  if (!items.empty() && seconds.is_number() && seconds.get<double>() > end) {
    items.push_back({{"name", "the rest: intervals, evaluation"},
                     {"value", seconds.get<double>() - end},
                     {"note", ""}});
  }
  ReportJson blocks = ReportJson::array();
  if (!items.empty()) {
    blocks.push_back({{"kind", "bars"}, {"title", "Seconds"}, {"unit", "s"}, {"items", items}});
  }
  return SectionOf("time", "Where the time went", blocks, "Time");
}

ReportJson ConfigurationSection(const ReportScene& report) {
  const ReportJson& summary = report.record.summary;
  ReportJson blocks = ReportJson::array();
  blocks.push_back(TextBlock(
      {fmt::format("Made by clothfit {}. 'clothfit fit --config' takes this file as it is.",
                   summary.value("clothfit", "")),
       "Recording: " + report.scene().recording.path.string()}));
  blocks.push_back({{"kind", "code"},
                    {"title", "config.yaml"},
                    {"folded", true},
                    {"text", report.record.config}});
  blocks.push_back(
      {{"kind", "code"}, {"title", "log.txt"}, {"folded", true}, {"text", report.record.log}});
  return SectionOf("configuration", "Configuration", blocks);
}

}  // namespace clothfit
