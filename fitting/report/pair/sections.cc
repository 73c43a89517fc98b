// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/pair/sections.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "tracking/recording/surface/truth.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

ReportJson PairColumn(const std::string& title, bool is_number = true) {
  return {{"title", title}, {"number", is_number}};
}

std::string InPercent(double first, double second) {
  if (!(first > 0.0)) return "";
  return fmt::format("{:+.0f} %", 100.0 * (second / first - 1.0));
}

// One row: what, the first's, the second's, second less first, and that in per cent of the first.
ReportJson ErrorRow(const PairedError& error) {
  const std::string kind =
      error.kind == "silhouettes" ? "outlines, area that differs" : error.kind + ", rms";
  const auto cell = [&error](const std::optional<double>& value) {
    return value ? ReportJson(QuantityInWords(*value, error.unit)) : ReportJson();
  };
  ReportJson row = {kind + (error.held_out ? ", held out" : ", fitted"), cell(error.first),
                    cell(error.second), nullptr, nullptr};
  if (!error.first || !error.second) return row;
  const double change = *error.second - *error.first;
  row[3] = (change < 0.0 ? "-" : "+") + QuantityInWords(std::abs(change), error.unit);
  row[4] = InPercent(*error.first, *error.second);
  return row;
}

ReportJson NumberRow(const std::string& name, std::optional<double> first,
                     std::optional<double> second, int digits = 3) {
  const auto cell = [digits](std::optional<double> value) {
    return value && std::isfinite(*value) ? ReportJson(fmt::format("{:.{}g}", *value, digits))
                                          : ReportJson();
  };
  ReportJson row = {name, cell(first), cell(second), nullptr, nullptr};
  if (!first || !second || !std::isfinite(*first) || !std::isfinite(*second)) return row;
  row[3] = fmt::format("{:+.{}g}", *second - *first, digits);
  row[4] = InPercent(*first, *second);
  return row;
}

