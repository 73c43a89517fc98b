// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/summary_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fitting/diagnosis/answer/effect_words.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/files/version.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson OrNull(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

// "9.1 mm" or "1.3 px".
std::string Length(double value, bool is_px) {
  return is_px ? fmt::format("{:.3g} px", value) : fmt::format("{:.3g} mm", 1000.0 * value);
}

std::string NameEffects(const Diagnosis& diagnosis) {
  const Model& answer = *diagnosis.answer;
  const bool is_none = diagnosis.verdict == Verdict::kNoneOfTheAbove;
  std::string words = is_none ? "None of the effects that clothfit knows; what comes nearest: "
                              : "What was left out: ";
  words += PlainNames(diagnosis.effects) + ".";
  const std::string amounts = AmountsInWords(diagnosis.effects, answer.parameters);
  if (!amounts.empty()) words += " " + amounts;
  return words + fmt::format(
                     " It explains {:.0f} % of what the baseline cannot; the natural "
                     "logarithm of the odds for it is {:.3g}.",
                     100.0 * answer.explained, answer.log_evidence);
}

std::string SayValidation(const Model& answer) {
  const HeldOutValidation& validation = answer.validation;
  const bool is_px = validation.is_in_pixels;
  std::string words = "With it, the error on the held-out frames";
  if (validation.is_against_others)
    words = "With it put right, how far it is on the held-out frames from what all else saw";
  words +=
      fmt::format(" {} from {} to {}", validation.after < validation.before ? "falls" : "rises",
                  Length(validation.before, is_px), Length(validation.after, is_px));
  words +=
      validation.noise > 0.0 ? fmt::format("; noise is {}.", Length(validation.noise, is_px)) : ".";
  const double by_mesh =
      validation.irreducible * validation.irreducible - validation.noise * validation.noise;
  const double squared = validation.before * validation.before;
  constexpr double kWorthSaying = 0.05;
  if (by_mesh > kWorthSaying * squared) {
    words += fmt::format(" Mesh and step alone might make it fall to {}.",
                         Length(std::sqrt(std::max(0.0, squared - by_mesh)), is_px));
  }
  return words;
}

// Of the models that were fitted, by the effect that each adds.
std::string AmountsOfOthers(const Diagnosis& diagnosis, const std::vector<std::string>& others) {
  std::string words;
  for (const std::string& other : others) {
    const auto model = std::find_if(
        diagnosis.models.begin(), diagnosis.models.end(),
        [&](const Model& one) { return !one.effects.empty() && one.effects.back() == other; });
    if (model == diagnosis.models.end()) continue;
    const std::string amounts = AmountsInWords({other}, model->parameters);
    if (!amounts.empty()) words += " " + amounts;
  }
  return words;
}

std::string SayConfidenceSet(const Diagnosis& diagnosis) {
  if (diagnosis.confidence_set.size() < 2) return "";
  const std::vector<std::string> others(diagnosis.confidence_set.begin() + 1,
                                        diagnosis.confidence_set.end());
  std::string words = "This recording cannot tell it from " + PlainNames(others) + "." +
                      AmountsOfOthers(diagnosis, others);
  if (diagnosis.separating) words += " " + Describe(*diagnosis.separating);
  return words;
}

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

