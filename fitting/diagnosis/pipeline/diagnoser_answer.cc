// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer of a diagnosis: a law where names explain too little, how certain its parameters are,
// where it acts, and the verdict.
#include <algorithm>

#include <fmt/format.h>

#include "fitting/diagnosis/answer/summary_text.h"
#include "fitting/diagnosis/classify/class_text.h"
#include "fitting/diagnosis/compare/undetermined.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/gate/gate.h"
#include "fitting/diagnosis/law/learn.h"
#include "fitting/diagnosis/model/explained_share.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"
#include "tracking/text/text.h"

namespace clothfit {

void Diagnoser::LearnInstead(FittedScene* current) {
  if (!first_ranking_ || Stopped()) return;
  const bool stands_out = first_ranking_->gate_p_value < kGate && is_above_discretisation_;
  // Physics that is validated is there, whatever mesh and step may leave.
  const bool is_there = kept_ && kept_->candidate.faults.empty() &&
                        HasLargeResidual(current->scene, current->config, current->fit);
  if (!stands_out && !is_there) return;
  const double explained = ExplainedBy(*current);
  if (explained > MostOfIt(diagnosis_)) return;
  Say("learning a law", 0.85);
  std::optional<LearnedFit> fit = LearnLaw(*first_scene_, baseline_, *first_ranking_, options_);
  Spend("learning a law");
  if (!fit) return;
  FittedModel model{{}, fit->scene, MeasureHeldOut(fit->scene)};
  model.candidate.names = fit->names;
  last_ranking_ = *first_ranking_;
  kept_parameters_.clear();
  Law law{Describe(model, *first_scene_, first_errors_), LawFormula(*fit, first_ranking_->extent)};
  law.model.effects = fit->terms;
  law.model.is_kept = !options_.validate || law.model.validation.is_validated;
  Log(fmt::format("a law of {}: cost {:.6g} -> {:.6g}; {}", JoinNames(fit->terms), baseline_cost_,
                  fit->scene.fit.cost_after, law.formula));
  diagnosis_.models.push_back(law.model);
  // By the same measure as the names.
  const double by_names = baseline_cost_ - current->fit.cost_after;
  const double by_law = explained > 0.0 ? explained * (baseline_cost_ - law.model.cost) / by_names
                                        : law.model.explained;
  const HeldOutValidation* const of_names =
      diagnosis_.answer ? &diagnosis_.answer->validation : nullptr;
  if (!law.model.is_kept || !TakesPlace(law.model.validation, by_law, of_names, explained)) {
    diagnosis_.models.back().is_kept = false;
    return;
  }
  diagnosis_.answer = law.model;
  diagnosis_.effects.clear();
  diagnosis_.confidence_set.clear();
  diagnosis_.separating.reset();
  diagnosis_.law = std::move(law);
  *current = fit->scene;
  MeasureAnswer(*current);
}

void Diagnoser::MeasureAnswer(const FittedScene& model) {
  if (!diagnosis_.answer || Stopped()) return;
  Say("measuring what mesh and step do to the answer", 0.85);
  shifts_ = MeasureDiscretisationShifts(model, options_.seed);
  Spend("intervals");
}

// Where mesh and step may make all that is left, and the amounts of what is named last too: that is
// not named.
void Diagnoser::WithdrawWhatMayBeNothing(FittedScene* current) {
  const bool may_be_mesh = diagnosis_.gate_p_value >= kGate;
  if (!diagnosis_.answer || !kept_ || !kept_->candidate.faults.empty() || !may_be_mesh) return;
  const std::vector<std::string>& names = kept_->candidate.names;
  std::vector<EffectParameter> amounts;
  for (const EffectParameter& p : diagnosis_.answer->parameters) {
    if (std::find(names.begin(), names.end(), p.name) != names.end()) amounts.push_back(p);
  }
  Widen(shifts_, current->config, &amounts);
  if (!MayBeNothing(shifts_, current->values, amounts)) return;
  Log(kept_->candidate.summary.name +
      " is not kept: mesh and step may make all of it, and all that the baseline leaves");
  TakeBack(current);
}

void Diagnoser::TakeBack(FittedScene* current) {
  diagnosis_.models[kept_->model].is_kept = false;
  for (const std::string& name : kept_->candidate.Effects()) {
    std::vector<std::string>& effects = diagnosis_.effects;
    effects.erase(std::remove(effects.begin(), effects.end(), name), effects.end());
  }
  diagnosis_.answer.reset();
  for (std::size_t i = 0; i < kept_->model; ++i) {  // what was kept before
    if (diagnosis_.models[i].is_kept) diagnosis_.answer = diagnosis_.models[i];
  }
  if (!diagnosis_.answer) {
    diagnosis_.confidence_set.clear();
    diagnosis_.separating.reset();
  }
  *current = std::move(kept_->before);
  kept_.reset();
}

// Around a fit that is far off mesh and step leave more than around the truth, so that much seems
// to be explained by whatever comes as near as that. What is far off itself is held to what they
// leave of it.
double Diagnoser::ExplainedBy(const FittedScene& model) const {
  double null = last_ranking_.null_mean;
  if (diagnosis_.answer && shifts_.by.cols() > 0 &&
      HasLargeResidual(model.scene, model.config, model.fit)) {
    Log(fmt::format(
        "noise, mesh and step leave a cost of {:.4g} of the baseline, of the answer {:.4g}",
        0.5 * null, 0.5 * shifts_.left_squared));
    null = std::min(null, shifts_.left_squared);
  }
  const double explainable = first_ranking_ ? first_ranking_->explainable : 0.0;
  return ShareExplained(baseline_cost_, model.fit.cost_after, 0.5 * null,
                        0.5 * std::max(explainable, kept_score_));
}

Model* Diagnoser::AnswerAmongModels() {
  return kept_ && !explained_ ? &diagnosis_.models[kept_->model] : nullptr;
}

void Diagnoser::WidenIntervals(const FittedScene& model) {
  if (!diagnosis_.answer || Stopped()) return;
  Widen(shifts_, model.config, &diagnosis_.answer->parameters);
  const std::vector<EffectParameter>& widened = diagnosis_.answer->parameters;
  if (diagnosis_.law) {  // the last of the models
    diagnosis_.law->model.parameters = diagnosis_.models.back().parameters = widened;
  } else if (Model* const row = AnswerAmongModels()) {
    row->parameters = widened;
  }
}

void Diagnoser::TakeOutUndetermined(FittedScene* current, const HeldOutErrors& errors) {
  if (!diagnosis_.answer || !kept_ || diagnosis_.law || !kept_->candidate.faults.empty()) return;
  Model& answer = *diagnosis_.answer;
  std::optional<FittedModel> simpler =
      WithoutUndetermined({kept_->candidate, *current, errors}, kept_->before.fit.cost_after,
                          answer.parameters, runner_);
  Spend("without what is not determined");
  if (!simpler) return;
  Log(fmt::format("without {}, which this recording does not determine: cost {:.6g} -> {:.6g}",
                  JoinNames(Undetermined(answer.parameters)), current->fit.cost_after,
                  simpler->scene.fit.cost_after));
  Model described = Describe(*simpler, kept_->before, kept_->before_errors);
  TakeValues(simpler->scene.values, &answer.parameters);
  answer.config = described.config;
  answer.cost = described.cost;
  if (!explained_) answer.explained = described.explained;
  if (described.validation.is_validated) answer.validation = described.validation;
  if (Model* const model = AnswerAmongModels()) *model = answer;
  *current = std::move(simpler->scene);
}

void Diagnoser::MeasureWhatActs(const FittedScene& model) {
  diagnosis_.acting = MeasureActingForce(model, diagnosis_.answer->effects);
  const bool acts = diagnosis_.acting && diagnosis_.acting->acts;
  if (acts) diagnosis_.acting_class = ClassOfActing(model.scene, *diagnosis_.acting);
}

void Diagnoser::Conclude(const FittedScene& current) {
  const double explained = explained_ ? *explained_ : ExplainedBy(current);
  if (diagnosis_.answer && kept_ && !diagnosis_.law) {  // of what is far off no more than that
    diagnosis_.answer->explained = std::min(diagnosis_.answer->explained, explained);
    diagnosis_.models[kept_->model].explained = diagnosis_.answer->explained;
  }
  diagnosis_.verdict = Stopped() ? Verdict::kInterrupted
                                 : VerdictOf(diagnosis_, explained, is_above_discretisation_);
  // What stands for most of something unknown acts as that does.
  constexpr double kStandsFor = 0.5;
  const bool stands_for = diagnosis_.verdict == Verdict::kNoneOfTheAbove && diagnosis_.answer &&
                          explained >= kStandsFor;
  if (diagnosis_.verdict == Verdict::kNamed || diagnosis_.law || stands_for)
    MeasureWhatActs(current);
  diagnosis_.words = DescribeDiagnosis(diagnosis_);
}

}  // namespace clothfit
