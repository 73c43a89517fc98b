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

// Reports iterations and ends the solver when the fit is stopped, or when a step that was taken,
// and was not cut short by a small trust region, lowers the cost by less than the tolerance. (Ceres
// looks at steps that were not taken and at any radius.)
class IterationReporter : public ceres::IterationCallback {
 public:
  IterationReporter(std::function<void(const ceres::IterationSummary&)> report, double tolerance,
                    double least_radius, const std::atomic<bool>* stop)
      : report_(std::move(report)),
        tolerance_(tolerance),
        least_radius_(least_radius),
        stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    report_(summary);
    converged_ = summary.iteration > 0 && summary.step_is_successful &&
                 summary.trust_region_radius >= least_radius_ &&
                 summary.cost_change <= tolerance_ * summary.cost;
    const bool ends = converged_ || (stop_ != nullptr && *stop_);
    return ends ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  bool converged() const { return converged_; }

 private:
  std::function<void(const ceres::IterationSummary&)> report_;
  double tolerance_, least_radius_;
  const std::atomic<bool>* stop_;
  bool converged_ = false;
};

}  // namespace

Fitter::Fitter(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks)
    : scene_(scene),
      config_(config),
      callbacks_(callbacks),
      free_(config, scene, MakeParameterTable()),
      observations_(scene, config),
      simulator_(scene, config, free_, false, callbacks.stop),
      attracting_(scene, config, free_, config.attract, callbacks.stop),
      lengths_(WindowLengths(scene, config)),
      polish_tolerance_(PolishTolerance(1.0)) {}

double Fitter::PolishTolerance(double correlation) const {
  // Of the logarithm of the evidence, which is the cost over chi-square and correlation: what one
  // standard error of one parameter is worth, a sixth of what two models have to differ by.
  constexpr double kNegligible = 0.5;
  const double observed = observations_.NumObserved(0, scene_.last_fitted_frame);
  constexpr double kMost = 2e-4;  // however much residuals hang together
  const double negligible = 2.0 * kNegligible * correlation / std::max(1.0, observed);
  return std::max(config_.function_tolerance, std::min(kMost, negligible));
}

double Fitter::ResidualCorrelation() {
  if (!HasPoints(scene_) || scene_.silhouettes || scene_.clouds || config_.attract) return 1.0;
  Eigen::VectorXd residuals;
  const Eigen::VectorXd& theta = progress_.theta;
  if (EvaluateWindow(&simulator_, observations_, simulator_.FirstStart(theta), theta, 0,
                     scene_.last_fitted_frame, WindowRows::kAll, &residuals,
                     nullptr) != Outcome::kComplete) {
    return 1.0;
  }
  return MeasureMisfit(SeenResiduals(scene_, residuals), free_.size()).correlation;
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
      patience.tolerance, patience.least_radius, callbacks_.stop);
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
  return RecalledEvaluation(callbacks_.journal,
                            fmt::format("{} particles, {}", scene_.mesh.num_particles(), stage_),
                            std::move(simulated), callbacks_.stop, &recalled_);
}

Fitter::Minimum Fitter::MinimiseRollout(WindowSimulator* simulator, int last,
                                        const Patience& patience, const std::vector<int>& held) {
  const bool is_whole =
      simulator == &simulator_ && held.empty() && last == scene_.last_fitted_frame;
  newest_ = {};
  if (!is_whole) at_best_ = {};
  Linearisation rollout;
  const WindowStart start = simulator->FirstStart(progress_.theta);
  RecalledEvaluation recalled = Recalled(
      {[&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) {
         return EvaluateWindow(simulator, observations_, start, at, 0, last,
                               WindowRows::kCompressed, residuals, jacobian) == Outcome::kComplete;
       },
       [&] {
         return FrameCounts{simulator->simulated_frames(), simulator->differentiated_frames()};
       },
       [&] { return simulator->last_report(); }});
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
  simulator->Hold(held);
  Eigen::VectorXd residuals;  // simulated once, it is differentiated without being simulated again
  if (!at_best_.IsAt(progress_.theta) && !evaluate(progress_.theta, &residuals, nullptr)) {
    if (!Stopped()) Log(stage_ + ": where it begins cannot be simulated");
    simulator->Hold({});
    return {};
  }
  const double first_radius = is_near_ ? kRadiusNear : kCautiousRadius;
  const double radius = is_whole && radius_ > 0.0 ? radius_ : first_radius;
  Minimum minimum = Minimise({evaluate, free_.size() + 1, observations_.NumObserved(0, last)},
                             patience, radius, held);
  simulator->Hold({});
  return minimum;
}