std::string DescribeDiagnosis(const Diagnosis& diagnosis) {
  std::vector<std::string> sentences;
  if (diagnosis.verdict == Verdict::kInterrupted) sentences.push_back("Interrupted; so far:");
  if (diagnosis.verdict == Verdict::kNothingMissing) {
    sentences.push_back(fmt::format(
        "Nothing is missing that this recording could show: the baseline leaves {:.3g} sigmas, "
        "where noise alone leaves 1.",
        diagnosis.residual_rms));
  }
  if (diagnosis.verdict == Verdict::kUndecided) {
    sentences.push_back(fmt::format(
        "Undecided: the baseline leaves {:.2g} sigmas, but its fit has come to no minimum, as a "
        "full "
        "step still promises {:.0f} % less. What it leaves is no evidence of "
        "missing physics, nor that nothing is missing. A shorter or gentler recording, or material "
        "parameters that are known, would help.",
        diagnosis.residual_rms, 100.0 * diagnosis.promised));
  }
  // What is named says itself where it acts; the map of what the baseline cannot take for anything
  // else is for what has no name.
  const bool has_map = diagnosis.discrepancy && diagnosis.discrepancy->is_significant;
  if (has_map && !diagnosis.acting_class) {
    sentences.push_back(diagnosis.discrepancy->words);
    if (diagnosis.discrepancy_class) sentences.push_back(diagnosis.discrepancy_class->words);
  }
  if (diagnosis.law) {
    const Model& model = diagnosis.law->model;
    if (!diagnosis.effects.empty())
      sentences.push_back("Put right in the observation: " + JoinNames(diagnosis.effects) + ".");
    sentences.push_back(fmt::format(
        "Something is missing that no effect of the catalogue explains. A law learned from it "
        "explains {:.0f} %: {}.",
        100.0 * model.explained, diagnosis.law->formula));
    if (diagnosis.acting_class) sentences.push_back(diagnosis.acting_class->words);
    sentences.push_back(SayValidation(model));
  } else if (diagnosis.answer) {
    sentences.push_back(NameEffects(diagnosis));
    if (diagnosis.acting_class) sentences.push_back(diagnosis.acting_class->words);
    sentences.push_back(SayConfidenceSet(diagnosis));
    sentences.push_back(SayValidation(*diagnosis.answer));
  } else if (!diagnosis.effects.empty()) {
    sentences.push_back("Put right in the observation: " + JoinNames(diagnosis.effects) + ".");
  }
  if (diagnosis.verdict == Verdict::kObservationFault)
    sentences.push_back("That is a fault of the observation, not of the physics.");
  if (diagnosis.verdict == Verdict::kNoneOfTheAbove && !diagnosis.law) {
    sentences.push_back(
        diagnosis.answer ? "No effect in the catalogue explains all of what is missing: what comes "
                           "nearest may only stand for it."
                         : "Something is missing, and the recording speaks for no effect in "
                           "the catalogue.");
  }
  if (diagnosis.verdict == Verdict::kInterrupted && diagnosis.answer)
    sentences.push_back("The search was stopped: amounts may still change, and have no intervals.");
  std::string words;
  for (const std::string& sentence : sentences) {
    if (!sentence.empty()) words += (words.empty() ? "" : " ") + sentence;
  }
  return words;
}

std::string DiagnosisAsMarkdown(const Diagnosis& diagnosis) {
  std::string text = fmt::format("# {}\n\n{}\n", ToString(diagnosis.verdict), diagnosis.words);
  text +=
      "\n## Candidates\n\n| | explains | score | without projection | p | false discovery | "
      "detection limit | |\n|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Candidate& c : diagnosis.ranking) {
    text += fmt::format("| {} | {:.0f} % | {:.4g} | {:.4g} | {:.2g} | {:.2g} | {:.2g} {} | {} |\n",
                        c.name, 100.0 * c.share, c.score, c.raw_score, c.p_value, c.q_value,
                        c.detection_limit, c.parameters.empty() ? "" : c.parameters[0].unit,
                        c.is_short_listed ? "short-listed" : c.why_not);
  }
  text +=
      "\n## Models\n\n| effects | cost | explains | log evidence | held out before | after | "
      "improvement, at least | |\n|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Model& m : diagnosis.models) {
    text += fmt::format("| {} | {:.6g} | {:.0f} % | {:.4g} | {:.4g} | {:.4g} | {:.3g} | {} |\n",
                        JoinNames(m.effects), m.cost, 100.0 * m.explained, m.log_evidence,
                        m.validation.before, m.validation.after, m.validation.improvement_lower95,
                        m.is_kept ? "kept" : "");
  }
  text += "\n## Time\n\n";
  for (const auto& [stage, seconds] : diagnosis.seconds)
    text += fmt::format("- {}: {:.1f} s\n", stage, seconds);
  return text;
}

std::string DiagnosisAsJson(const Diagnosis& diagnosis) {
  OrderedJson json;
  json["format"] = "clothfit-diagnosis/1";
  json["clothfit"] = Version();
  json["verdict"] = ToString(diagnosis.verdict);
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
