// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/diagnosis/sections.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/titles.h"
#include "fitting/report/verdict/page_verdict.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr std::size_t kMostBars = 12;  // of candidates; the table has all
constexpr std::size_t kBins = 24;      // of the null's draws

// Why a candidate stands where it does.
std::string Standing(const DiagnosisRecord& record, const ReportJson& candidate) {
  const std::string name = candidate.at("name");
  if (IsAmong(record.effects, name)) return "named";
  for (const std::vector<std::string>& set : record.confidence_sets)
    if (IsAmong(set, name)) return "cannot be told from " + TitleOf(set.front());
  if (candidate.at("short_listed") == true) return "short-listed";
  return candidate.at("why_not").get<std::string>();
}

ReportJson RankingBars(const DiagnosisRecord& record, const char* key, const char* title) {
  ReportJson items = ReportJson::array();
  for (const ReportJson& candidate : record.json.at("ranking")) {
    if (items.size() == kMostBars) break;
    const std::string name = candidate.at("name");
    const bool is_set = IsAmong(record.effects, name) ||
                        std::any_of(record.confidence_sets.begin(), record.confidence_sets.end(),
                                    [&](const auto& set) { return IsAmong(set, name); });
    if (!candidate.at(key).is_number()) continue;
    items.push_back({{"name", name},
                     {"value", candidate.at(key)},
                     {"note", ""},
                     {"marked", is_set},
                     {"muted", !is_set && candidate.at("short_listed") != true}});
  }
  return {{"kind", "bars"}, {"title", title}, {"unit", ""}, {"narrow", true}, {"items", items}};
}

ReportJson Column(const char* title, bool is_number = true) {
  return {{"title", title}, {"number", is_number}};
}

ReportJson RankingTable(const DiagnosisRecord& record) {
  ReportJson rows = ReportJson::array();
  for (const ReportJson& c : record.json.at("ranking")) {
    const ReportJson& parameters = c.at("parameters");
    const std::string unit = parameters.empty() ? "" : parameters[0].value("unit", "");
    const ReportJson share =
        c.at("share").is_number() ? ReportJson(100.0 * c.at("share").get<double>()) : ReportJson();
    rows.push_back({c.at("name"), c.at("kind"), share, c.at("score"),
                    c.at("score_without_projection"), c.at("p_value"), c.at("false_discovery_rate"),
                    c.at("detection_limit"), unit == "1" ? "" : unit, Standing(record, c)});
  }
  return {{"kind", "table"},
          {"title", fmt::format("All {} candidates", rows.size())},
          {"folded", true},
          {"columns",
           {{{"title", "candidate"}, {"code", true}},
            Column("kind", false),
            Column("explains, %"),
            Column("score"),
            Column("without projection"),
            Column("p"),
            Column("false discovery"),
            Column("detection limit"),
            Column("unit", false),
            Column("", false)}},
          {"rows", rows}};
}

std::string SayConfidenceSet(const DiagnosisRecord& record) {
  if (record.effects.empty()) return "Nothing is named.";
  std::vector<std::string> apart;
  for (const std::vector<std::string>& set : record.confidence_sets)
    if (set.size() > 1) apart.push_back(JoinNames(TitlesOf(set)));
  if (apart.empty()) {
    return fmt::format("Nothing else does nearly what {} does in this recording.",
                       TitleOf(record.effects.front()));
  }
  return fmt::format("This recording cannot tell these apart: {}.", JoinNames(apart, "; nor "));
}

ReportJson Percent(const ReportJson& share) {
  return share.is_number() ? ReportJson(100.0 * share.get<double>()) : ReportJson();
}

// "frames 13 to 26" where it is those that were predicted, else nothing.
std::string EarlierFrames(const ReportJson& validation) {
  const auto earlier = validation.find("earlier_frames");
  if (earlier == validation.end() || !earlier->is_array()) return "";
  return fmt::format("frames {} to {}", earlier->at(0).get<int>(), earlier->at(1).get<int>());
}

// A bar for each of the held-out errors of the answer, and a table of all models.
ReportJson ValidationBars(const ReportJson& model) {
  const ReportJson& validation = model.at("held_out");
  ReportJson items = ReportJson::array();
  const auto add = [&](const char* name, const char* key, bool is_muted) {
    if (!validation.contains(key) || !validation.at(key).is_number()) return;
    items.push_back(
        {{"name", name}, {"value", validation.at(key)}, {"note", ""}, {"muted", is_muted}});
  };
  add("the fit without it", "before", false);
  add("with it", "after", false);
  add("noise alone", "noise", true);
  const std::string earlier = EarlierFrames(validation);
  const std::string title = earlier.empty()
                                ? "Error on held-out frames"
                                : "Error on " + earlier + ", after fits to those before them alone";
  return {{"kind", "bars"}, {"title", title}, {"unit", "length"}, {"items", items}};
}

