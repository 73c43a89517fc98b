// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "fitting/fit/evaluation.h"
#include "fitting/optimise/checked_factor.h"
#include "fitting/optimise/levenberg_marquardt.h"
#include "fitting/rollout/nudging.h"

namespace clothfit {
namespace {

using Outcome = WindowSimulator::Outcome;

constexpr double kRadiusNear = 10.0;      // of the trust region, near a minimum
constexpr double kShareOfWindows = 0.6;   // of the time, a guess
constexpr int kIterationsToComeNear = 6;  // of what is pulled at

int NumIterations(const ceres::Solver::Summary& summary) {
  return std::max(0, static_cast<int>(summary.iterations.size()) - 1);
}

// Reports iterations and ends the solver when the fit is stopped or has come to its end.
class IterationReporter : public ceres::IterationCallback {
 public:
  IterationReporter(std::function<void(const ceres::IterationSummary&)> report, EndOfDescent end,
                    const std::atomic<bool>* stop)
      : report_(std::move(report)), end_(end), stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    report_(summary);
    converged_ = end_.IsReached(summary);
    const bool ends = converged_ || (stop_ != nullptr && *stop_);
    return ends ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  bool converged() const { return converged_; }

 private:
  std::function<void(const ceres::IterationSummary&)> report_;
  EndOfDescent end_;
  const std::atomic<bool>* stop_;
  bool converged_ = false;
};

}  // namespace

Fitter::Fitter(std::vector<NamedScene> scenes, const FitCallbacks& callbacks)
    : scenes_(std::move(scenes)),
      free_(scenes_.free()),
      config_(scenes_[0].config),
      callbacks_(callbacks),
      rollout_(scenes_, false, callbacks.stop),
      attracting_(scenes_, config_.attract, callbacks.stop),
      lengths_(WindowLengths(scenes_)),
      polish_tolerance_(PolishTolerance(1.0)) {}

double Fitter::PolishTolerance(double correlation) const {
  // Of the logarithm of the evidence, which is the cost over chi-square and correlation: what one
  // standard error of one parameter is worth, a sixth of what two models have to differ by.
  constexpr double kNegligible = 0.5;
  const double observed = scenes_.NumObserved();
  constexpr double kMost = 2e-4;  // however much residuals hang together
  const double negligible = 2.0 * kNegligible * correlation / std::max(1.0, observed);
  return std::max(config_.function_tolerance, std::min(kMost, negligible));
}

double Fitter::ResidualCorrelation() {
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const Scene& scene = scenes_[i].scene;
    if (!HasPoints(scene) || scene.silhouettes || scene.clouds || config_.attract) return 1.0;
  }
  Eigen::VectorXd residuals;
  if (!rollout_.Evaluate(progress_.theta, WindowRows::kAll, &residuals, nullptr)) return 1.0;
  return MeasureMisfit(SeenResiduals(scenes_, residuals), free_.size()).correlation;
}

void Fitter::OnlyComeNear() {
  constexpr double kTolerance = 1e-3;
  polish_tolerance_ = std::max(kTolerance, PolishTolerance(1.0));
  only_comes_near_ = true;
}

void Fitter::Report(const ceres::IterationSummary& iteration, int rows) {
  if (iteration.step_is_successful) {
    best_ = progress_.theta;
    best_cost_ = iteration.cost;
    at_best_ = newest_.IsAt(best_) ? newest_ : Linearisation{};
  }
  if (iteration.step_is_successful && callbacks_.checkpoint) {
    callbacks_.checkpoint(progress_);
  }
  if (!callbacks_.progress) return;
  FitProgress progress;
  progress.stage = stage_;
  progress.iteration = iteration.iteration;
  progress.cost = best_cost_;
  progress.rms = std::sqrt(2.0 * best_cost_ / std::max(1, rows));
  constexpr double kExpectedIterations = 8.0;
  progress.fraction =
      stage_begin_ + stage_share_ * std::min(1.0, iteration.iteration / kExpectedIterations);
  progress.simulated_frames = SimulatedFrames();
  progress.differentiated_frames = DifferentiatedFrames();
  callbacks_.progress(progress);
}

