// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/force_matching.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/QR>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/classify/acting_force.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

constexpr int kMostSamples = 20;
constexpr int kSteps = 2;                               // of Gauss-Newton, of the amounts
constexpr double kDifference = 0.1;                     // of an amount's scale
constexpr double kNear[] = {0.5, 0.25, 0.125, 0.0625};  // of the spacing of probes

struct Sample {
  double time;
  Eigen::VectorXd x, v, a, start, memory;
  Eigen::VectorXd others;  // N, of all that acts besides
};

class ForceMatcher {
 public:
  ForceMatcher(const FittedScene& fitted, const std::vector<std::string>& effects);

  bool has_force() const { return squares_ > 0.0; }
  ForceMatch MatchForce(const CandidateTerm& candidate, const Extent& extent) const;

 private:
  int Index(const std::string& name) const {
    return RequireParameter(simulator_.simulation().model().parameters(), name);
  }
  Eigen::VectorXd ForceAt(const Sample& sample, const Eigen::VectorXd& parameters) const;
  // Of what these parameters switch on, all samples.
  Eigen::VectorXd ForceBesides(const Eigen::VectorXd& parameters) const;
  Eigen::VectorXd Force(const CandidateTerm& candidate, const Probe& probe,
                        const Eigen::VectorXd& amounts) const;
  ForceMatch At(const CandidateTerm& candidate, const Probe& probe) const;

  const FittedScene& fitted_;
  FreeParameters free_;
  WindowSimulator simulator_;
  Eigen::VectorXd parameters_;  // without the effects
  std::vector<Sample> samples_;
  Eigen::VectorXd target_;  // N, all samples
  double squares_ = 0.0;
};

ForceMatcher::ForceMatcher(const FittedScene& fitted, const std::vector<std::string>& effects)
    : fitted_(fitted),
      free_(fitted.values, fitted.scene, MakeParameterTable()),
      simulator_(fitted.scene, fitted.values, free_, false, nullptr) {
  const Scene& scene = fitted_.scene;
  const ClothModel& model = simulator_.simulation().model();
  const std::vector<std::string> names = SwitchesOf(effects);
  const Eigen::VectorXd theta = ThetaOfPass(free_, fitted_.unknown);
  const Eigen::VectorXd with = free_.Values(theta);
  const double frame_time = 1.0 / scene.recording.frame_rate;
  const int every = 1 + scene.last_fitted_frame / kMostSamples;
  Eigen::VectorXd v_before;
  const auto observe = [&](int frame, const State& state, const Sensitivity*) {
    if (v_before.size() > 0 && frame % every == 0) {
      // As where the acting force is measured: the memory is that after the step.
      samples_.push_back({state.time,
                          state.x,
                          state.v,
                          (state.v - v_before) / frame_time,
                          state.x - scene.step * state.v,
                          state.memory,
                          {}});
    }
    v_before = state.v;
  };
  const auto outcome =
      simulator_.Run(simulator_.FirstStart(theta), theta, scene.last_fitted_frame, false, observe);
  if (outcome != WindowSimulator::Outcome::kComplete) return;
  parameters_ = with;
  for (const std::string& name : names)
    parameters_[Index(name)] = model.parameters()[Index(name)].parameter.off;
  for (Sample& sample : samples_) sample.others = ForceAt(sample, parameters_);
  target_ = ForceBesides(with);
  squares_ = target_.squaredNorm();
}

Eigen::VectorXd ForceMatcher::ForceAt(const Sample& s, const Eigen::VectorXd& parameters) const {
  Eigen::VectorXd force, memory = s.memory;
  simulator_.simulation().model().Forces(
      {s.time, fitted_.scene.step, s.x, s.v, s.a, s.start, parameters, s.memory}, &force, &memory);
  return force;
}

Eigen::VectorXd ForceMatcher::ForceBesides(const Eigen::VectorXd& parameters) const {
  const Eigen::Index size = samples_.empty() ? 0 : samples_.front().x.size();
  Eigen::VectorXd force(size * static_cast<Eigen::Index>(samples_.size()));
  Eigen::Index at = 0;
  for (const Sample& sample : samples_) {
    force.segment(at, size) = ForceAt(sample, parameters) - sample.others;
    at += size;
  }
  return force;
}