void Fitter::LengthenWindows() {
  // Enough to stay near the minimum, which moves on.
  constexpr int kMostIterations = 8;
  constexpr double kTolerance = 0.05, kLeastRadius = 3.0;
  const Patience on_the_way{std::min(kMostIterations, config_.max_iterations), kTolerance,
                            kLeastRadius};
  // Of forecasts, by which models are compared.
  const Patience at_the_end{std::min(2 * kMostIterations, config_.max_iterations), 0.2 * kTolerance,
                            kLeastRadius};
  ShootingWindows windows(scene_, config_, free_, callbacks_.stop);
  const int all = static_cast<int>(lengths_.size()), count = std::min(all, most_lengths_);
  at_best_ = {};
  for (int& k = progress_.next_window; k < count && !Stopped(); ++k) {
    const int frames = lengths_[static_cast<std::size_t>(k)];
    stage_ = fmt::format("windows of {:.2g} s", frames / scene_.recording.frame_rate);
    stage_share_ = kShareOfWindows / all;
    stage_begin_ = k * stage_share_;
    if (!windows.Lay(progress_.theta, frames)) {
      if (!Stopped()) Log(stage_ + ": the motion that they begin from cannot be simulated");
      break;
    }
    RecalledEvaluation evaluate = Recalled(
        {[&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) {
           return windows.Evaluate(observations_, at, residuals, jacobian);
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
    const int observed = observations_.NumObserved(0, scene_.last_fitted_frame);
    const bool is_compared = only_forecasts_ && k == all - 1;
    best_cost_ = std::numeric_limits<double>::infinity();
    in_windows_.converged =
        Minimise({std::ref(evaluate), windows.NumResiduals(), observed},
                 is_compared ? at_the_end : on_the_way, k == 0 ? kCautiousRadius : kRadiusNear)
            .converged;
    in_windows_.cost = best_cost_;
    if (!std::isfinite(best_cost_)) {
      if (!Stopped()) Log(stage_ + ": where it begins cannot be differentiated");
      continue;
    }
    is_near_ = true;
    if (only_forecasts_ && k == count - 1)
      in_windows_.residuals = windows.Residuals(observations_, progress_.theta);
  }
  in_windows_.simulated += windows.simulated_frames();
  in_windows_.differentiated += windows.differentiated_frames();
}

void Fitter::FindHandlePaths() {
  const bool any_unknown =
      std::any_of(scene_.handles.begin(), scene_.handles.end(),
                  [](const SceneHandle& handle) { return !handle.path.is_known(); });
  if (!any_unknown) return;
  const double at_start = Cost(free_.start(), &simulator_);
  constexpr int kControls = 2;  // of a path that each stretch adds
  const int stride = std::max(1, static_cast<int>(std::lround(kControls * config_.spline_spacing *
                                                              scene_.recording.frame_rate)));
  FrameByFrameOptions options;
  options.optimiser = "lm";
  FrameByFrame search(scene_, config_, free_, options, callbacks_.stop);
  int fitted = 0;  // the last frame of the last fit of all that is unknown
  for (int last = 0; last < scene_.last_fitted_frame && !Stopped();) {
    const int next = std::min(last + stride, scene_.last_fitted_frame);
    stage_ = fmt::format("handles, frames 0-{}", next);
    if (!ContinueHandlePaths(&search, last, next)) break;
    last = next;
    // Such a fit begins at the first frame: the more there are, the more new ones are worth one.
    constexpr double kGrowth = 0.15;
    const bool is_last = last == scene_.last_fitted_frame;
    if (!is_last && last - fitted < kGrowth * last) continue;
    if (observations_.Count(0, last) == 0) continue;
    // The tolerance is of a cost of which most may be the masks' own.
    constexpr Patience kPatience{5, 1e-6};
    MinimiseRollout(&simulator_, last, kPatience, ControlsLongBefore(fitted));
    fitted = last;
  }
  if (Cost(progress_.theta, &simulator_) < at_start) return;
  Log("handles: what was found explains all frames worse than the start does");
  progress_.theta = free_.start();
}

std::vector<int> Fitter::ControlsLongBefore(int frame) const {
  constexpr double kLag = 8.0;  // control points: what came before has been fitted often enough
  const double now = scene_.FrameTime(frame) / config_.spline_spacing;
  std::vector<int> entries;
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    if (entry.kind == FreeEntry::Kind::kHandle && entry.control < now - kLag) entries.push_back(i);
  }
  return entries;
}

bool Fitter::ContinueHandlePaths(FrameByFrame* search, int first, int last) {
  State state;
  std::vector<std::vector<PathPoint>> paths(scene_.handles.size());
  std::vector<SceneHandle> handles = scene_.handles;
  free_.ApplyToHandles(progress_.theta, &handles);
  const Outcome outcome =
      simulator_.Run(simulator_.FirstStart(progress_.theta), progress_.theta, first, false,
                     [&](int frame, const State& at, const Sensitivity*) {
                       state = at;
                       const double time = scene_.FrameTime(frame);
                       for (std::size_t h = 0; h < handles.size(); ++h)
                         paths[h].push_back({time, handles[h].path.At(time)});
                     });
  if (outcome != Outcome::kComplete) return false;
  const FrameByFrameResult found = search->Continue(progress_.theta, state, first, last);
  frames_for_paths_ += found.simulated_frames;
  differentiated_for_paths_ += found.differentiated_frames;
  if (!found.complete) {
    Log(stage_ + ": the simulation does not reach the last one");
    return false;
  }
  for (std::size_t h = 0; h < handles.size(); ++h)
    paths[h].insert(paths[h].end(), found.paths[h].begin(), found.paths[h].end());
  constexpr double kSigma = 0.001;  // m
  progress_.theta = free_.WithHandlePaths(progress_.theta, scene_, paths, kSigma);
  return true;
}

double Fitter::Cost(const Eigen::VectorXd& theta, WindowSimulator* simulator) const {
  Eigen::VectorXd residuals;
  const WindowStart start = simulator->FirstStart(theta);
  if (EvaluateWindow(simulator, observations_, start, theta, 0, scene_.last_fitted_frame,
                     WindowRows::kCompressed, &residuals, nullptr) != Outcome::kComplete) {
    return std::numeric_limits<double>::infinity();
  }
  return 0.5 * (residuals.squaredNorm() + free_.PriorResiduals(theta).squaredNorm());
}

void Fitter::Linearise(const Eigen::VectorXd& theta, WindowSimulator* simulator) {
  const WindowStart start = simulator->FirstStart(theta);
  at_best_ = {};
  cost_ = std::numeric_limits<double>::infinity();
  const Outcome outcome =
      EvaluateWindow(simulator, observations_, start, theta, 0, scene_.last_fitted_frame,
                     WindowRows::kCompressed, &at_best_.residuals, &at_best_.jacobian);
  if (outcome == Outcome::kComplete) {
    at_best_.theta = theta;
    cost_ = 0.5 * (at_best_.residuals.squaredNorm() + free_.PriorResiduals(theta).squaredNorm());
  } else {
    at_best_ = {};
  }
  at_best_.steps = simulator->last_report();
}

void Fitter::StartPolish() {
  stage_ = fmt::format("all frames (0-{})", scene_.last_fitted_frame);
  stage_begin_ = lengths_.empty() ? 0.0 : kShareOfWindows;
  stage_share_ = 1.0 - stage_begin_;
  // Simulated here, it is differentiated without being simulated again.
  if (!only_comes_near_) polish_tolerance_ = PolishTolerance(ResidualCorrelation());
  Linearise(progress_.theta, &simulator_);
  if (cost_before_ < cost_ && progress_.theta != free_.start() && !Stopped()) {
    Log("the windows' result explains all frames worse than the start does; going on from the "
        "start");
    progress_.theta = free_.start();
    Linearise(progress_.theta, &simulator_);
  }
}

void Fitter::Advance(int most_iterations) {
  if (!HasWork() || !config_.polish || converged_ || Stopped()) return;
  if (!std::exchange(has_begun_polish_, true)) StartPolish();
  // What is left hangs together less the less it is: looked at again where a fit has ended.
  for (bool may_go_on = true; may_go_on && of_polish_ < most_iterations && !Stopped();) {
    const double tolerance = polish_tolerance_;
    const Minimum minimum = MinimiseRollout(&simulator_, scene_.last_fitted_frame,
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

bool Fitter::HasWork() const {
  return free_.size() > 0 && observations_.Count(0, scene_.last_fitted_frame) > 0;
}

void Fitter::ToStart() {
  progress_ = {};
  progress_.theta = free_.start();
}

void Fitter::MeasureStart(FitResult* result) {
  result->before = EvaluateScene(scene_, config_, free_, free_.start());
  WindowSimulator unstopped(scene_, config_, free_, false, nullptr);
  result->cost_before = cost_before_ = Cost(free_.start(), &unstopped);
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
  MinimiseRollout(&attracting_, scene_.last_fitted_frame,
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
  result.parameters = free_.Values(result.theta);
  result.iterations = iterations_;
  result.simulated_frames = SimulatedFrames();
  result.differentiated_frames = DifferentiatedFrames();
  result.cost_after = in_windows_.cost;
  if (in_windows_.residuals.size() > 0) {
    result.misfit = MeasureMisfit(SeenResiduals(scene_, in_windows_.residuals), free_.size());
    result.status = in_windows_.converged ? FitStatus::kConverged : FitStatus::kNotConverged;
  }
  if (Stopped()) result.status = FitStatus::kInterrupted;
  Uncertainty unknown;
  unknown.lower95 = unknown.upper95 =
      Eigen::VectorXd::Constant(free_.size(), std::numeric_limits<double>::quiet_NaN());
  unknown.determined.assign(static_cast<std::size_t>(free_.size()), true);
  FillEstimates(unknown, &result);
  return result;
}

FitResult Fitter::End() {
  FitResult result;
  Finish(&result);
  return result;
}

}  // namespace clothfit
