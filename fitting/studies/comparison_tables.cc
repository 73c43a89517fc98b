// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A comparison as tables, curves and the file from which it goes on.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"
#include "fitting/pictures/line_chart.h"
#include "fitting/studies/comparison.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/json_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "clothfit-comparison/1";

// Of finite numbers.
struct Spread {
  int count = 0;
  double median = 0.0, least = 0.0, most = 0.0;

  explicit Spread(std::vector<double> values) {
    values.erase(std::remove_if(values.begin(), values.end(),
                                [](double value) { return !std::isfinite(value); }),
                 values.end());
    count = static_cast<int>(values.size());
    if (count == 0) return;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    least = values.front();
    most = values.back();
  }
  std::string Text(const char* format) const {
    if (count == 0) return "-";
    const auto number = [format](double value) { return fmt::format(fmt::runtime(format), value); };
    if (count == 1) return number(median);
    return number(median) + " (" + number(least) + " to " + number(most) + ")";
  }
};

std::vector<const ComparedRun*> RunsOf(const Comparison& comparison, const std::string& contender) {
  std::vector<const ComparedRun*> runs;
  for (const ComparedRun& run : comparison.runs) {
    if (run.contender == contender) runs.push_back(&run);
  }
  return runs;
}

template <class Get>
Spread Over(const std::vector<const ComparedRun*>& runs, const Get& get) {
  std::vector<double> values;
  for (const ComparedRun* run : runs) values.push_back(get(*run));
  return Spread(std::move(values));
}

// How many times less each run had spent when it reached where the run of the opponent from the
// same start ended than that one had when it got there; not a number where it never did.
template <class Get>
Spread Ratio(const std::vector<const ComparedRun*>& runs,
             const std::vector<const ComparedRun*>& opponents, const Get& get) {
  return Over(runs, [&](const ComparedRun& run) {
    for (const ComparedRun* opponent : opponents) {
      if (opponent->start != run.start || opponent->history.empty()) continue;
      const SearchPoint& end = opponent->history.back();
      const std::optional<SearchPoint> reached = run.FirstBelow(end.error);
      if (reached) return get(end) / std::max(1e-9, get(*reached));
    }
    return std::numeric_limits<double>::quiet_NaN();
  });
}

std::string Row(const Comparison& comparison, const std::string& contender) {
  const std::vector<const ComparedRun*> runs = RunsOf(comparison, contender);
  const std::vector<const ComparedRun*> opponents =
      RunsOf(comparison, comparison.contenders.back());
  const Spread fewer = Ratio(runs, opponents, [](const SearchPoint& p) { return p.simulations; });
  const Spread faster = Ratio(runs, opponents, [](const SearchPoint& p) { return p.seconds; });
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} | {} | {} of {} | {} | {} |\n", contender,
      Over(runs, [](const ComparedRun& r) { return r.error; }).Text("{:.0f}"),
      Over(runs, [](const ComparedRun& r) { return r.open_loop_error; }).Text("{:.0f}"),
      Over(runs,
           [](const ComparedRun& r) {
             return r.truth_rms ? 1e3 * *r.truth_rms : std::numeric_limits<double>::quiet_NaN();
           })
          .Text("{:.1f}"),
      Over(runs, [](const ComparedRun& r) { return r.simulations; }).Text("{:.0f}"),
      Over(runs, [](const ComparedRun& r) { return r.seconds; }).Text("{:.0f}"),
      std::count_if(runs.begin(), runs.end(), [](const ComparedRun* r) { return r->converged; }),
      fewer.count, runs.size(), fewer.Text("{:.1f}"), faster.Text("{:.1f}"));
}

Json ToJson(const ComparedRun& run) {
  Json json = {{"contender", run.contender}, {"start", run.start},
               {"error", run.error},         {"open_loop_error", run.open_loop_error},
               {"truth_rms", nullptr},       {"simulations", run.simulations},
               {"seconds", run.seconds},     {"converged", run.converged},
               {"reason", run.reason},       {"history", Json::array()}};
  if (run.truth_rms) json["truth_rms"] = *run.truth_rms;
  for (const SearchPoint& point : run.history)
    json["history"].push_back({point.simulations, point.seconds, point.error});
  return json;
}

// JSON has no infinite numbers: they are written as null.
double NumberOf(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

ComparedRun RunFrom(const Json& json) {
  ComparedRun run;
  run.contender = json.at("contender").get<std::string>();
  run.start = json.at("start").get<int>();
  run.error = NumberOf(json.at("error"));
  run.open_loop_error = NumberOf(json.at("open_loop_error"));
  if (!json.at("truth_rms").is_null()) run.truth_rms = json.at("truth_rms").get<double>();
  run.simulations = json.at("simulations").get<double>();
  run.seconds = json.at("seconds").get<double>();
  run.converged = json.at("converged").get<bool>();
  run.reason = json.at("reason").get<std::string>();
  for (const Json& point : json.at("history"))
    run.history.push_back({NumberOf(point.at(0)), NumberOf(point.at(1)), NumberOf(point.at(2))});
  return run;
}

}  // namespace