// Camera faults are validated in pixels even where there are markers.
bool IsInPixels(const ReportJson& model, bool if_unsaid) {
  return model.at("held_out").value("unit", if_unsaid ? "px" : "m") == "px";
}

ReportJson ModelTable(const ReportJson& models, bool is_px) {
  const double factor = is_px ? 1.0 : 1e3;
  const std::string unit = is_px ? "px" : "mm";
  ReportJson rows = ReportJson::array();
  for (const ReportJson& m : models) {
    const ReportJson& validation = m.at("held_out");
    const bool is_other = IsInPixels(m, is_px) != is_px;
    const auto length = [&](const char* key) {
      return validation.at(key).is_number() && !is_other
                 ? ReportJson(factor * validation.at(key).get<double>())
                 : ReportJson();
    };
    std::string verdict = validation.at("proven") == true ? "validated" : "";
    if (const std::string earlier = EarlierFrames(validation); !earlier.empty())
      verdict += " on " + earlier;
    if (is_other && validation.at("before").is_number() && validation.at("after").is_number()) {
      verdict +=
          fmt::format(" ({:.3g} to {:.3g} px of its camera)", validation.at("before").get<double>(),
                      validation.at("after").get<double>());
    }
    rows.push_back({JoinNames(m.at("effects").get<std::vector<std::string>>()), m.at("cost"),
                    Percent(m.at("explained")), length("before"), length("after"),
                    length("improvement_lower95"), length("floor"), verdict,
                    m.at("kept") == true ? "kept" : ""});
  }
  const auto with_unit = [&](const char* title) {
    return ReportJson{{"title", title}, {"unit", unit}, {"number", true}};
  };
  return {{"kind", "table"},
          {"title", "Every model that was fitted"},
          {"columns",
           {{{"title", "effects"}, {"code", true}},
            Column("cost"),
            Column("explains, %"),
            with_unit("before"),
            with_unit("after"),
            with_unit("better by at least"),
            with_unit("noise, mesh and step"),
            Column("", false),
            Column("", false)}},
          {"rows", rows}};
}

// How often the null's draws left how much, and the recording's own beside them. Nothing where no
// null was drawn.
std::optional<ReportJson> NullDraws(const ReportJson& gate) {
  if (!gate.contains("null_left_rms_sigmas") || !gate.at("left_rms_sigmas").is_number()) return {};
  const auto draws = gate.at("null_left_rms_sigmas").get<std::vector<double>>();
  if (draws.empty()) return {};
  const auto [least, most] = std::minmax_element(draws.begin(), draws.end());
  const double low = *least, width = std::max(*most - low, 1e-6 * std::max(1.0, *most));
  std::vector<double> counts(kBins, 0.0);
  for (const double draw : draws) {
    const double place = (draw - low) / width * kBins;
    counts[std::min<std::size_t>(kBins - 1, static_cast<std::size_t>(place))] += 1.0;
  }
  const double own_place = gate.at("left_rms_sigmas").get<double>();
  const double begin = std::min(low, own_place), end = std::max(low + width, own_place);
  const double margin = 0.03 * (end - begin);
  // Place, and the heights there: of the draws, of the recording.
  std::vector<std::tuple<double, ReportJson, ReportJson>> points;
  points.emplace_back(begin - margin, 0.0, nullptr);
  for (std::size_t k = 0; k < kBins; ++k)
    points.emplace_back(low + width * static_cast<double>(k) / kBins, counts[k], nullptr);
  points.emplace_back(low + width, 0.0, nullptr);
  points.emplace_back(own_place, nullptr, 1.0);
  points.emplace_back(end + margin, 0.0, nullptr);
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
  ReportJson places = ReportJson::array(), of_null = places, own = places;
  for (const auto& [place, height, own_height] : points) {
    places.push_back(place);
    of_null.push_back(height);
    own.push_back(own_height);
  }
  return ReportJson{
      {"kind", "lines"},
      {"title", fmt::format("What the baseline leaves: {} recordings of the null, and this one",
                            draws.size())},
      {"x",
       {{"title", "root mean square"}, {"unit", "sigmas"}, {"log", false}, {"values", places}}},
      {"y", {{"title", "recordings"}, {"unit", ""}, {"log", false}, {"from_zero", true}}},
      {"narrow", false},
      {"series",
       {{{"name", "of the null"}, {"role", "after"}, {"steps", true}, {"values", of_null}},
        {{"name", "this recording"}, {"role", "before"}, {"points", true}, {"values", own}}}}};
}

}  // namespace