Fitter::Minimum Fitter::Minimise(const Misfits& misfits, const Patience& patience,
                                 double first_radius, const std::vector<int>& held) {
  const Eigen::MatrixXd& prior = free_.prior_jacobian();
  const auto evaluate = [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    Eigen::VectorXd observed;
    RowMajorMatrix columns;
    if (!misfits.evaluate(at, &observed, jacobian != nullptr ? &columns : nullptr)) return false;
    residuals->resize(observed.size() + prior.rows());
    *residuals << observed, free_.PriorResiduals(at);
    if (jacobian == nullptr) return true;
    jacobian->resize(residuals->size(), free_.size());
    *jacobian << columns, prior;
    return true;
  };
  ceres::Solver::Options options =
      LevenbergMarquardtOptions(patience.iterations, 0.0, first_radius);
  options.update_state_every_iteration = true;
  IterationReporter reporter(
      [&](const ceres::IterationSummary& s) { Report(s, misfits.num_observed); },
      EndOfDescent(patience.tolerance, patience.least_radius, patience.small_steps),
      callbacks_.stop);
  options.callbacks.push_back(&reporter);
  best_ = progress_.theta;
  Minimum minimum;
  minimum.summary = MinimiseWithin({free_.lower(), free_.upper(), held},
                                   misfits.num_rows + static_cast<int>(prior.rows()), evaluate,
                                   options, &progress_.theta);
  const ceres::Solver::Summary& summary = minimum.summary;
  minimum.converged = reporter.converged() || summary.termination_type == ceres::CONVERGENCE;
  progress_.theta = best_;  // Ceres takes back what it had reached when an evaluation fails
  iterations_ += NumIterations(summary);
  Log(fmt::format("{}: cost {:.6g} -> {:.6g}, {} iterations, {}", stage_, summary.initial_cost,
                  summary.final_cost, NumIterations(summary),
                  minimum.converged ? "converged" : summary.message));
  return minimum;
}

RecalledEvaluation Fitter::Recalled(RecalledEvaluation::Simulated simulated) {
  std::string name;
  for (std::size_t i = 0; i < scenes_.size(); ++i)
    name += fmt::format("{}{} particles, ", scenes_.named(i).name,
                        scenes_[i].scene.mesh.num_particles());
  return RecalledEvaluation(callbacks_.journal, name + stage_, std::move(simulated),
                            callbacks_.stop, &recalled_);
}

Fitter::Minimum Fitter::MinimiseRollout(JointRollout* simulated, int last, const Patience& patience,
                                        const std::vector<int>& held) {
  const bool is_whole = simulated == &rollout_ && held.empty() && last >= scenes_.LastFittedFrame();
  newest_ = {};
  if (!is_whole) at_best_ = {};
  Linearisation rollout;
  const std::vector<WindowStart> starts = simulated->FirstStarts(progress_.theta);
  RecalledEvaluation recalled = Recalled(
      {[&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) {
         return simulated->Evaluate(starts, at, last, WindowRows::kCompressed, residuals, jacobian);
       },
       [&] {
         return FrameCounts{simulated->simulated_frames(), simulated->differentiated_frames()};
       },
       [&] { return simulated->last_report(); }});
  const auto evaluate = [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    if (jacobian != nullptr && at_best_.IsAt(at)) {
      rollout = at_best_;
    } else {
      if (!recalled(at, &rollout.residuals, jacobian != nullptr ? &rollout.jacobian : nullptr))
        return false;
      rollout.theta = at;
      rollout.steps = recalled.steps();
    }
    *residuals = rollout.residuals;
    if (jacobian != nullptr) *jacobian = rollout.jacobian;
    if (jacobian != nullptr && is_whole) newest_ = rollout;
    return true;
  };
  simulated->Hold(held);
  Eigen::VectorXd residuals;  // simulated once, it is differentiated without being simulated again
  if (!at_best_.IsAt(progress_.theta) && !evaluate(progress_.theta, &residuals, nullptr)) {
    if (!Stopped()) Log(stage_ + ": where it begins cannot be simulated");
    simulated->Hold({});
    return {};
  }
  const double first_radius = is_near_ ? kRadiusNear : kCautiousRadius;
  const double radius = is_whole && radius_ > 0.0 ? radius_ : first_radius;
  Minimum minimum = Minimise({evaluate, simulated->NumCompressedRows(), scenes_.NumObserved(last)},
                             patience, radius, held);
  simulated->Hold({});
  return minimum;
}