std::vector<ContenderStanding> Standings(const Comparison& comparison) {
  const auto opponents = RunsOf(comparison, comparison.contenders.back());
  std::vector<ContenderStanding> standings;
  for (const std::string& contender : comparison.contenders) {
    const std::vector<const ComparedRun*> runs = RunsOf(comparison, contender);
    if (runs.empty()) continue;
    const Spread fewer = Ratio(runs, opponents, [](const SearchPoint& p) { return p.simulations; });
    const Spread sooner = Ratio(runs, opponents, [](const SearchPoint& p) { return p.seconds; });
    standings.push_back({contender, static_cast<int>(runs.size()), fewer.count,
                         Over(runs, [](const ComparedRun& r) { return r.error; }).median,
                         fewer.median, sooner.median});
  }
  std::stable_sort(standings.begin(), standings.end(),
                   [](const auto& a, const auto& b) { return a.error < b.error; });
  return standings;
}

std::string ComparisonAsMarkdown(const Comparison& comparison) {
  std::string text = fmt::format(
      "{}: {} frames, {} particles, {} unknowns of which {} are the fabric's. A simulation with "
      "derivatives counts as {:.2f}.\n\n"
      "Median (least to most) over the starts. \"Sooner\" is what {} had spent when it reached its "
      "own best over what the other had when it was as low.\n\n"
      "| | error | from the start | mm from truth | simulations | seconds | converged | reached {} "
      "| "
      "simulations sooner | seconds sooner |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      comparison.recording, comparison.frames, comparison.particles, comparison.unknowns,
      comparison.fabric, comparison.derivative_cost, comparison.contenders.back(),
      comparison.contenders.back());
  for (const std::string& contender : comparison.contenders) text += Row(comparison, contender);
  return text;
}

std::string ComparisonRunsAsCsv(const Comparison& comparison) {
  std::string text =
      "contender,start,error,open_loop_error,truth_rms,simulations,seconds,converged,reason\n";
  for (const ComparedRun& run : comparison.runs) {
    text += fmt::format("{},{},{},{},{},{:.3f},{:.3f},{},\"{}\"\n", run.contender, run.start,
                        FormatNumber(run.error), FormatNumber(run.open_loop_error),
                        run.truth_rms ? fmt::format("{:.6f}", *run.truth_rms) : "", run.simulations,
                        run.seconds, run.converged ? 1 : 0, run.reason);
  }
  return text;
}

std::string ComparisonHistoryAsCsv(const Comparison& comparison) {
  std::string text = "contender,start,simulations,seconds,error\n";
  for (const ComparedRun& run : comparison.runs) {
    for (const SearchPoint& point : run.history) {
      text += fmt::format("{},{},{:.3f},{:.3f},{}\n", run.contender, run.start, point.simulations,
                          point.seconds, FormatNumber(point.error));
    }
  }
  return text;
}

std::string ComparisonAsSvg(const Comparison& comparison) {
  Chart simulations{comparison.recording + ": error against simulations",
                    "simulations of the recording",
                    "hard error",
                    true,
                    true,
                    {}};
  Chart seconds{"error against time", "s", "hard error", true, true, {}};
  for (const std::string& contender : comparison.contenders) {
    for (const ComparedRun* run : RunsOf(comparison, contender)) {
      ChartLine by_simulations{contender, {}, true, false}, by_seconds = by_simulations;
      for (const SearchPoint& point : run->history) {
        by_simulations.points.emplace_back(point.simulations, point.error);
        by_seconds.points.emplace_back(point.seconds, point.error);
      }
      if (!run->history.empty()) {
        const double best = run->history.back().error;
        by_simulations.points.emplace_back(run->simulations, best);
        by_seconds.points.emplace_back(run->seconds, best);
      }
      simulations.lines.push_back(std::move(by_simulations));
      seconds.lines.push_back(std::move(by_seconds));
    }
  }
  return ChartsAsSvg({simulations, seconds});
}

void WriteComparison(const std::filesystem::path& file, const Comparison& comparison) {
  Json json = {{"format", kFormat},
               {"recording", comparison.recording},
               {"frames", comparison.frames},
               {"particles", comparison.particles},
               {"unknowns", comparison.unknowns},
               {"fabric", comparison.fabric},
               {"derivative_cost", comparison.derivative_cost},
               {"contenders", comparison.contenders},
               {"runs", Json::array()}};
  for (const ComparedRun& run : comparison.runs) json["runs"].push_back(ToJson(run));
  WriteWholeFile(file, json.dump(1) + "\n");
}

Comparison ReadComparison(const std::filesystem::path& file) {
  return ReadJson<Json>(file, "is no comparison", [&](const Json& json) {
    if (json.at("format") != kFormat)
      throw InputError(file.string(), std::string("has another format; expected ") + kFormat);
    Comparison comparison;
    comparison.recording = json.at("recording").get<std::string>();
    comparison.frames = json.at("frames").get<int>();
    comparison.particles = json.at("particles").get<int>();
    comparison.unknowns = json.at("unknowns").get<int>();
    comparison.fabric = json.at("fabric").get<int>();
    comparison.derivative_cost = json.at("derivative_cost").get<double>();
    comparison.contenders = json.at("contenders").get<std::vector<std::string>>();
    for (const Json& run : json.at("runs")) comparison.runs.push_back(RunFrom(run));
    return comparison;
  });
}

}  // namespace clothfit
