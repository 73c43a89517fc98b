// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of a comparison: who came lower, and with how much less.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/report/kinds.h"
#include "fitting/report/records/record_file.h"
#include "fitting/report/scene_page.h"
#include "fitting/studies/comparison.h"
#include "tracking/text/json_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWholeComparison = "what 'clothfit compare' writes";

using Get = double (*)(const SearchPoint&);
double Simulations(const SearchPoint& point) { return point.simulations; }
double Seconds(const SearchPoint& point) { return point.seconds; }

std::string Times(double factor) {
  return factor >= 10.0 ? fmt::format("{:.0f}", factor) : fmt::format("{:.1f}", factor);
}

std::string Headline(const std::vector<ContenderStanding>& standings) {
  const ContenderStanding& best = standings.front();
  if (standings.size() == 1) return best.name + " ran alone.";
  const ContenderStanding& second = standings[1];
  if (!(best.error < second.error)) return best.name + " and " + second.name + " end equally low.";
  return fmt::format("{} ends lower than {}.", best.name,
                     standings.size() == 2 ? second.name : "all others");
}

std::string LeadSentence(const ContenderStanding& standing, const std::string& opponent) {
  if (standing.reached == 0) {
    return fmt::format("{} never came as low as {} from the same start.", standing.name, opponent);
  }
  const auto compare = [](double factor, const char* fewer, const char* more) {
    return factor >= 1.0 ? Times(factor) + " times " + fewer
                         : Times(1.0 / factor) + " times " + more;
  };
  return fmt::format("{} was as low as {} came in the end from {} of {} starts, with {} and {}.",
                     standing.name, opponent, standing.reached, standing.runs,
                     compare(standing.simulations_lead, "fewer simulations", "as many simulations"),
                     compare(standing.seconds_lead, "sooner", "later"));
}

PageVerdict VerdictOf(const Comparison& comparison,
                      const std::vector<ContenderStanding>& standings) {
  PageVerdict verdict;
  verdict.grade = PageVerdict::Grade::kGood;
  verdict.headline = Headline(standings);
  const std::string& opponent = comparison.contenders.back();
  for (const ContenderStanding& standing : standings) {
    if (standing.name != opponent) verdict.sentences.push_back(LeadSentence(standing, opponent));
  }
  const int starts = standings.front().runs;
  verdict.sentences.push_back(
      fmt::format("{}: {} frames, {} particles, {} unknowns; {}.", comparison.recording,
                  comparison.frames, comparison.particles, comparison.unknowns,
                  starts == 1 ? "one start" : fmt::format("medians over {} starts", starts)));
  const bool is_whole = std::all_of(standings.begin(), standings.end(),
                                    [&](const auto& s) { return s.runs == starts; });
  if (!is_whole) {
    verdict.grade = PageVerdict::Grade::kPartial;
    verdict.sentences.emplace_back("Some contenders have fewer starts: it was interrupted.");
  }
  return verdict;
}

int ContenderIndex(const Comparison& comparison, const std::string& name) {
  const auto found = std::find(comparison.contenders.begin(), comparison.contenders.end(), name);
  return static_cast<int>(found - comparison.contenders.begin());
}

// The best error so far of each run over what had been spent; both axes logarithmic.
ReportJson ErrorChart(const Comparison& comparison, const char* title, const char* unit, Get get,
                      double ComparedRun::*end) {
  std::map<double, std::vector<std::pair<std::size_t, double>>> points;  // by x: run, error
  for (std::size_t r = 0; r < comparison.runs.size(); ++r) {
    const ComparedRun& run = comparison.runs[r];
    for (const SearchPoint& point : run.history) {
      if (get(point) > 0.0 && point.error > 0.0 && std::isfinite(point.error))
        points[get(point)].emplace_back(r, point.error);
    }
    if (!run.history.empty() && run.*end > 0.0)
      points[run.*end].emplace_back(r, run.history.back().error);
  }
  ReportJson x = ReportJson::array(), series = ReportJson::array();
  for (const auto& [place, errors] : points) x.push_back(place);
  for (std::size_t r = 0; r < comparison.runs.size(); ++r) {
    const ComparedRun& run = comparison.runs[r];
    ReportJson values = ReportJson::array();
    for (const auto& [place, errors] : points) {
      ReportJson value;
      for (const auto& [index, error] : errors) value = index == r ? ReportJson(error) : value;
      values.push_back(value);
    }
    series.push_back({{"name", fmt::format("{}, start {}", run.contender, run.start)},
                      {"colour", ContenderIndex(comparison, run.contender)},
                      {"steps", true},
                      {"values", values}});
  }
  return {{"kind", "lines"},
          {"title", title},
          {"narrow", false},
          {"tall", true},
          {"x", {{"title", title}, {"unit", unit}, {"log", true}, {"values", x}}},
          {"y", {{"title", "error"}, {"unit", ""}, {"log", true}}},
          {"series", series}};
}