void Fitter::LengthenWindows() {
  // Enough to stay near the minimum, which moves on.
  constexpr int kMostIterations = 8;
  constexpr double kTolerance = 0.05, kLeastRadius = 3.0;
  constexpr int kAny = std::numeric_limits<int>::max();  // small steps: they are not so small here
  const Patience on_the_way{std::min(kMostIterations, config_.max_iterations), kTolerance,
                            kLeastRadius, kAny};
  // Of forecasts, by which models are compared.
  const Patience at_the_end{std::min(2 * kMostIterations, config_.max_iterations), 0.2 * kTolerance,
                            kLeastRadius, kAny};
  ShootingWindows windows(scenes_, callbacks_.stop);
  const FrameCounts before{in_windows_.simulated, in_windows_.differentiated};
  const auto count_frames = [&] {
    in_windows_.simulated = before.simulated + windows.simulated_frames();
    in_windows_.differentiated = before.differentiated + windows.differentiated_frames();
  };
  const int all = static_cast<int>(lengths_.size()), count = std::min(all, most_lengths_);
  at_best_ = {};
  for (int& k = progress_.next_window; k < count && !Stopped(); ++k) {
    const WindowLength& length = lengths_[static_cast<std::size_t>(k)];
    stage_ = fmt::format("windows of {:.2g} s", length.seconds);
    stage_share_ = kShareOfWindows / all;
    stage_begin_ = k * stage_share_;
    const bool is_laid = windows.Lay(progress_.theta, length.frames);
    count_frames();
    if (!is_laid) {
      if (!Stopped()) Log(stage_ + ": the motion that they begin from cannot be simulated");
      break;
    }
    RecalledEvaluation evaluate = Recalled(
        {[&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) {
           const bool is_usable = windows.Evaluate(at, residuals, jacobian);
           count_frames();  // each iteration reports them
           return is_usable;
         },
         [&] {
           return FrameCounts{windows.simulated_frames(), windows.differentiated_frames()};
         },
         [] { return StepReport(); }});
    // Simulated once, they are differentiated without being simulated again.
    Eigen::VectorXd residuals;
    if (!evaluate(progress_.theta, &residuals, nullptr)) {
      if (!Stopped()) Log(stage_ + ": one of them cannot be simulated");
      continue;
    }
    const int observed = scenes_.NumObserved();
    const bool is_compared = only_forecasts_ && k == all - 1;
    best_cost_ = std::numeric_limits<double>::infinity();
    if (config_.max_iterations == 0) {  // where it begins, without derivatives
      best_cost_ = CostOf(residuals, progress_.theta);
    } else {
      in_windows_.converged =
          Minimise({std::ref(evaluate), windows.NumResiduals(), observed},
                   is_compared ? at_the_end : on_the_way, k == 0 ? kCautiousRadius : kRadiusNear)
              .converged;
    }
    in_windows_.cost = best_cost_;
    if (!std::isfinite(best_cost_)) {
      if (!Stopped()) Log(stage_ + ": where it begins cannot be differentiated");
      continue;
    }
    is_near_ = true;
    if (only_forecasts_ && k == count - 1)
      in_windows_.residuals = windows.Residuals(progress_.theta);
  }
  count_frames();
}

double Fitter::CostOf(const Eigen::VectorXd& residuals, const Eigen::VectorXd& theta) const {
  return 0.5 * (residuals.squaredNorm() + free_.PriorResiduals(theta).squaredNorm());
}

double Fitter::CostOf(std::size_t recording, const Eigen::VectorXd& residuals,
                      const Eigen::VectorXd& theta) const {
  const Eigen::VectorXd prior = scenes_[recording].free.PriorResiduals(free_.Of(recording, theta));
  return 0.5 * (rollout_.ResidualsOf(recording, residuals).squaredNorm() + prior.squaredNorm());
}

double Fitter::Cost(const Eigen::VectorXd& theta, JointRollout* rollout) const {
  Eigen::VectorXd residuals;
  const bool is_complete = rollout->Evaluate(theta, WindowRows::kCompressed, &residuals, nullptr);
  return is_complete ? CostOf(residuals, theta) : std::numeric_limits<double>::infinity();
}

void Fitter::Linearise(const Eigen::VectorXd& theta, JointRollout* rollout) {
  at_best_ = {};
  cost_ = std::numeric_limits<double>::infinity();
  if (rollout->Evaluate(theta, WindowRows::kCompressed, &at_best_.residuals, &at_best_.jacobian)) {
    at_best_.theta = theta;
    cost_ = CostOf(at_best_.residuals, theta);
  } else {
    at_best_ = {};
  }
  at_best_.steps = rollout->last_report();
}

void Fitter::StartPolish() {
  stage_ = scenes_.size() > 1
               ? fmt::format("all frames of {} recordings", scenes_.size())
               : fmt::format("all frames (0-{})", scenes_[0].scene.last_fitted_frame);
  stage_begin_ = lengths_.empty() ? 0.0 : kShareOfWindows;
  stage_share_ = 1.0 - stage_begin_;
  // Simulated here, it is differentiated without being simulated again.
  if (!only_comes_near_) polish_tolerance_ = PolishTolerance(ResidualCorrelation());
  Linearise(progress_.theta, &rollout_);
  if (cost_before_ < cost_ && progress_.theta != free_.start() && !Stopped()) {
    Log("the windows' result explains all frames worse than the start does; going on from the "
        "start");
    progress_.theta = free_.start();
    Linearise(progress_.theta, &rollout_);
  }
}

