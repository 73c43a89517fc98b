// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer of a diagnosis: how certain its parameters are, a law where names explain too little,
// where it acts, and the verdict.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "fitting/diagnosis/answer/parameter_intervals.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "fitting/diagnosis/classify/class_text.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/law/learn.h"
#include "fitting/diagnosis/model/explained_share.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// What is known so far, without the intervals, which are of a search that came to its end.
void AnswerAsInterrupted(Diagnosis* diagnosis) {
  diagnosis->verdict = Verdict::kInterrupted;
  for (Model& model : diagnosis->models) ForgetIntervals(&model.parameters);
  if (diagnosis->answer) ForgetIntervals(&diagnosis->answer->parameters);
  diagnosis->words = DescribeDiagnosis(*diagnosis);
}

}  // namespace

const BothMeshes& Diagnoser::WithoutPhysics() const {
  for (const Kept& kept : kept_)
    if (kept.IsPhysics()) return kept.before;
  return now_;
}

const Ranking& Diagnoser::RankingWithoutPhysics() const {
  for (const Kept& kept : kept_)
    if (kept.IsPhysics()) return kept.ranking;
  return last_ranking_;
}

double Diagnoser::Explained(const BothMeshes& before, const FittedScene& fine) const {
  const double rows = baseline_quality_->scale.rows;
  const double mesh = std::min(baseline_quality_->mesh, quality_ ? quality_->mesh : HUGE_VAL);
  return ShareBeyondMesh(before.Cost(), fine.fit.cost_after, 0.5 * rows, mesh);
}

// What has lost the recorded motion is told of by forecasts.
bool Diagnoser::IsLost() const {
  const FittedScene& fine = now_.fine;
  return HasPhysics() && forecasts_lack_ > 0.0 &&
         HasLargeResidual(fine.scene, fine.config, fine.fit);
}

double Diagnoser::ExplainedByAnswer() const {
  return IsLost() ? std::max(0.0, 1.0 - forecasts_left_ / forecasts_lack_)
                  : Explained(WithoutPhysics(), now_.fine);
}

double Diagnoser::MostOfAnswer() const { return MostOfIt(quality_->Unexplained(), IsLost()); }

double Diagnoser::UnexplainedWithoutPhysics() const {
  return BeyondNoise(2.0 * WithoutPhysics().Cost() / baseline_quality_->scale.rows);
}

void Diagnoser::ForgetPhysics() {
  kept_.erase(
      std::remove_if(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.IsPhysics(); }),
      kept_.end());
  const std::vector<std::string> left = EffectsSoFar();
  for (Model& model : diagnosis_.models) model.is_kept = model.is_kept && model.effects == left;
  diagnosis_.confidence_set.clear();
  diagnosis_.sets_beside.clear();
  diagnosis_.separating.reset();
}

// A name has to explain some of what mesh and step do not make; where less than noise is left
// beyond noise, half of it.
void Diagnoser::TakeBackWhatIsTooLittle() {
  const double left = UnexplainedWithoutPhysics(), explained = ExplainedByAnswer();
  const bool stands = explained >= options_.least_share &&
                      (quality_->is_explained || left >= kTooLittle || explained >= kHalfOfIt);
  if (stands || !HasPhysics()) return;
  Log(
      fmt::format("{} is not kept: without it {:.2g} sigmas are left beyond noise, of which it "
                  "explains {:.0f} %",
                  JoinNames(EffectsSoFar()), left, 100.0 * explained));
  now_ = BothMeshes(WithoutPhysics());
  ForgetPhysics();
  quality_ = AppraiseQuality(now_.fine);
}

void Diagnoser::SetAnswer(const BothMeshes& before) {
  const FittedScene& fine = now_.fine;
  Model answer;
  for (const Model& model : diagnosis_.models)
    if (model.is_kept) answer = model;
  answer.effects = EffectsSoFar();
  answer.config = fine.values;
  answer.cost = now_.Cost();
  answer.explained =
      HasPhysics() ? ExplainedByAnswer() : Explained(kept_.front().before, now_.fine);
  // A fault's own amounts are in no config.
  std::vector<EffectParameter> of_faults;
  for (const Kept& kept : kept_) {
    if (kept.IsPhysics()) continue;
    const std::vector<EffectParameter>& amounts = kept.candidate.summary.parameters;
    of_faults.insert(of_faults.end(), amounts.begin(), amounts.end());
  }
  answer.parameters = EstimatesOf(quality_->result, fine.config, ParametersSoFar());
  answer.parameters.insert(answer.parameters.begin(), of_faults.begin(), of_faults.end());
  answer.validation =
      ValidateOn(now_.fine, before.fine, kept_.back().candidate, kept_.back().ranking);
  answer.is_kept = true;
  // Of the rounds before it, what the answer still has.
  Model* own = nullptr;
  for (Model& model : diagnosis_.models) {
    const std::size_t count = model.effects.size();
    model.is_kept = model.is_kept && count <= answer.effects.size() &&
                    std::equal(model.effects.begin(), model.effects.end(), answer.effects.begin());
    if (model.is_kept && count == answer.effects.size()) own = &model;
  }
  if (own != nullptr) {
    *own = answer;
  } else {
    diagnosis_.models.push_back(answer);
  }
  diagnosis_.answer = std::move(answer);
}