Eigen::VectorXd ForceMatcher::Force(const CandidateTerm& candidate, const Probe& probe,
                                    const Eigen::VectorXd& amounts) const {
  Eigen::VectorXd parameters = parameters_;
  for (const auto& [name, value] : probe) parameters[Index(name)] = value;
  for (std::size_t j = 0; j < candidate.switches.size(); ++j)
    parameters[Index(candidate.switches[j])] = amounts[static_cast<Eigen::Index>(j)];
  return ForceBesides(parameters);
}

// Gauss-Newton from nothing, each step no further than it helps.
ForceMatch ForceMatcher::At(const CandidateTerm& candidate, const Probe& probe) const {
  const auto count = static_cast<Eigen::Index>(candidate.switches.size());
  Eigen::VectorXd low(count), high(count), scale(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const std::string& name = candidate.switches[static_cast<std::size_t>(j)];
    const Parameter parameter = ParameterNamed(name);
    const ParameterSetting& setting = fitted_.config.parameters.at(name);
    if (parameter.off != 0.0) return {};
    const bool is_one_sided = candidate.is_one_sided[static_cast<std::size_t>(j)];
    low[j] = is_one_sided ? 0.0 : setting.lower;
    high[j] = setting.upper;
    const double typical =
        parameter.scale == Scale::kLog ? parameter.initial : parameter.prior_factor;
    scale[j] = typical > 0.0 ? typical : 1.0;
  }
  ForceMatch best{probe, Eigen::VectorXd::Zero(count), 0.0};
  Eigen::VectorXd force = Eigen::VectorXd::Zero(target_.size());
  double left = squares_;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::MatrixXd columns(target_.size(), count);
    for (Eigen::Index j = 0; j < count; ++j) {
      Eigen::VectorXd moved = best.amounts;
      moved[j] += kDifference * scale[j];
      columns.col(j) = (Force(candidate, probe, moved) - force) / kDifference;
    }
    if (!columns.allFinite() || !(columns.squaredNorm() > 0.0)) break;
    Eigen::VectorXd change = columns.colPivHouseholderQr().solve(target_ - force);
    bool is_better = false;
    for (int halving = 0; halving < 3 && !is_better; ++halving, change *= 0.5) {
      const Eigen::VectorXd amounts =
          (best.amounts + scale.cwiseProduct(change)).cwiseMax(low).cwiseMin(high);
      Eigen::VectorXd there = Force(candidate, probe, amounts);
      const double left_there = (target_ - there).squaredNorm();
      if (!(left_there < left)) continue;
      is_better = true;
      best.amounts = amounts;
      force = std::move(there);
      left = left_there;
    }
    if (!is_better) break;
  }
  best.share = std::max(0.0, 1.0 - left / squares_);
  return best;
}

ForceMatch ForceMatcher::MatchForce(const CandidateTerm& candidate, const Extent& extent) const {
  ForceMatch best;
  const auto consider = [&](const Probe& probe) {
    ForceMatch there = At(candidate, probe);
    if (there.share <= best.share) return false;
    best = std::move(there);
    return true;
  };
  for (const Probe& probe : candidate.probes) consider(probe);
  if (best.share <= 0.0) return best;
  for (const double spacing : kNear) {
    bool is_better = true;
    for (int round = 0; is_better && round < 3; ++round) {
      is_better = false;
      for (const Probe& probe : ProbesNear(candidate, best.probe, extent, spacing))
        is_better = consider(probe) || is_better;
    }
  }
  return best;
}

}  // namespace

std::vector<ForceMatch> MatchForce(const FittedScene& fitted,
                                   const std::vector<std::string>& effects,
                                   const std::vector<CandidateTerm>& candidates,
                                   const Extent& extent) {
  const ForceMatcher matcher(fitted, effects);
  if (!matcher.has_force()) return {};
  std::vector<ForceMatch> matches(candidates.size());
  ParallelFor(static_cast<int>(candidates.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    matches[k] = matcher.MatchForce(candidates[k], extent);
  });
  return matches;
}

}  // namespace clothfit