void Fitter::Advance(int most_iterations) {
  if (!HasWork() || !config_.polish || converged_ || Stopped()) return;
  if (!std::exchange(has_begun_polish_, true)) StartPolish();
  // What is left hangs together less the less it is: looked at again where a fit has ended.
  for (bool may_go_on = true; may_go_on && of_polish_ < most_iterations && !Stopped();) {
    const double tolerance = polish_tolerance_;
    const Minimum minimum = MinimiseRollout(&rollout_, JointRollout::kAllFrames,
                                            {most_iterations - of_polish_, tolerance});
    if (minimum.summary.iterations.empty()) return;
    converged_ = minimum.converged;
    cost_ = best_cost_;
    of_polish_ += NumIterations(minimum.summary);
    radius_ = minimum.summary.iterations.back().trust_region_radius;
    if (only_comes_near_ || !converged_) return;
    polish_tolerance_ = PolishTolerance(ResidualCorrelation());
    may_go_on = polish_tolerance_ < 0.5 * tolerance;
  }
}

bool Fitter::HasWork() const { return free_.size() > 0 && scenes_.NumResiduals() > 0; }

void Fitter::ToStart() {
  progress_ = {};
  progress_.theta = free_.start();
}

void Fitter::MeasureStart(FitResult* result) {
  starts_.assign(scenes_.size(), {});
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const auto& [scene, config, free, observations] = scenes_[i];
    starts_[i].evaluation = EvaluateScene(scene, config, free, free.start());
  }
  JointRollout unstopped(scenes_, false, nullptr);
  Eigen::VectorXd residuals;
  if (unstopped.Evaluate(free_.start(), WindowRows::kCompressed, &residuals, nullptr)) {
    cost_before_ = CostOf(residuals, free_.start());
    for (std::size_t i = 0; i < scenes_.size(); ++i)
      starts_[i].cost = CostOf(i, residuals, free_.start());
  }
  result->cost_before = cost_before_;
  if (scenes_.size() == 1) result->before = starts_[0].evaluation;
}

void Fitter::AddWorkTo(FitResult* result) const {
  result->iterations += iterations_;
  result->simulated_frames += SimulatedFrames();
  result->differentiated_frames += DifferentiatedFrames();
}

FitResult Fitter::At(const Eigen::VectorXd& theta) {
  FitResult result;
  ToStart();
  MeasureStart(&result);
  progress_.theta = theta;
  Finish(&result);
  return result;
}

void Fitter::Begin(const FitCheckpoint* resume) {
  ToStart();
  if (resume != nullptr) progress_ = *resume;
  converged_ = !HasWork();
  if (converged_) return;
  if (!lengths_.empty()) {
    LengthenWindows();
  } else if (resume == nullptr) {
    FindHandlePaths();
  }
  if (config_.polish) {
    if (!config_.attract || progress_.next_window > 0) return;
    FitPulled(kIterationsToComeNear);
  } else {
    if (lengths_.empty() && progress_.next_window == 0) FitPulled(config_.max_iterations);
    converged_ = progress_.next_window == NumStages();
  }
}

// Pulled at, where the config wants that: what follows only has to be come near to.
void Fitter::FitPulled(int most_iterations) {
  stage_ = config_.attract ? "pulled at" : "all frames";
  MinimiseRollout(&attracting_, JointRollout::kAllFrames,
                  {std::min(most_iterations, config_.max_iterations), config_.function_tolerance});
  if (!Stopped()) progress_.next_window = NumStages();
}

FitResult Fitter::Forecast(int num_lengths, int most_lengths, const FitCheckpoint* from) {
  ToStart();
  most_lengths_ = most_lengths;
  if (from != nullptr) progress_ = *from;
  only_forecasts_ = true;
  lengths_.resize(static_cast<std::size_t>(num_lengths));
  progress_.next_window = std::min(progress_.next_window, std::min(num_lengths, most_lengths) - 1);
  if (HasWork() && num_lengths > 0) LengthenWindows();
  FitResult result;
  result.theta = progress_.theta;
  result.parameters = scenes_[0].free.Values(result.theta);
  result.iterations = iterations_;
  result.simulated_frames = SimulatedFrames();
  result.differentiated_frames = DifferentiatedFrames();
  result.cost_after = in_windows_.cost;
  if (in_windows_.residuals.size() > 0) {
    result.misfit = MeasureMisfit(SeenResiduals(scenes_, in_windows_.residuals), free_.size());
    result.status = in_windows_.converged ? FitStatus::kConverged : FitStatus::kNotConverged;
  }
  if (Stopped()) result.status = FitStatus::kInterrupted;
  Uncertainty unknown;
  unknown.lower95 = unknown.upper95 =
      Eigen::VectorXd::Constant(free_.size(), std::numeric_limits<double>::quiet_NaN());
  unknown.determined.assign(static_cast<std::size_t>(free_.size()), true);
  FillEstimates(0, unknown, &result);
  return result;
}

FitResult Fitter::End() {
  FitResult result;
  Finish(&result);
  return result;
}

}  // namespace clothfit
