// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer of a diagnosis on a finer mesh: whether it stands there, whether it still comes before
// what could not be told from it, and its amounts, which are as good as the mesh.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/answer/verdict.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/gate/null_residuals.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/diagnosis/pipeline/diagnoser.h"

namespace clothfit {

bool Diagnoser::MayRefine(const ClothMesh& mesh) const {
  const bool can_be_finer =
      mesh.is_grid() && std::max(mesh.grid[0], mesh.grid[1]) < options_.finest_side;
  const bool is_physics =
      diagnosis_.answer && kept_ && !diagnosis_.law && kept_->candidate.faults.empty();
  return is_physics && can_be_finer && diagnosis_.residual_rms < kUnusableResidual && !Stopped();
}

// Wind whose drag is free takes twice as many iterations as a tilted gravity that looks alike.
FittedScene Diagnoser::GoneOnWith(FittedScene fitted) const {
  constexpr int kMoreFits = 2;
  for (int more = 0; more < kMoreFits && !Stopped(); ++more) {
    if (fitted.fit.status == FitStatus::kConverged) break;
    std::optional<FittedScene> further =
        FitModel(fitted, GoOn(fitted), 2 * kModelIterations, runner_);
    if (!further || !(further->fit.cost_after < fitted.fit.cost_after)) break;
    fitted = std::move(*further);
  }
  return fitted;
}

std::vector<std::optional<FittedScene>> Diagnoser::FitOn(
    const std::array<int, 2>& grid, const std::vector<const FittedScene*>& coarse) const {
  std::vector<std::optional<FittedScene>> finer(coarse.size());
  ParallelFor(static_cast<int>(coarse.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    ModelStart start = GoOn(*coarse[k]);
    start.config.resolution = grid;
    finer[k] = FitModel(*coarse[k], start, 2 * kModelIterations, runner_);
    if (finer[k]) finer[k] = GoneOnWith(std::move(*finer[k]));
  });
  return finer;
}

void Diagnoser::RefineAnswer(FittedScene* current, HeldOutErrors* errors) {
  if (!MayRefine(current->scene.mesh)) return;
  const std::array<int, 2> own = current->scene.mesh.grid;
  const int side = std::min(options_.finest_side, FinerSide(std::max(own[0], own[1])));
  const std::array<int, 2> grid = GridWithSide(own, side);
  Say(fmt::format("the answer, {} x {} particles", grid[0], grid[1]), 0.9);
  const bool is_only_one = diagnosis_.effects == kept_->candidate.Effects();
  std::vector<const FittedScene*> coarse = {&kept_->before, current};
  if (!is_only_one) coarse.push_back(&*first_scene_);
  const std::size_t first_competitor = coarse.size();
  if (is_only_one)
    for (const FittedModel& competitor : competitors_) coarse.push_back(&competitor.scene);
  std::vector<std::optional<FittedScene>> finer = FitOn(grid, coarse);
  Spend("the answer on a finer mesh");
  const bool have_failed =
      std::any_of(finer.begin(), finer.begin() + static_cast<std::ptrdiff_t>(first_competitor),
                  [](const auto& fitted) { return !fitted.has_value(); });
  if (have_failed || Stopped()) return;
  const double without = finer[0]->fit.cost_after, with = finer[1]->fit.cost_after;
  Log(fmt::format("on {} x {} particles: cost {:.6g}, with {} {:.6g}", grid[0], grid[1], without,
                  kept_->candidate.summary.name, with));
  if (!StandsOnFinerMesh(kept_->before.fit.cost_after - current->fit.cost_after, without - with)) {
    Log(kept_->candidate.summary.name + " is not kept: it does not stand on the finer mesh");
    TakeBack(current);
    MeasureAnswer(*current);
    return;
  }
  explained_ = ExplainedBy(*current);
  first_scene_ = is_only_one ? *finer[0] : std::move(*finer[2]);
  kept_->before = std::move(*finer[0]);
  kept_->before_errors = MeasureHeldOut(kept_->before);
  *current = std::move(*finer[1]);
  *errors = MeasureHeldOut(*current);
  if (const std::optional<LinearisedFit> linear = Linearise(kept_->before)) {
    constexpr int kDraws = 1;
    last_ranking_.errors = std::make_shared<const DiscretisationErrors>(MeasureDiscretisationErrors(
        kept_->before, linear->frames, linear->rows, kDraws, options_.seed));
  }
  std::vector<FittedModel> refined_competitors;
  for (std::size_t k = first_competitor; k < finer.size(); ++k) {
    if (!finer[k]) continue;
    HeldOutErrors of_competitor = MeasureHeldOut(*finer[k]);
    refined_competitors.push_back({competitors_[k - first_competitor].candidate,
                                   std::move(*finer[k]), std::move(of_competitor)});
  }
  FitWithMaterialOf(*current, &refined_competitors);
  ChooseAgain(std::move(refined_competitors), current, errors);
  DescribeAnswerAgain(*current, *errors);
}

// What looks alike may have ended at other material parameters: wind at one whose drag is twice too
// large, 4200, from that of a tilted gravity, 3140, at 3090.
void Diagnoser::FitWithMaterialOf(const FittedScene& answer,
                                  std::vector<FittedModel>* competitors) const {
  FitConfig material = kept_->before.config;
  for (auto& [name, setting] : material.parameters)
    setting.value = answer.values.parameters.at(name).value;
  ParallelFor(static_cast<int>(competitors->size()), NumThreads(0), [&](int i, int) {
    FittedModel& competitor = (*competitors)[static_cast<std::size_t>(i)];
    std::optional<FittedScene> other = FitModel(
        answer, WithMaterialOf(material, GoOn(competitor.scene)), 2 * kModelIterations, runner_);
    if (other) other = GoneOnWith(std::move(*other));
    if (!other || !(other->fit.cost_after < competitor.scene.fit.cost_after)) return;
    competitor.scene = std::move(*other);
    competitor.errors = MeasureHeldOut(competitor.scene);
  });
}

HeldOutValidation Diagnoser::Validate(const FittedModel& model, double other_cost,
                                      const ValidationStart& start) const {
  const bool leaves_far_less = model.scene.fit.cost_after <= kFarLess * other_cost;
  return leaves_far_less ? ValidateByAnyTest(model, start) : ValidateOnHeldOut(model, start);
}

void Diagnoser::ChooseAgain(std::vector<FittedModel> competitors, FittedScene* current,
                            HeldOutErrors* errors) {
  if (competitors.empty()) return;
  const std::string name = kept_->candidate.summary.name;
  competitors.push_back({kept_->candidate, *current, *errors});
  PutBestFirst(kept_->before.fit.cost_after, kept_->before_errors, last_ranking_, &competitors);
  FittedModel& best = competitors.front();
  const std::string& better = best.candidate.summary.name;
  for (const FittedModel& competitor : competitors)
    Log(fmt::format("  with {}: cost {:.6g}", competitor.candidate.summary.name,
                    competitor.scene.fit.cost_after));
  if (better == name) return;
  const HeldOutValidation validation =
      Validate(best, current->fit.cost_after,
               {kept_->before, kept_->before_errors, last_ranking_, options_});
  if (options_.validate && !validation.is_validated) return;
  Log(better + " comes before " + name + " on the finer mesh");
  diagnosis_.effects = diagnosis_.answer->effects = best.candidate.Effects();
  diagnosis_.answer->validation = validation;
  kept_parameters_ = best.candidate.names;
  for (const auto& [parameter, value] : best.candidate.probe) kept_parameters_.push_back(parameter);
  std::vector<std::string>& set = diagnosis_.confidence_set;
  std::rotate(set.begin(), std::find(set.begin(), set.end(), better),
              std::find(set.begin(), set.end(), better) + 1);
  diagnosis_.models[kept_->model].is_kept = false;
  for (std::size_t i = 0; i < diagnosis_.models.size(); ++i) {
    if (diagnosis_.models[i].effects == diagnosis_.effects) kept_->model = i;
  }
  diagnosis_.models[kept_->model].is_kept = true;
  kept_->candidate = best.candidate;
  *current = std::move(best.scene);
  *errors = std::move(best.errors);
}

void Diagnoser::DescribeAnswerAgain(const FittedScene& current, const HeldOutErrors& errors) {
  const Model described =
      Describe({kept_->candidate, current, errors}, kept_->before, kept_->before_errors);
  Model& answer = *diagnosis_.answer;
  answer.config = described.config;
  answer.parameters = described.parameters;
  answer.cost = described.cost;
  if (described.validation.is_validated) answer.validation = described.validation;
  MeasureAnswer(current);
}

}  // namespace clothfit