void Diagnoser::LearnInstead() {
  const bool is_open = !IsExplained(last_ranking_) && UnexplainedWithoutPhysics() >= kTooLittle &&
                       ExplainedByAnswer() < MostOfAnswer();
  if (!is_open || Stopped()) return;
  const BothMeshes without = WithoutPhysics();
  Say("learning a law", 0.85);
  const std::optional<LearnedFit> law =
      LearnLaw(without.coarse, baseline_, RankingWithoutPhysics(), options_);
  Spend("learning a law");
  if (!law) return;
  std::optional<BothMeshes> both = meshes_.Refine(law->scene, kModelIterations);
  if (!both) return;
  // Against the names, by as many unknowns as it has more.
  const double unknowns =
      static_cast<double>(law->names.size()) - static_cast<double>(ParametersSoFar().size());
  const FitQuality quality = AppraiseQuality(both->fine);
  const double evidence = LogEvidence(now_.Cost(), both->Cost(), unknowns, quality.scale);
  Law learned;
  learned.formula = LawFormula(*law, last_ranking_.extent);
  learned.model.effects = law->terms;
  learned.model.config = both->fine.values;
  learned.model.cost = both->Cost();
  learned.model.log_evidence = evidence;
  learned.model.explained = Explained(WithoutPhysics(), both->fine);
  learned.model.parameters = EstimatesOf(quality.result, both->fine.config, law->names);
  learned.model.validation = ValidateOn(both->fine, without.fine, {}, last_ranking_);
  learned.model.is_kept = evidence >= kStrongEvidence;
  Log(fmt::format("a law of {}: cost {:.6g}, log evidence {:.4g} against {}; {}",
                  JoinNames(law->terms), both->Cost(), evidence,
                  kept_.empty() ? "none" : "the names", learned.formula));
  Spend("learning a law");
  diagnosis_.models.push_back(learned.model);
  if (!learned.model.is_kept) return;
  ForgetPhysics();
  std::vector<std::string> effects = EffectsSoFar();
  effects.insert(effects.end(), law->terms.begin(), law->terms.end());
  learned.model.effects = diagnosis_.models.back().effects = effects;
  diagnosis_.models.back().is_kept = true;
  diagnosis_.effects = EffectsSoFar();
  diagnosis_.answer = learned.model;
  diagnosis_.law = std::move(learned);
  now_ = std::move(*both);
  quality_ = quality;
}

void Diagnoser::MeasureWhatActs() {
  diagnosis_.acting = MeasureActingForce(now_.fine, diagnosis_.answer->effects);
  const bool acts = diagnosis_.acting && diagnosis_.acting->acts;
  if (acts) diagnosis_.acting_class = ClassOfActing(now_.fine.scene, *diagnosis_.acting);
}

void Diagnoser::Answer() {
  if (!quality_) quality_ = AppraiseQuality(now_.fine);
  Spend("intervals");
  TakeBackWhatIsTooLittle();
  diagnosis_.effects = EffectsSoFar();
  TellSetsBeside();
  if (!kept_.empty()) SetAnswer(kept_.back().before);
  if (missing_)
    diagnosis_.motions.missing_force = ForceOnParticles(now_.fine.scene.mesh, *missing_);
  diagnosis_.motions.held_out = recording_.splits.held_out_frames;
}

void Diagnoser::TellFit() {
  diagnosis_.fit = DiagnosisFit{now_.fine.scene, now_.fine.config, quality_->result};
  if (diagnosis_.answer || !diagnosis_.effects.empty())
    diagnosis_.motions.answer = SimulateFitted(now_.fine);
}

void Diagnoser::TellSoFar() {
  if (Stopped()) return;
  if (!quality_) quality_ = AppraiseQuality(now_.fine);
  Diagnoser interrupted(*this);
  interrupted.Answer();
  Diagnosis& so_far = interrupted.diagnosis_;
  interrupted.TellFit();
  AnswerAsInterrupted(&so_far);
  if (options_.so_far) options_.so_far(so_far);
  so_far_ = std::move(so_far);
}

void Diagnoser::Conclude() {
  if (Stopped()) {
    if (so_far_) {
      diagnosis_ = std::move(*so_far_);
      return;
    }
    if (!baseline_quality_) {  // before anything was ranked
      diagnosis_.baseline = now_.fine.config;
      diagnosis_.baseline_fit = now_.fine.fit;
    }
    diagnosis_.effects = swaps_;
    AnswerAsInterrupted(&diagnosis_);
    return;
  }
  Say("measuring how certain the answer is", 0.8);
  Answer();
  LearnInstead();
  const double explained = ExplainedByAnswer();
  const Outcome outcome{HasPhysics(),   IsExplained(last_ranking_),
                        explained,      quality_->Unexplained(),
                        quality_->mesh, MostOfAnswer()};
  diagnosis_.verdict = VerdictOf(diagnosis_, outcome);
  TellFit();
  // What stands for most of something unknown acts as that does.
  const bool stands_for =
      diagnosis_.verdict == Verdict::kNoneOfTheAbove && diagnosis_.answer && explained >= kHalfOfIt;
  if (diagnosis_.verdict == Verdict::kNamed || diagnosis_.law || stands_for) MeasureWhatActs();
  diagnosis_.words = DescribeDiagnosis(diagnosis_);
}

}  // namespace clothfit
