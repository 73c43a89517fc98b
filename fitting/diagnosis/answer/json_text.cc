// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/json_text.h"

#include <nlohmann/json.hpp>

#include "fitting/diagnosis/answer/effect_words.h"
#include "fitting/diagnosis/answer/headline.h"
#include "fitting/files/version.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson AsJson(const EffectParameter& p) {
  return {{"name", p.name},
          {"unit", p.unit},
          {"value", OrNull(p.value)},
          {"interval90", {OrNull(p.lower90), OrNull(p.upper90)}}};
}

OrderedJson AsJson(const std::vector<EffectParameter>& parameters) {
  OrderedJson json = OrderedJson::array();
  for (const EffectParameter& p : parameters) json.push_back(AsJson(p));
  return json;
}

OrderedJson AsJson(const Candidate& c) {
  return {{"name", c.name},
          {"kind", c.kind == CandidateKind::kPhysics ? "physics" : "observation"},
          {"parameters", AsJson(c.parameters)},
          {"score", OrNull(c.score)},
          {"score_without_projection", OrNull(c.raw_score)},
          {"share", OrNull(c.share)},
          {"p_value", OrNull(c.p_value)},
          {"false_discovery_rate", OrNull(c.q_value)},
          {"detection_limit", OrNull(c.detection_limit)},
          {"short_listed", c.is_short_listed},
          {"why_not", c.why_not}};
}

OrderedJson AsJson(const Model& m) {
  return {{"effects", m.effects},
          {"parameters", AsJson(m.parameters)},
          {"cost", OrNull(m.cost)},
          {"explained", OrNull(m.explained)},
          {"log_evidence", OrNull(m.log_evidence)},
          {"held_out",
           {{"before", OrNull(m.validation.before)},
            {"after", OrNull(m.validation.after)},
            {"improvement_lower95", OrNull(m.validation.improvement_lower95)},
            {"noise", OrNull(m.validation.noise)},
            {"floor", OrNull(m.validation.irreducible)},
            {"unit", m.validation.is_in_pixels ? "px" : "m"},
            {"against_others", m.validation.is_against_others},
            {"proven", m.validation.is_validated}}},
          {"kept", m.is_kept}};
}

OrderedJson AsJson(const Discrepancy& m) {
  return {{"significant", m.is_significant},
          {"p_value", OrNull(m.p_value)},
          {"frames", {m.first_frame, m.last_frame}},
          {"low_uv_m", {m.low_uv.x(), m.low_uv.y()}},
          {"high_uv_m", {m.high_uv.x(), m.high_uv.y()}},
          {"direction", {m.direction.x(), m.direction.y(), m.direction.z()}},
          {"peak_N_per_m2", OrNull(m.peak)},
          {"peak_sigma_N_per_m2", OrNull(m.peak_sigma)},
          {"even_N_per_m2", OrNull(m.even)},
          {"even_sigma_N_per_m2", OrNull(m.even_sigma)},
          {"words", m.words}};
}

OrderedJson AsJson(const ActingForce& a, const ActingClass& c) {
  return {{"frames", {a.first_frame, a.last_frame}},
          {"low_uv_m", {a.low_uv.x(), a.low_uv.y()}},
          {"high_uv_m", {a.high_uv.x(), a.high_uv.y()}},
          {"peak_rms_N_per_m2", OrNull(a.peak)},
          {"mean_direction", {a.mean_direction.x(), a.mean_direction.y(), a.mean_direction.z()}},
          {"net_force_share", OrNull(a.net_force_share)},
          {"net_moment_share", OrNull(a.net_moment_share)},
          {"work_in_J", OrNull(a.work_in)},
          {"work_out_J", OrNull(a.work_out)},
          {"internal", c.is_internal},
          {"dissipative", c.is_dissipative},
          {"driving", c.is_driving},
          {"words", c.words}};
}

OrderedJson AsJson(const DiscrepancyClass& c) {
  return {{"from_outside", c.is_from_outside},
          {"dissipative", c.is_dissipative},
          {"driving", c.is_driving},
          {"net_force_sigmas", OrNull(c.net_force_sigmas)},
          {"net_moment_sigmas", OrNull(c.net_moment_sigmas)},
          {"power_W", OrNull(c.power)},
          {"power_sigma_W", OrNull(c.power_sigma)},
          {"tied_to", c.tied_to},
          {"words", c.words}};
}

}  // namespace

std::string DiagnosisAsJson(const Diagnosis& diagnosis) {
  OrderedJson json;
  json["format"] = "clothfit-diagnosis/1";
  json["clothfit"] = Version();
  json["verdict"] = ToString(diagnosis.verdict);
  json["headline"] = HeadlineOf(diagnosis);
  json["words"] = diagnosis.words;
  json["gate"] = {{"residual_rms_sigmas", OrNull(diagnosis.residual_rms)},
                  {"floor_rms_sigmas", OrNull(diagnosis.discretisation_rms)},
                  {"p_value", OrNull(diagnosis.gate_p_value)},
                  {"left_rms_sigmas", OrNull(diagnosis.left_rms)},
                  {"null_left_rms_sigmas", diagnosis.null_left_rms},
                  {"promised_decrease", OrNull(diagnosis.promised)}};
  if (const std::optional<Misfit>& misfit = diagnosis.misfit) {
    json["gate"]["chi_square"] = OrNull(misfit->chi_square);
    json["gate"]["chi_square_limit"] = OrNull(misfit->limit);
    json["gate"]["correlation"] = OrNull(misfit->correlation);
  }
  const std::optional<Splits::FrameRange>& held_out = diagnosis.motions.held_out;
  json["held_out_frames"] =
      held_out ? OrderedJson({held_out->first, held_out->last}) : OrderedJson(nullptr);
  json["resolution"] = diagnosis.motions.resolution;
  json["mismatch"] = diagnosis.discrepancy ? AsJson(*diagnosis.discrepancy) : OrderedJson(nullptr);
  json["acting"] = diagnosis.acting_class ? AsJson(*diagnosis.acting, *diagnosis.acting_class)
                                          : OrderedJson(nullptr);
  json["class"] =
      diagnosis.discrepancy_class ? AsJson(*diagnosis.discrepancy_class) : OrderedJson(nullptr);
  json["effects"] = diagnosis.effects;
  json["effects_in_words"] = PlainNames(diagnosis.effects);
  json["ambiguity"] = diagnosis.confidence_set;
  json["ambiguity_beside"] = diagnosis.sets_beside;
  json["separating_motion"] = nullptr;
  if (diagnosis.separating) {
    json["separating_motion"] = {{"motion", diagnosis.separating->motion},
                                 {"apart_m", diagnosis.separating->apart},
                                 {"apart_here_m", diagnosis.separating->apart_here}};
  }
  json["answer"] = diagnosis.answer ? AsJson(*diagnosis.answer) : OrderedJson(nullptr);
  json["law"] = nullptr;
  if (diagnosis.law)
    json["law"] = {{"formula", diagnosis.law->formula}, {"model", AsJson(diagnosis.law->model)}};
  json["ranking"] = OrderedJson::array();
  for (const Candidate& c : diagnosis.ranking) json["ranking"].push_back(AsJson(c));
  json["models"] = OrderedJson::array();
  for (const Model& m : diagnosis.models) json["models"].push_back(AsJson(m));
  json["seconds"] = OrderedJson::object();
  for (const auto& [stage, seconds] : diagnosis.seconds) {
    const double before = json["seconds"].value(stage, 0.0);
    json["seconds"][stage] = before + seconds;
  }
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace clothfit
