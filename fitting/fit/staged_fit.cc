// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/staged_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/fit/other_starts.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

constexpr int kFirstIterations = 6;        // enough to see which starts are worth more
constexpr int kFollowed = 2;               // starts to the end
constexpr double kNearly = 1.5;            // times the least cost: worth going on from
constexpr double kShareOfCoarseFit = 0.3;  // of the time, a guess

// The config of a fit with a coarser grid, where that is worth while: its iterations cost little,
// and stiffness and damping are the material's, not the mesh's.
std::optional<FitConfig> Coarser(const Scene& scene, const FitConfig& config) {
  const std::array<int, 2> grid = scene.mesh.grid;
  const int longer = std::max(grid[0], grid[1]), coarse = config.coarse_resolution;
  if (!scene.mesh.is_grid() || coarse < 2 || 3 * coarse > 2 * longer || !config.polish) {
    return std::nullopt;
  }
  constexpr int kIterationsToComeNear = 30;
  FitConfig coarser = config;
  coarser.max_iterations = std::min(config.max_iterations, kIterationsToComeNear);
  coarser.resolution = GridWithSide(grid, coarse);
  return coarser;
}

std::string Particles(const Scene& scene) {
  return fmt::format("{} x {} particles, ", scene.mesh.grid[0], scene.mesh.grid[1]);
}

// What a chi-square of so many degrees exceeds once in twenty times (Wilson and Hilferty 1931).
double ChiSquare95(double degrees) {
  constexpr double kNormal95 = 1.644854;
  const double part = 2.0 / (9.0 * std::max(1.0, degrees));
  return std::max(1.0, degrees) * std::pow(1.0 - part + kNormal95 * std::sqrt(part), 3.0);
}

}  // namespace

StagedFit::StagedFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks)
    : scene_(scene), config_(config), callbacks_(callbacks) {}

std::unique_ptr<StagedFit::Chain> StagedFit::MakeChain(const Scene& scene, const FitConfig& config,
                                                       const std::string& name) const {
  FitCallbacks own;
  own.stop = callbacks_.stop;
  if (callbacks_.log) {
    own.log = [this, name](const std::string& line) {
      const std::lock_guard<std::mutex> lock(mutex_);
      callbacks_.log(name + line);
    };
  }
  return std::make_unique<Chain>(scene, config, std::move(own));
}

void StagedFit::LetSpeak(const Stage& stage, Chain* chain) const {
  if (callbacks_.progress) {
    chain->callbacks.progress = [this, stage](FitProgress progress) {
      progress.stage = stage.name + progress.stage;
      progress.fraction = stage.begin + stage.share * progress.fraction;
      progress.simulated_frames += work_.simulated_frames;
      progress.differentiated_frames += work_.differentiated_frames;
      callbacks_.progress(progress);
    };
  }
  if (callbacks_.checkpoint) {
    chain->callbacks.checkpoint = [this, stage](FitCheckpoint checkpoint) {
      checkpoint.coarse = stage.is_coarse;
      callbacks_.checkpoint(checkpoint);
    };
  }
}

std::vector<Eigen::VectorXd> StagedFit::OtherThetas(const Scene& scene, const FitConfig& config,
                                                    const Eigen::VectorXd& theta) const {
  std::vector<Eigen::VectorXd> thetas;
  for (const FitConfig& other : OtherStarts(config)) {
    const FreeParameters free(other, scene, MakeParameterTable());
    Eigen::VectorXd& from = thetas.emplace_back(theta);
    for (const int i : free.Fabric()) from[i] = free.start()[i];
  }
  return thetas;
}

void StagedFit::Advance(const Chains& chains, int most_iterations) const {
  ParallelFor(static_cast<int>(chains.size()), NumThreads(0), [&](int i, int) {
    chains[static_cast<std::size_t>(i)]->fitter.Advance(most_iterations);
  });
}

void StagedFit::KeepBest(Chains* chains) {
  std::stable_sort(chains->begin(), chains->end(), [](const auto& a, const auto& b) {
    return a->fitter.cost() < b->fitter.cost();
  });
  const double least = chains->front()->fitter.cost();
  while (static_cast<int>(chains->size()) > kFollowed ||
         (chains->size() > 1 && !(chains->back()->fitter.cost() <= kNearly * least))) {
    chains->back()->fitter.AddWorkTo(&work_);
    chains->pop_back();
  }
}

void StagedFit::AddOthers(const Scene& scene, const FitConfig& config, int most_iterations,
                          const Stage& stage, Chains* chains) {
  Chain* const first = chains->front().get();
  if (!has_others_ || Stopped() || !first->fitter.LeavesMoreThanNoise()) return;
  for (const Eigen::VectorXd& theta : OtherThetas(scene, config, first->fitter.theta())) {
    const auto number = chains->size() + 1;
    chains->push_back(MakeChain(scene, config, fmt::format("{}start {}: ", stage.name, number)));
    Fitter& other = chains->back()->fitter;
    if (stage.is_coarse) other.OnlyComeNear();
    const FitCheckpoint from = other.AfterWindows(theta);
    other.Begin(&from);
  }
  starts_.begun = static_cast<int>(chains->size());
  if (starts_.begun == 1) return;
  Stage of_others = stage;  // the first has nothing left to say
  of_others.name += "other starts, ";
  LetSpeak(of_others, (*chains)[1].get());
  Advance(*chains, most_iterations);
}

