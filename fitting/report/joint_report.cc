// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of a fit of several recordings: what they share, how each is met, where its page is.
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/report/kinds.h"
#include "fitting/report/records/run_record.h"
#include "fitting/report/scene_page.h"
#include "fitting/report/sections/sections.h"
#include "fitting/report/verdict/facts.h"
#include "fitting/report/verdict/joint_verdict.h"
#include "fitting/runs/recording_list.h"
#include "tracking/recording/surface/truth.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// A path as part of an address.
std::string AsAddress(const fs::path& path) {
  std::string address;
  for (const char c : path.generic_string()) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string("/-_.~").find(c) != std::string::npos;
    address += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return address;
}

// The recording's name, leading to its page from where this one will stand.
ReportJson LinkTo(const fs::path& folder, const ReportJson& entry, const fs::path& page) {
  const fs::path of_recording =
      fs::absolute(folder / entry.at("run").get<std::string>() / "report.html").lexically_normal();
  const fs::path from = fs::absolute(page.empty() ? folder / "report.html" : page);
  return {
      {"text", entry.at("name")},
      {"href",
       "./" + AsAddress(of_recording.lexically_relative(from.lexically_normal().parent_path()))}};
}

ReportJson Cell(const std::optional<double>& value, const std::string& unit) {
  return value ? ReportJson(QuantityInWords(*value, unit)) : ReportJson();
}

// A row a recording and kind of observation.
ReportJson RecordingSection(const fs::path& folder, const ReportJson& summary,
                            const fs::path& page) {
  ReportJson rows = ReportJson::array();
  for (const ReportJson& entry : summary.at("recordings")) {
    const bool is_held_out = entry.at("held_out_whole").get<bool>();
    const std::optional<Misfit> misfit = MisfitOf(entry);
    for (const char* kind : {"markers", "tracks", "silhouettes"}) {
      std::optional<ErrorChange> fitted, held_out;
      for (const ErrorChange& error : ErrorsOf(entry))
        if (error.kind == kind) (error.held_out ? held_out : fitted) = error;
      const std::optional<ErrorChange>& main = is_held_out ? held_out : fitted;
      if (!main) continue;
      rows.push_back({LinkTo(folder, entry, page), is_held_out ? "no, predicted" : "yes", kind,
                      Cell(main->before, main->unit),
                      fitted ? Cell(fitted->after, fitted->unit) : ReportJson(),
                      held_out ? Cell(held_out->after, held_out->unit) : ReportJson(),
                      Cell(NoiseOf(entry, kind), main->unit),
                      misfit ? ReportJson(misfit->chi_square) : ReportJson()});
    }
  }
  ReportJson columns = ReportJson::array();
  for (const char* title : {"recording", "fitted", "what was seen", "error at the start",
                            "fitted frames", "held-out frames", "noise", "chi-square"})
    columns.push_back({{"title", title}});
  columns.back()["number"] = true;
  ReportJson blocks = {{{"kind", "table"}, {"columns", columns}, {"rows", rows}}};
  ReportJson section = SectionOf("recordings", "Recordings", blocks);
  section["lead"] =
      "Root mean square distances, from frame 0 on driven by the handles alone; of outlines the "
      "area that differs. The name leads to the recording's own page. Of chi-square 1 is expected "
      "of noise.";
  return section;
}

// Physical parameters that each recording has of its own.
ReportJson OwnParameters(const ReportJson& summary) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  ReportJson rows = ReportJson::array();
  for (const auto& [name, estimate] : summary.at("parameters").items()) {
    const std::size_t slash = name.rfind('/');
    if (slash == std::string::npos || FindParameter(table, name.substr(slash + 1)) < 0) continue;
    const ReportJson& ends = estimate.at("interval");
    rows.push_back({name.substr(0, slash), name.substr(slash + 1), estimate.at("value"), ends.at(0),
                    ends.at(1), estimate.at("unit")});
  }
  ReportJson blocks = ReportJson::array();
  if (!rows.empty()) {
    blocks.push_back({{"kind", "table"},
                      {"columns",
                       {{{"title", "recording"}},
                        {{"title", "parameter"}, {"code", true}},
                        {{"title", "value"}, {"number", true}},
                        {{"title", "from"}, {"number", true}},
                        {{"title", "to"}, {"number", true}},
                        {{"title", "unit"}}}},
                      {"rows", rows}});
  }
  return SectionOf("own", "Of each recording", blocks, "Own");
}

ReportJson RecordSection(const fs::path& folder) {
  ReportJson blocks = ReportJson::array();
  for (const char* name : {"recordings.yaml", "log.txt"}) {
    if (fs::exists(folder / name))
      blocks.push_back({{"kind", "code"},
                        {"title", name},
                        {"folded", true},
                        {"text", ReadTextFile(folder / name)}});
  }
  return SectionOf("configuration", "What was done", blocks);
}

}  // namespace

ReportPage MakeJointReport(const fs::path& folder, const ReportAssets& assets,
                           const ReportOptions& options) {
  const ReportJson summary = ReadJointSummary(folder);
  FitConfig config = DefaultConfig({});
  std::map<std::string, double> truth;
  for (const ListedRecording& one : ReadRecordingList(folder)) {
    if (one.is_held_out) continue;
    ReadConfig(folder / RunFolder::PlaceOf(one.name) / "config.yaml", &config);
    if (HasTruthParameters(one.path)) truth = ReadTruthParameters(one.path);
    break;  // what is shared is the same in all
  }
  ReportJson parameters = ParameterSection(summary, config, truth);
  parameters["title"] = "Shared parameters";
  ReportJson sections = ReportJson::array();
  for (ReportJson& section : std::vector<ReportJson>{
           RecordingSection(folder, summary, options.page), std::move(parameters),
           OwnParameters(summary), RecordSection(folder)})
    if (!section.at("blocks").empty()) sections.push_back(std::move(section));
  ReportJson json;
  json["title"] = fmt::format("{} recordings of one cloth", summary.at("recordings").size());
  json["sections"] = std::move(sections);
  return AsReportPage(std::move(json), JudgeJointFit(summary), {}, assets);
}

}  // namespace clothfit