ReportJson RankingSection(const DiagnosisRecord& record) {
  ReportJson blocks = ReportJson::array();
  if (!record.json.at("ranking").empty()) {
    blocks.push_back(TextBlock({SayConfidenceSet(record)}));
    blocks.push_back(RankingBars(record, "score", "Score"));
    blocks.push_back(
        RankingBars(record, "score_without_projection", "Score with nothing projected out"));
    blocks.push_back(RankingTable(record));
  }
  ReportJson section = SectionOf("ranking", "What could be missing", blocks, "Ranking");
  section["lead"] =
      "The score is the fall of the sum of squares, in sigmas, that a candidate promises after the "
      "baseline and the observation's own faults took their part; beside it, without that. "
      "Strong bars are named or cannot be told from what is named; pale ones passed no test.";
  return section;
}

ReportJson ClassSection(const DiagnosisRecord& record) {
  ReportJson blocks = ReportJson::array();
  const ReportJson found = record.json.value("class", ReportJson());
  if (!found.is_object()) return SectionOf("class", "Of what class it is", blocks, "Class");
  const auto yes_or = [](const ReportJson& value, const char* no) {
    return value == true ? "yes" : no;
  };
  const std::string tied_to = found.value("tied_to", "");
  ReportJson rows = ReportJson::array();
  rows.push_back(
      {"comes from outside the cloth", yes_or(found.at("from_outside"), "cannot be told")});
  rows.push_back({"takes energy out", yes_or(found.at("dissipative"), "no")});
  rows.push_back({"puts energy in", yes_or(found.at("driving"), "no")});
  rows.push_back({"tied to", tied_to.empty() ? "cannot be told" : tied_to});
  const auto number = [&](const char* key) {
    return found.at(key).is_number() ? fmt::format("{:.3g}", found.at(key).get<double>()) : "–";
  };
  rows.push_back({"net force, sigmas from nothing", number("net_force_sigmas")});
  rows.push_back({"net moment, sigmas from nothing", number("net_moment_sigmas")});
  rows.push_back({"mean power", number("power_W") + " ± " + number("power_sigma_W") + " W"});
  blocks.push_back(TextBlock({found.at("words").get<std::string>()}));
  blocks.push_back(
      {{"kind", "table"}, {"columns", {{{"title", ""}}, {{"title", ""}}}}, {"rows", rows}});
  return SectionOf("class", "Of what class it is", blocks, "Class");
}

ReportJson ValidationSection(const ReportScene& report, const DiagnosisRecord& record) {
  ReportJson blocks = ReportJson::array();
  const ReportJson& models = record.json.at("models");
  const ReportJson answer = record.json.value("answer", ReportJson());
  const bool has_no_markers = report.scene().markers.empty();
  if (answer.is_object()) {
    const bool is_px = IsInPixels(answer, has_no_markers);
    ReportJson bars = ValidationBars(answer);
    bars["unit"] = is_px ? "px" : "mm";
    for (ReportJson& item : bars["items"])
      item["value"] = (is_px ? 1.0 : 1e3) * item["value"].get<double>();
    blocks.push_back(bars);
    const ReportJson& bound = answer.at("held_out").at("improvement_lower95");
    if (bound.is_number()) {
      blocks.push_back(
          TextBlock({fmt::format("By at least {} with a probability of 95 %.",
                                 QuantityInWords(bound.get<double>(), is_px ? "px" : "m"))}));
    }
  }
  if (!models.empty()) blocks.push_back(ModelTable(models, has_no_markers));
  ReportJson section =
      SectionOf("proof", "Validation on frames that no fit has seen", blocks, "Validation");
  section["lead"] =
      "Every model predicts the held-out frames open loop. It is validated where the lower end of "
      "the "
      "95 % interval of its improvement lies above a twentieth of the noise.";
  return section;
}