std::optional<double> NumberOf(const PairedRun& run, const char* key) {
  const ReportJson& summary = run.scene.record.summary;
  const auto found = summary.find(key);
  if (found == summary.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::optional<double> ChiSquare(const PairedRun& run) {
  return run.facts.misfit ? std::optional<double>(run.facts.misfit->chi_square) : std::nullopt;
}

std::optional<double> WithoutMesh(const PairedRun& run) {
  return run.facts.misfit ? run.facts.misfit->without_discretisation : std::nullopt;
}

using PairNumber = std::optional<double> (*)(const PairedRun&);

void AddIfKnown(const RunPair& pair, const std::string& name, PairNumber get, ReportJson* rows) {
  const auto first = get(pair.first), second = get(pair.second);
  if (first || second) rows->push_back(NumberRow(name, first, second));
}

// Seconds at which either recording has a frame, and the value of each there, or nothing.
using Course = std::map<double, std::array<ReportJson, 2>>;
using Member = std::optional<double> FrameMisfit::*;

void AddCourse(const PairedRun& run, std::size_t side, Member member, double factor,
               Course* course) {
  const double rate = run.scene.scene().recording.frame_rate;
  for (std::size_t f = 0; f < run.misfits.size(); ++f) {
    const std::optional<double>& value = run.misfits[f].*member;
    if (value) (*course)[static_cast<double>(f) / rate][side] = factor * *value;
  }
}

void AddErrorChart(const RunPair& pair, Member member, const char* title, const char* unit,
                   double factor, ReportJson* blocks) {
  Course course;
  AddCourse(pair.first, 0, member, factor, &course);
  AddCourse(pair.second, 1, member, factor, &course);
  if (course.empty()) return;
  ReportJson x = ReportJson::array(), first = x, second = x;
  for (const auto& [time, values] : course) {
    x.push_back(time);
    first.push_back(values[0]);
    second.push_back(values[1]);
  }
  const ReportJson series = {
      {{"name", pair.first.name}, {"role", "before"}, {"joined", true}, {"values", first}},
      {{"name", pair.second.name}, {"role", "after"}, {"joined", true}, {"values", second}}};
  blocks->push_back({{"kind", "lines"},
                     {"title", title},
                     {"x", {{"title", "time"}, {"unit", "s"}, {"values", x}}},
                     {"y", {{"title", title}, {"unit", unit}, {"from_zero", true}}},
                     {"series", series}});
}

std::string NoteOf(const PairedParameter::Side& side) {
  if (!side.is_free) return side.value ? "held" : "not there";
  std::string note = side.is_determined ? "" : "left to its prior";
  if (side.is_at_bound) note += note.empty() ? "at its bound" : ", at its bound";
  return note;
}

ReportJson SideAsJson(const PairedParameter::Side& side) {
  return {{"value", side.value ? ReportJson(*side.value) : ReportJson()},
          {"interval", side.interval ? ReportJson(*side.interval) : ReportJson()},
          {"note", NoteOf(side)},
          {"muted", !side.is_free || !side.is_determined}};
}

// "1.23 times" or "+0.004"; what that is in joint intervals.
std::string DifferenceInWords(const PairedParameter& pair) {
  if (!pair.difference) return "";
  std::string words = pair.is_log ? fmt::format("{:.3g} times", std::exp(*pair.difference))
                                  : fmt::format("{:+.3g}", *pair.difference);
  if (pair.in_joint_intervals)
    words += fmt::format(", {:.2g} joint intervals", std::abs(*pair.in_joint_intervals));
  return words;
}

std::map<std::string, double> TruthOf(const RunPair& pair) {
  const Recording& recording = pair.first.scene.scene().recording;
  if (!pair.is_one_recording || !HasTruthParameters(recording.path)) return {};
  return ReadTruthParameters(recording.path);
}

ReportJson ParameterItem(const PairedParameter& pair, const std::map<std::string, double>& truth) {
  const auto true_value = truth.find(pair.name);
  return {{"name", pair.name},
          {"doc", pair.doc},
          {"unit", pair.unit},
          {"scale", pair.is_log ? "log" : "linear"},
          {"bounds", pair.bounds},
          {"sides", {SideAsJson(pair.first), SideAsJson(pair.second)}},
          {"truth", true_value == truth.end() ? ReportJson() : ReportJson(true_value->second)},
          {"difference", DifferenceInWords(pair)},
          {"marked", pair.Disagrees()}};
}

ReportJson FactsOfRecordings(const RunPair& pair) {
  ReportJson rows = ReportJson::array();
  const auto add = [&](const char* what, auto get) {
    rows.push_back({what, get(pair.first.scene.scene()), get(pair.second.scene.scene())});
  };
  add("recording", [](const Scene& s) { return s.recording.name; });
  add("folder", [](const Scene& s) { return s.recording.path.string(); });
  add("frames, rate", [](const Scene& s) {
    return fmt::format("{}, {:.4g} Hz", s.recording.frame_count, s.recording.frame_rate);
  });
  add("cloth", [](const Scene& s) {
    return fmt::format("{:.4g} m x {:.4g} m", s.recording.cloth.size.x(),
                       s.recording.cloth.size.y());
  });
  add("held out", [](const Scene& s) {
    const auto& held_out = s.recording.splits.held_out_frames;
    return held_out ? fmt::format("frames {} to {}", held_out->first, held_out->last)
                    : std::string("no frames");
  });
  add("markers, tracks",
      [](const Scene& s) { return fmt::format("{}, {}", s.markers.size(), s.tracks.size()); });
  return {{"kind", "table"},
          {"title", "Recordings"},
          {"columns",
           {PairColumn("", false), PairColumn(pair.first.name, false),
            PairColumn(pair.second.name, false)}},
          {"rows", rows}};
}

}  // namespace

ReportJson PairNumberSection(const RunPair& pair) {
  ReportJson rows = ReportJson::array();
  for (const PairedError& error : PairErrors(pair.first.facts, pair.second.facts))
    rows.push_back(ErrorRow(error));
  AddIfKnown(pair, "chi-square of the residuals", ChiSquare, &rows);
  AddIfKnown(pair, "chi-square without what mesh and step leave", WithoutMesh, &rows);
  AddIfKnown(
      pair, "what is left, in stated noise",
      [](const PairedRun& run) { return run.facts.noise_factor; }, &rows);
  AddIfKnown(
      pair, "simulations of the whole recording",
      [](const PairedRun& run) { return NumberOf(run, "simulations"); }, &rows);
  AddIfKnown(
      pair, "seconds", [](const PairedRun& run) { return NumberOf(run, "seconds"); }, &rows);
  const auto particles = [](const PairedRun& run) {
    return std::optional<double>(run.scene.scene().mesh.num_particles());
  };
  AddIfKnown(pair, "particles", particles, &rows);
  rows.push_back({"status", pair.first.facts.status, pair.second.facts.status, nullptr, nullptr});
  ReportJson table = {{"kind", "table"},
                      {"columns",
                       {{{"title", ""}, {"wide", true}},
                        PairColumn(pair.first.name),
                        PairColumn(pair.second.name),
                        PairColumn("difference"),
                        PairColumn("in per cent")}},
                      {"rows", rows}};
  ReportJson section =
      SectionOf("numbers", "Number by number", ReportJson::array({table}), "Numbers");
  section["lead"] =
      "From frame 0 on, driven by the handles alone. The difference is the second's "
      "less the first's. Of chi-square 1 is expected of noise.";
  return section;
}

ReportJson PairErrorSection(const RunPair& pair) {
  ReportJson blocks = ReportJson::array();
  AddErrorChart(pair, &FrameMisfit::markers, "Markers", "mm", 1e3, &blocks);
  AddErrorChart(pair, &FrameMisfit::tracks, "Tracks", "px", 1.0, &blocks);
  AddErrorChart(pair, &FrameMisfit::clouds, "Clouds, distance from the surface", "mm", 1e3,
                &blocks);
  AddErrorChart(pair, &FrameMisfit::silhouettes, "Silhouettes, pixels that differ", "px", 1.0,
                &blocks);
  AddErrorChart(pair, &FrameMisfit::truth, "Distance from the truth", "mm", 1e3, &blocks);
  ReportJson section = SectionOf("errors", "Error over time", blocks, "Errors");
  section["lead"] =
      "Root mean square in each frame, silhouettes as the mean over the cameras; each "
      "over the seconds of its own recording.";
  return section;
}

ReportJson ApartChart(const std::vector<double>& apart) {
  ReportJson values = ReportJson::array();
  for (const double distance : apart) values.push_back(1e3 * distance);
  const ReportJson series = {{"name", "distance"}, {"values", values}};
  return {{"kind", "lines"},
          {"title", "The two cloths from each other"},
          {"frames", true},
          {"y", {{"title", "distance"}, {"unit", "mm"}, {"from_zero", true}}},
          {"series", ReportJson::array({series})}};
}

ReportJson PairParameterSection(const RunPair& pair,
                                const std::vector<PairedParameter>& parameters) {
  const std::map<std::string, double> truth = TruthOf(pair);
  ReportJson items = ReportJson::array(), blocks = ReportJson::array();
  for (const PairedParameter& parameter : parameters)
    items.push_back(ParameterItem(parameter, truth));
  if (!items.empty())
    blocks.push_back({{"kind", "interval_pairs"},
                      {"names", {pair.first.name, pair.second.name}},
                      {"items", items}});
  ReportJson section = SectionOf("parameters", "Parameters", blocks);
  section["lead"] =
      "The value and 95 % interval of each on one axis, on the parameter's own scale. The joint "
      "interval is that of the difference of two independent estimates; beyond 1 of it the two "
      "disagree. Two fits of one recording share its noise, so that less than 1 says little. It "
      "holds no physics that a model lacks.";
  return section;
}

ReportJson PairSettingSection(const RunPair& pair) {
  ReportJson rows = ReportJson::array(), blocks = ReportJson::array();
  for (const ConfigDifference& difference : DifferentSettings(pair))
    rows.push_back({difference.key, difference.value, difference.other, difference.doc});
  if (!pair.is_one_recording) blocks.push_back(FactsOfRecordings(pair));
  if (rows.empty()) {
    blocks.push_back(TextBlock({"All settings are the same."}));
  } else {
    blocks.push_back({{"kind", "table"},
                      {"title", "Settings that differ"},
                      {"columns",
                       {{{"title", "setting"}, {"code", true}},
                        PairColumn(pair.first.name, false),
                        PairColumn(pair.second.name, false),
                        {{"title", "meaning"}, {"wide", true}}}},
                      {"rows", rows}});
  }
  return SectionOf("settings", "What was set differently", blocks, "Settings");
}

}  // namespace clothfit