ReportJson Column(const std::string& title, const char* unit = "") {
  return {{"title", title}, {"unit", unit}, {"number", true}};
}

ReportJson StandingTable(const Comparison& comparison,
                         const std::vector<ContenderStanding>& standings) {
  ReportJson rows = ReportJson::array();
  for (const ContenderStanding& s : standings) {
    rows.push_back({s.name, OrNull(s.error), s.runs, s.reached,
                    s.reached > 0 ? OrNull(s.simulations_lead) : ReportJson(),
                    s.reached > 0 ? OrNull(s.seconds_lead) : ReportJson()});
  }
  const std::string opponent = comparison.contenders.back();
  return {{"kind", "table"},
          {"sortable", true},
          {"columns",
           {{{"title", "contender"}, {"code", true}},
            Column("error, median"),
            Column("starts"),
            Column("as low as " + opponent),
            Column("times fewer simulations"),
            Column("times sooner")}},
          {"rows", rows}};
}

ReportJson RunTable(const Comparison& comparison) {
  ReportJson rows = ReportJson::array();
  for (const ComparedRun& run : comparison.runs) {
    rows.push_back({run.contender, run.start, OrNull(run.error), OrNull(run.open_loop_error),
                    run.truth_rms ? ReportJson(1e3 * *run.truth_rms) : ReportJson(),
                    OrNull(run.simulations), OrNull(run.seconds), run.converged ? "yes" : "no",
                    run.reason});
  }
  return {{"kind", "table"},
          {"title", "Every run"},
          {"sortable", true},
          {"columns",
           {{{"title", "contender"}, {"code", true}},
            Column("start"),
            Column("error"),
            Column("from the start"),
            Column("from truth", "mm"),
            Column("simulations"),
            Column("seconds", "s"),
            {{"title", "converged"}},
            {{"title", "why it ended"}}}},
          {"rows", rows}};
}

ReportJson FilesSection(const fs::path& folder) {
  ReportJson blocks = ReportJson::array();
  for (const char* name : {"conditions.yaml", "config.yaml"}) {
    blocks.push_back({{"kind", "code"},
                      {"title", name},
                      {"folded", true},
                      {"text", ReadTextFile(RequireFile(folder / name, kWholeComparison))}});
  }
  return SectionOf("configuration", "Configuration", blocks);
}

ReportJson ChartSection(const Comparison& comparison) {
  ReportJson blocks = ReportJson::array();
  blocks.push_back(ErrorChart(comparison, "Simulations of the recording", "", Simulations,
                              &ComparedRun::simulations));
  blocks.push_back(ErrorChart(comparison, "Time", "s", Seconds, &ComparedRun::seconds));
  ReportJson section = SectionOf("errors", "Error against what was spent", blocks);
  section["lead"] = fmt::format(
      "The least error so far of each run; one colour a contender. A simulation with derivatives "
      "counts as {:.2f}.",
      comparison.derivative_cost);
  return section;
}

}  // namespace

ReportPage MakeComparisonReport(const fs::path& folder, const ReportAssets& assets) {
  const fs::path file = RequireFile(folder / "comparison.json", kWholeComparison);
  const Comparison comparison = ReadComparison(file);
  if (comparison.runs.empty() || comparison.contenders.empty()) {
    throw InputError(file.string(), "holds no run that ended; 'clothfit compare --resume' goes on");
  }
  const std::vector<ContenderStanding> standings = Standings(comparison);
  ReportJson table = SectionOf("standings", "Contenders",
                               {StandingTable(comparison, standings), RunTable(comparison)});
  table["lead"] = fmt::format(
      "How many times less each had spent when it was as low as {} came in the end from the same "
      "start, medians.",
      comparison.contenders.back());
  ReportJson json;
  json["title"] = "Comparison on " + comparison.recording;
  json["sections"] = {ChartSection(comparison), table, FilesSection(folder)};
  return AsReportPage(std::move(json), VerdictOf(comparison, standings), {}, assets);
}

}  // namespace clothfit