ReportJson AnswerSection(const ReportScene& report, const DiagnosisRecord& record) {
  ReportJson items = ReportJson::array();
  const ReportJson answer = record.json.value("answer", ReportJson());
  const std::vector<NamedParameter> table = MakeParameterTable();
  constexpr double kUnbounded = 1e300;
  const ReportJson found = answer.is_object() ? answer.at("parameters") : ReportJson::array();
  for (const ReportJson& p : found) {
    const std::string name = p.at("name");
    const int index = FindParameter(table, name);
    const ReportJson& interval = p.at("interval90");
    ReportJson item = {{"name", name},
                       {"doc", index < 0 ? "" : table[index].parameter.doc},
                       {"unit", p.at("unit")},
                       {"scale", "linear"},
                       {"bounds", {-kUnbounded, kUnbounded}},
                       {"start", nullptr},
                       {"value", p.at("value")},
                       {"interval", interval.at(0).is_null() ? ReportJson() : interval},
                       {"truth", nullptr},
                       {"note", ""}};
    if (index >= 0) {
      const ParameterSetting& setting = report.fitted.config.parameters.at(name);
      item["bounds"] = {setting.lower, setting.upper};
      const double off = table[index].parameter.off;
      if (std::isfinite(off)) item["start"] = off;
    }
    items.push_back(item);
  }
  ReportJson blocks = ReportJson::array();
  if (!items.empty()) {
    blocks.push_back({{"kind", "intervals"}, {"start", "off"}, {"items", items}});
  }
  ReportJson section = SectionOf("parameters", "How much of it", blocks, "Parameters");
  section["lead"] =
      record.verdict == "interrupted"
          ? "Parameters of what was found before the diagnosis was stopped, so without intervals; "
            "\"off\" is where the term does nothing."
          : "Parameters of what was found, with 90 % intervals; \"off\" is where the term does "
            "nothing.";
  return section;
}

ReportJson NullSection(const DiagnosisRecord& record) {
  const ReportJson& gate = record.json.at("gate");
  ReportJson sigmas = ReportJson::array(), chances = ReportJson::array();
  const auto add = [&](const char* name, const char* key, bool is_muted) {
    if (!gate.at(key).is_number()) return;
    sigmas.push_back({{"name", name}, {"value", gate.at(key)}, {"note", ""}, {"muted", is_muted}});
  };
  add("the baseline leaves", "residual_rms_sigmas", false);
  add("mesh and time step make", "floor_rms_sigmas", true);
  for (const ReportJson& c : record.json.at("ranking")) {
    if (chances.size() == kMostBars) break;
    if (!c.at("p_value").is_number()) continue;
    const double p = std::max(1e-300, c.at("p_value").get<double>());
    chances.push_back({{"name", c.at("name")},
                       {"value", -std::log10(p)},
                       {"note", fmt::format("p = {:.2g}", p)},
                       {"muted", c.at("short_listed") != true}});
  }
  ReportJson blocks = ReportJson::array();
  if (gate.at("p_value").is_number()) {
    blocks.push_back(TextBlock({fmt::format(
        "A recording of nothing but the baseline would leave as much with a probability of {:.2g}.",
        gate.at("p_value").get<double>())}));
  }
  if (const std::optional<ReportJson> draws = NullDraws(gate)) blocks.push_back(*draws);
  blocks.push_back({{"kind", "bars"},
                    {"title", "Residuals, root mean square"},
                    {"unit", "sigmas"},
                    {"items", sigmas}});
  blocks.push_back({{"kind", "bars"},
                    {"title", "How rarely the null scores as much, powers of ten"},
                    {"unit", ""},
                    {"items", chances}});
  ReportJson section =
      SectionOf("nulls", "Against recordings in which nothing is missing", blocks, "Null");
  section["lead"] =
      "The null is simulated again: noise, what mesh and step leave, and cameras and markers off "
      "as "
      "well-made ones are.";
  return section;
}

ReportJson DiagnosisTimeSection(const DiagnosisRecord& record) {
  ReportJson items = ReportJson::array();
  for (const auto& [stage, seconds] : record.json.at("seconds").items())
    items.push_back({{"name", stage}, {"value", seconds}, {"note", ""}});
  ReportJson blocks = ReportJson::array();
  if (!items.empty()) {
    blocks.push_back({{"kind", "bars"}, {"title", "Seconds"}, {"unit", "s"}, {"items", items}});
  }
  return SectionOf("time", "Where the time went", blocks, "Time");
}

ReportJson DiagnosisFilesSection(const ReportScene& report, const DiagnosisRecord& record) {
  const auto file = [](const char* title, const std::string& text) {
    return ReportJson{{"kind", "code"}, {"title", title}, {"folded", true}, {"text", text}};
  };
  return SectionOf(
      "configuration", "Configuration",
      {TextBlock(
           {fmt::format("Made by clothfit {}. The config holds the model with what was found: "
                        "fit, simulate and predict take it as it is.",
                        record.json.value("clothfit", "")),
            "Recording: " + report.scene().recording.path.string()}),
       file("config.yaml", record.config), file("log.txt", record.log)});
}

}  // namespace clothfit