void StagedFit::Race(const Stage& stage, Chains* chains) {
  // None is dropped on the way: after a few iterations the one that ends lower may be behind.
  LetSpeak(stage, chains->front().get());
  Advance(*chains, config_.max_iterations);
}

std::vector<Eigen::VectorXd> StagedFit::FitCoarse(const FitConfig& coarser,
                                                  const FitCheckpoint* resume, Chain* fine,
                                                  FitResult* before) {
  const Scene scene = MakeScene(scene_.recording, coarser, &scene_);
  const Stage stage{Particles(scene), 0.0, kShareOfCoarseFit, true};
  Chains chains;
  chains.push_back(MakeChain(scene, coarser, stage.name));
  LetSpeak(stage, chains.front().get());
  chains.front()->fitter.OnlyComeNear();
  ParallelFor(2, has_others_ ? NumThreads(0) : 1, [&](int i, int) {
    if (i == 1) return fine->fitter.MeasureStart(before);
    chains.front()->fitter.Begin(resume);
    chains.front()->fitter.Advance(coarser.max_iterations);
  });
  AddOthers(scene, coarser, coarser.max_iterations, stage, &chains);
  KeepBest(&chains);
  std::vector<Eigen::VectorXd> thetas;
  for (const auto& chain : chains) {
    thetas.push_back(chain->fitter.theta());
    chain->fitter.AddWorkTo(&work_);
  }
  return thetas;
}

void StagedFit::CountAgreeing(const Chains& chains, FitResult* result) const {
  const double variance = result->noise_factor * result->noise_factor *
                          (result->misfit ? result->misfit->correlation : 1.0);
  const auto fabric = FreeParameters(config_, scene_, MakeParameterTable()).Fabric().size();
  const double limit = variance * ChiSquare95(static_cast<double>(fabric));
  result->starts = starts_;
  result->starts.finished = static_cast<int>(chains.size());
  result->starts.agreeing = static_cast<int>(
      std::count_if(chains.begin(), chains.end(), [&](const std::unique_ptr<Chain>& chain) {
        return 2.0 * (chain->fitter.cost() - chains.front()->fitter.cost()) <= limit;
      }));
}

FitResult StagedFit::Run(const FitCheckpoint* resume) {
  const auto begin = std::chrono::steady_clock::now();
  FitResult before;
  const std::optional<FitConfig> coarser = Coarser(scene_, config_);
  Chains chains;
  chains.push_back(MakeChain(scene_, config_, ""));
  if (coarser && (resume == nullptr || resume->coarse)) {
    const std::vector<Eigen::VectorXd> thetas =
        FitCoarse(*coarser, resume, chains.front().get(), &before);
    while (chains.size() < thetas.size())
      chains.push_back(MakeChain(scene_, config_, "second start: "));
    for (std::size_t k = 0; k < chains.size(); ++k) {
      Fitter& fitter = chains[k]->fitter;
      const FitCheckpoint reached = fitter.AfterWindows(thetas[k]);
      fitter.BeginNear();
      fitter.Begin(&reached);
    }
    Race({"", kShareOfCoarseFit, 1.0 - kShareOfCoarseFit, false}, &chains);
  } else {
    const Stage stage;
    chains.front()->fitter.MeasureStart(&before);
    LetSpeak(stage, chains.front().get());
    Fitter& first = chains.front()->fitter;
    first.Begin(resume);
    if (has_others_ && resume == nullptr) {
      first.OnlyComeNear();
      first.Advance(config_.max_iterations);
      first.OnlyComeNear(false);
      AddOthers(scene_, config_, std::min(kFirstIterations, config_.max_iterations), stage,
                &chains);
      KeepBest(&chains);
    }
    Race(stage, &chains);
  }
  KeepBest(&chains);
  Fitter& best = chains.front()->fitter;
  if (tells_misfit_) best.TellMisfit();
  FitResult result = best.End();
  if (Stopped() && callbacks_.checkpoint && chains.size() > 1)
    callbacks_.checkpoint(best.AfterWindows(result.theta));
  CountAgreeing(chains, &result);
  // The result's own work, which End() has counted, and that of all others.
  for (std::size_t k = 1; k < chains.size(); ++k) chains[k]->fitter.AddWorkTo(&work_);
  result.before = before.before;
  result.cost_before = before.cost_before;
  result.iterations += work_.iterations;
  result.simulated_frames += work_.simulated_frames;
  result.differentiated_frames += work_.differentiated_frames;
  result.simulations =
      static_cast<int>(std::ceil(result.simulated_frames / std::max(1, scene_.last_fitted_frame)));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace clothfit
