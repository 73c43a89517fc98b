// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "autodiff_sim/base/names.h"

namespace clothfit {
namespace {

constexpr int kOnWay = 3;  // frames; an effect that acts before this was there from the start

bool Mentions(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

// For tables, whatever the diagnosis itself calls it in words.
std::string VerdictWord(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNothingMissing:
      return "nothing-missing";
    case Verdict::kNamed:
      return "named";
    case Verdict::kObservationFault:
      return "observation-fault";
    case Verdict::kNoneOfTheAbove:
      return "none-of-the-above";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kInterrupted:
      break;
  }
  return "interrupted";
}

const Candidate* FindCandidate(const Diagnosis& diagnosis, const std::string& name) {
  for (const Candidate& candidate : diagnosis.ranking) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

// The parameters that make up one amount: three of a vector, else one.
std::vector<const Parameter*> FirstAmount(const TermInfo& term) {
  std::vector<const Parameter*> amount;
  for (const Parameter& parameter : term.parameters) {
    const bool begins = amount.empty() && SwitchesOff(parameter);
    const bool goes_on =
        !amount.empty() && amount.size() < 3 && amount.front()->meaning == Meaning::kVectorX &&
        (parameter.meaning == Meaning::kVectorY || parameter.meaning == Meaning::kVectorZ);
    if (begins || goes_on) amount.push_back(&parameter);
  }
  return amount;
}

double ValueOr(const std::map<std::string, double>& values, const std::string& name, double other) {
  const auto found = values.find(name);
  return found == values.end() ? other : found->second;
}

// How far the first amount is from off, in its unit.
double AmountOf(const std::string& name, const TrialTruth& truth) {
  double square = 0.0;
  for (const Parameter* p : FirstAmount(TermOf(name)))
    square += std::pow(ValueOr(truth.parameters, name + "." + p->name, p->off) - p->off, 2);
  return std::sqrt(square);
}

// The largest amount may be the second, as of hem: the diagnosis' limit counts for the first.
std::optional<double> OverLimit(const std::string& effect, const TrialTruth& truth,
                                const Diagnosis& diagnosis) {
  const Candidate* candidate = FindCandidate(diagnosis, effect);
  if (candidate == nullptr || !(candidate->detection_limit > 0.0)) return std::nullopt;
  const double amount = AmountOf(effect, truth);
  if (amount > 0.0) return amount / candidate->detection_limit;
  double most = 0.0;
  for (const Parameter& p : TermOf(effect).parameters) {
    if (!SwitchesOff(p)) continue;
    const double value = ValueOr(truth.parameters, effect + "." + p.name, p.off);
    most = std::max(most, std::abs(value - p.off));
  }
  return most / candidate->detection_limit;
}

// Relative error of everything that switches the effect: of vectors by their lengths, of others one
// by one but for those that are truly off, which are measured by the largest of the term.
std::optional<double> AmountError(const std::string& effect, const TrialTruth& truth,
                                  const std::map<std::string, double>& found) {
  double error2 = 0.0, size2 = 0.0;
  bool is_told = false;
  for (const Parameter& p : TermOf(effect).parameters) {
    if (!SwitchesOff(p)) continue;
    const std::string name = effect + "." + p.name;
    is_told = is_told || found.count(name) > 0;
    const double value = ValueOr(truth.parameters, name, p.off);
    error2 += std::pow(ValueOr(found, name, p.off) - value, 2);
    size2 += std::pow(value - p.off, 2);
  }
  if (!is_told || !(size2 > 0.0)) return std::nullopt;
  return std::sqrt(error2 / size2);
}

void ScoreParameters(const TrialTruth& truth, const Model& answer, TrialScore* score) {
  std::map<std::string, double> found;
  for (const EffectParameter& parameter : answer.parameters)
    found[parameter.name] = parameter.value;
  for (const std::string& effect : truth.effects) {
    if (!IsListed(effect) || !IsAmong(answer.effects, effect)) continue;
    const std::optional<double> error = AmountError(effect, truth, found);
    if (error) score->parameter_error = std::max(score->parameter_error.value_or(0.0), *error);
  }
  for (const EffectParameter& parameter : answer.parameters) {
    const std::string term = parameter.name.substr(0, parameter.name.find('.'));
    if (!IsAmong(truth.effects, term) || !(parameter.lower90 < parameter.upper90)) continue;
    double value = 0.0;
    for (const Parameter& p : TermOf(term).parameters) {
      if (term + "." + p.name == parameter.name)
        value = ValueOr(truth.parameters, parameter.name, p.initial);
    }
    ++score->intervals;
    if (value >= parameter.lower90 && value <= parameter.upper90) ++score->covered;
  }
}

void ScoreDiscrepancy(const TrialTruth& truth, const Diagnosis& diagnosis, TrialScore* score) {
  if (!truth.force.acts) return;
  const auto compare = [&](const auto& found) {
    score->region_overlap =
        BoxOverlap(truth.force.low_uv, truth.force.high_uv, found.low_uv, found.high_uv);
    if (truth.force.first_frame >= kOnWay)
      score->onset_error = found.first_frame - truth.force.first_frame;
  };
  // What is named says itself where it acts.
  if (diagnosis.acting_class) {
    compare(*diagnosis.acting);
  } else if (diagnosis.discrepancy && diagnosis.discrepancy->is_significant) {
    compare(*diagnosis.discrepancy);
  }
}

void ScoreClass(const TrialTruth& truth, const Diagnosis& diagnosis, TrialScore* score) {
  if (truth.effects.empty()) return;
  const EffectClass& right = truth.effect_class;
  if (diagnosis.acting_class) {
    const ActingClass& acting = *diagnosis.acting_class;
    score->class_right = acting.is_internal == right.is_internal &&
                         !(right.is_dissipative && acting.is_driving) &&
                         !(right.is_driving && acting.is_dissipative);
    return;
  }
  if (!diagnosis.discrepancy_class) return;
  const DiscrepancyClass& found = *diagnosis.discrepancy_class;
  // What is neither dissipative nor driving may look like either for a while, as it stores energy.
  const bool contradicts =
      (right.is_dissipative && found.is_driving) || (right.is_driving && found.is_dissipative);
  if (found.is_from_outside) score->class_right = !right.is_internal && !contradicts;
  if (!found.tied_to.empty() && !right.tied_to.empty())
    score->tie_right = IsAmong(right.tied_to, found.tied_to);
}

bool NamesPhysics(const Diagnosis& diagnosis) {
  return std::any_of(diagnosis.effects.begin(), diagnosis.effects.end(), IsListed);
}

// None of the three alternatives to it is an alarm about physics.
bool AlarmsPhysics(const Diagnosis& diagnosis) {
  return NamesPhysics(diagnosis) || diagnosis.verdict == Verdict::kNamed ||
         diagnosis.verdict == Verdict::kNoneOfTheAbove;
}

void ScoreFault(const Trial& trial, const Diagnosis& diagnosis, TrialScore* score) {
  score->false_alarm = AlarmsPhysics(diagnosis);
  score->fault_named =
      diagnosis.verdict == Verdict::kObservationFault &&
      std::any_of(diagnosis.effects.begin(), diagnosis.effects.end(),
                  [&](const std::string& name) { return IsNameOfFault(name, *trial.fault); });
}

void ScoreNames(const Trial& trial, const TrialTruth& truth, const Diagnosis& diagnosis,
                TrialScore* score) {
  const std::string& first = truth.effects.front();
  const std::vector<std::string>& named = diagnosis.effects;
  // The first of a pair is whichever the diagnosis likes.
  const auto is_true = [&](const std::string& name) { return IsAmong(truth.effects, name); };
  score->named_first = !named.empty() && is_true(named.front());
  score->top_right = !diagnosis.ranking.empty() && is_true(diagnosis.ranking.front().name);
  score->in_ambiguity =
      std::any_of(diagnosis.confidence_set.begin(), diagnosis.confidence_set.end(), is_true) ||
      *score->named_first;
  if (!named.empty()) {
    const std::set<std::string> set(diagnosis.confidence_set.begin(),
                                    diagnosis.confidence_set.end());
    score->ambiguity_size = std::max(1, static_cast<int>(set.size()));
  }
  score->over_limit = OverLimit(first, truth, diagnosis);
  if (trial.kind != TrialKind::kPair) return;
  score->both_named = std::all_of(truth.effects.begin(), truth.effects.end(),
                                  [&](const std::string& name) { return IsAmong(named, name); });
  for (const std::string& effect : truth.effects) {
    const std::optional<double> over = OverLimit(effect, truth, diagnosis);
    if (over) score->over_limit = std::min(score->over_limit.value_or(*over), *over);
  }
}

void ScoreHeldOut(const Diagnosis& diagnosis, const std::optional<double>& held_out_true,
                  TrialScore* score) {
  const std::optional<double> marker = diagnosis.baseline_fit.after.held_out_marker_rms;
  score->held_out_before = marker ? marker : diagnosis.baseline_fit.after.held_out_track_rms;
  score->held_out_true = held_out_true;
  const bool is_px = diagnosis.answer && diagnosis.answer->validation.is_in_pixels;
  if (is_px && marker)
    return;  // validated by one camera's tracks, which is no gap of the prediction
  if (diagnosis.answer) {
    score->held_out_before = diagnosis.answer->validation.before;
    score->held_out_after = diagnosis.answer->validation.after;
  } else {
    score->held_out_after = score->held_out_before;  // nothing was changed
  }
  if (!score->held_out_before || !held_out_true) return;
  const double gap = *score->held_out_before - *held_out_true;
  if (gap > 0.0) score->gap_closed = (*score->held_out_before - *score->held_out_after) / gap;
}

}  // namespace

double BoxOverlap(const Eigen::Vector2d& low_a, const Eigen::Vector2d& high_a,
                  const Eigen::Vector2d& low_b, const Eigen::Vector2d& high_b) {
  const auto area = [](const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    return (high - low).cwiseMax(0.0).prod();
  };
  const double common = area(low_a.cwiseMax(low_b), high_a.cwiseMin(high_b));
  const double either = area(low_a, high_a) + area(low_b, high_b) - common;
  return either > 0.0 ? common / either : 0.0;
}

bool IsNameOfFault(const std::string& name, const PlantedFault& fault) {
  const auto is_camera = [&] {
    return Mentions(name, fmt::format("camera {}:", fault.camera)) ||
           Mentions(name, fmt::format("camera cam{}:", fault.camera));
  };
  switch (fault.kind) {
    case FaultKind::kCameraPose:
      return is_camera() && Mentions(name, "pose");
    case FaultKind::kCameraClock:
      return Mentions(name, "clock") && (is_camera() || !Mentions(name, "camera"));
    case FaultKind::kCameraScale:
      return is_camera() && (Mentions(name, "scale") || Mentions(name, "focal"));
    case FaultKind::kMarkerShift:
    case FaultKind::kMarkerSwap:
      break;
  }
  return Mentions(name, "marker");
}

TrialScore ScoreDiagnosis(const Trial& trial, const TrialTruth& truth, const Diagnosis& diagnosis,
                          const std::optional<double>& held_out_true) {
  TrialScore score;
  score.name = trial.name;
  score.kind = ToString(trial.kind);
  score.motion = ToString(trial.recording.scenario);
  score.observation = ToString(trial.observation);
  score.size = trial.effects.empty() ? "" : ToString(trial.effects.front().size);
  score.truth = !truth.effects.empty() ? JoinNames(truth.effects, " + ")
                : truth.fault.empty()  ? "none"
                                       : truth.fault;
  score.status = TrialStatus::kDone;
  score.verdict = VerdictWord(diagnosis.verdict);
  score.named = JoinNames(diagnosis.effects, " + ");
  score.num_named = static_cast<int>(diagnosis.effects.size());
  if (!diagnosis.ranking.empty()) score.top = diagnosis.ranking.front().name;
  switch (trial.kind) {
    case TrialKind::kClean:
      score.false_alarm =
          diagnosis.verdict != Verdict::kNothingMissing && diagnosis.verdict != Verdict::kUndecided;
      return score;
    case TrialKind::kFault:
      ScoreFault(trial, diagnosis, &score);
      return score;
    case TrialKind::kUnlisted:
      score.flagged = diagnosis.verdict == Verdict::kNoneOfTheAbove;
      break;
    case TrialKind::kListed:
    case TrialKind::kPair:
      ScoreNames(trial, truth, diagnosis, &score);
      if (diagnosis.answer) ScoreParameters(truth, *diagnosis.answer, &score);
      break;
  }
  ScoreDiscrepancy(truth, diagnosis, &score);
  ScoreClass(truth, diagnosis, &score);
  ScoreHeldOut(diagnosis, held_out_true, &score);
  return score;
}

}  // namespace clothfit
