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

namespace clothfit {
namespace {

using Outcome = WindowSimulator::Outcome;

int NumIterations(const ceres::Solver::Summary& summary) {
  return std::max(0, static_cast<int>(summary.iterations.size()) - 1);
}

// Reports iterations and ends the solver when the fit is stopped.
class IterationReporter : public ceres::IterationCallback {
 public:
  explicit IterationReporter(std::function<void(const ceres::IterationSummary&)> report,
                             const std::atomic<bool>* stop)
      : report_(std::move(report)), stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    report_(summary);
    return stop_ != nullptr && *stop_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                      : ceres::SOLVER_CONTINUE;
  }

 private:
  std::function<void(const ceres::IterationSummary&)> report_;
  const std::atomic<bool>* stop_;
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
      polish_tolerance_(PolishTolerance()) {
  window_frames_ =
      config.window > 0.0
          ? std::max(1, static_cast<int>(std::lround(config.window * scene.recording.frame_rate)))
          : std::max(1, scene.last_fitted_frame);
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry::Kind kind = free_.entries()[i].kind;
    if (kind == FreeEntry::Kind::kInitialPosition || kind == FreeEntry::Kind::kInitialVelocity) {
      offsets_.push_back(i);
    }
  }
  num_windows_ = (std::max(1, scene.last_fitted_frame) + window_frames_ - 1) / window_frames_;
}

double Fitter::PolishTolerance() const {
  // Twice this, over the square of the noise factor, is a change of the chi-square: 0.05 moves
  // nothing by more than a fifth of its standard error.
  constexpr double kNegligible = 0.025;
  const double observed = observations_.NumObserved(0, scene_.last_fitted_frame);
  return std::max(config_.function_tolerance, 2.0 * kNegligible / std::max(1.0, observed));
}

void Fitter::OnlyComeNear(bool near) {
  constexpr double kTolerance = 1e-3;
  polish_tolerance_ = near ? std::max(kTolerance, PolishTolerance()) : PolishTolerance();
  if (!near && HasWork() && config_.polish) converged_ = false;
}

void Fitter::Report(const ceres::IterationSummary& iteration, int rows) {
  if (iteration.step_is_successful) {
    best_ = progress_.theta;
    best_cost_ = iteration.cost;
    at_best_ = newest_.IsAt(best_) ? newest_ : Linearisation{};
  }
  if (iteration.step_is_successful && callbacks_.checkpoint) {
    FitCheckpoint checkpoint = progress_;
    if (first_offsets_.size() > 0) checkpoint.theta(offsets_) = first_offsets_;
    callbacks_.checkpoint(checkpoint);
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

ceres::Solver::Summary Fitter::Minimise(WindowSimulator* simulator, const WindowStart& start,
                                        int first, int last, const Patience& patience,
                                        const Eigen::MatrixXd& prior, const Eigen::VectorXd& offset,
                                        const std::vector<int>& held) {
  const bool is_whole = simulator == &simulator_ && held.empty() && start.frame == 0 &&
                        first == 0 && last == scene_.last_fitted_frame;
  newest_ = {};
  if (!is_whole) at_best_ = {};
  Linearisation window;
  const auto evaluate = [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    if (jacobian != nullptr && at_best_.IsAt(at)) {
      window = at_best_;
    } else {
      const Outcome outcome =
          EvaluateWindow(simulator, observations_, start, at, first, last, WindowRows::kCompressed,
                         &window.residuals, jacobian != nullptr ? &window.jacobian : nullptr);
      if (outcome != Outcome::kComplete) return false;
      window.theta = at;
      window.steps = simulator->last_report();
    }
    residuals->resize(window.residuals.size() + prior.rows());
    *residuals << window.residuals, prior * at - offset;
    if (jacobian == nullptr) return true;
    jacobian->resize(residuals->size(), free_.size());
    *jacobian << window.jacobian, prior;
    if (is_whole) newest_ = window;
    return true;
  };
  const int rows = observations_.NumObserved(first, last);
  simulator->Hold(held);
  constexpr double kRadiusNear = 10.0;  // of a minimum
  const double first_radius = is_near_ ? kRadiusNear : kCautiousRadius;
  const bool goes_on = is_whole && radius_ > 0.0;
  ceres::Solver::Options options = LevenbergMarquardtOptions(
      patience.iterations, patience.tolerance, goes_on ? radius_ : first_radius);
  options.update_state_every_iteration = true;
  IterationReporter reporter([&](const ceres::IterationSummary& s) { Report(s, rows); },
                             callbacks_.stop);
  options.callbacks.push_back(&reporter);
  best_ = progress_.theta;
  const int count = free_.size() + 1 + static_cast<int>(prior.rows());
  const ceres::Solver::Summary summary = MinimiseWithin({free_.lower(), free_.upper(), held}, count,
                                                        evaluate, options, &progress_.theta);
  simulator->Hold({});
  progress_.theta = best_;  // Ceres takes back what it had reached when an evaluation fails
  iterations_ += NumIterations(summary);
  Log(fmt::format("{}: cost {:.6g} -> {:.6g}, {} iterations, {}", stage_, summary.initial_cost,
                  summary.final_cost, summary.iterations.size(), summary.message));
  return summary;
}

void Fitter::Marginalise(const std::vector<int>& entries) {
  std::vector<int> others;
  for (int i = 0; i < free_.size(); ++i) {
    if (std::find(entries.begin(), entries.end(), i) == entries.end()) others.push_back(i);
  }
  std::vector<int> order = entries;
  order.insert(order.end(), others.begin(), others.end());
  const auto left = static_cast<Eigen::Index>(others.size());
  // What remains of the others where the entries are free: the Schur complement's factor.
  const Eigen::MatrixXd root =
      TriangularRoot(progress_.information(Eigen::all, order)).bottomRightCorner(left, left);
  progress_.information.setZero();
  progress_.information(others, others) = root;
  for (const int i : entries) {
    progress_.information(i, i) = 1.0 / free_.entries()[i].prior_sigma;
    progress_.mean[i] = free_.entries()[i].prior;
  }
}

void Fitter::FreeWindowStart(WindowStart* start) {
  if (offsets_.empty()) return;
  if (first_offsets_.size() == 0) first_offsets_ = progress_.theta(offsets_);
  Marginalise(offsets_);
  Eigen::MatrixXd dx, dv;
  free_.InitialDirections(&dx, &dv);
  for (const int i : offsets_) {
    progress_.theta[i] = start->theta[i] = free_.entries()[i].prior;
    start->sensitivity.ReplaceDirection(i, dx.col(i), dv.col(i), start->state.previous_step);
  }
}

void Fitter::CutRunawayTies(WindowStart* start) const {
  const double largest = 0.1 * scene_.recording.cloth.size.norm();  // m, within the uncertainty
  // Rows of R^-1, whose squares add up to the variances.
  const Eigen::MatrixXd inverse = progress_.information.triangularView<Eigen::Upper>().solve(
      Eigen::MatrixXd::Identity(free_.size(), free_.size()));
  const Eigen::MatrixXd dx = start->sensitivity.x();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(dx.rows());
  for (int i = 0; i < free_.size(); ++i) {
    const double moved = dx.col(i).lpNorm<Eigen::Infinity>() * inverse.row(i).norm();
    if (moved < largest) continue;
    start->sensitivity.ReplaceDirection(i, none, none, start->state.previous_step);
    Log(fmt::format("{}: its end follows {} too wildly to be handed on as more than a state",
                    stage_, free_.entries()[i].name));
  }
}

bool Fitter::RunWindow(int window, WindowStart* start) {
  const int last = std::min(start->frame + window_frames_, scene_.last_fitted_frame);
  const int first = window == 0 ? 0 : start->frame + 1;
  if (window > 0) FreeWindowStart(start);
  stage_ = fmt::format("window {} of {} (frames {}-{})", window + 1, num_windows_, first, last);
  if (observations_.Count(first, last) > 0) {
    // Before a polish the windows only have to come near.
    constexpr int kIterationsToComeNear = 6;
    const int most = config_.polish ? std::min(kIterationsToComeNear, config_.max_iterations)
                                    : config_.max_iterations;
    Minimise(&attracting_, *start, first, last, {most, config_.function_tolerance},
             progress_.information, progress_.information * progress_.mean);
  }
  if (Stopped()) return false;
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
  WindowStart end;
  if (EvaluateWindow(&attracting_, observations_, *start, progress_.theta, first, last,
                     WindowRows::kCompressed, &residuals, &jacobian, &end) != Outcome::kComplete) {
    Log(stage_ + ": the simulation does not reach the end of the window; the windows end here");
    return false;
  }
  // What this window knows of theta, at the size that its residuals really have.
  const double noise2 = std::max(
      1.0, residuals.squaredNorm() / std::max<double>(1.0, observations_.NumObserved(first, last)));
  Eigen::MatrixXd known(jacobian.rows() + free_.size(), free_.size());
  known << jacobian / std::sqrt(noise2), progress_.information;
  progress_.information = TriangularRoot(known);
  progress_.mean = progress_.theta;
  progress_.next_window = window + 1;
  std::string values;
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    if (entry.kind != FreeEntry::Kind::kParameter) continue;
    values += fmt::format(" {} {:.4g}", entry.name, free_.UnitValue(i, progress_.theta[i]));
  }
  Log(stage_ + " hands on:" + values);
  *start = std::move(end);
  CutRunawayTies(start);
  return true;
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
    const WindowStart start = simulator_.FirstStart(progress_.theta);
    Minimise(&simulator_, start, 0, last, kPatience, free_.prior_jacobian(),
             -free_.PriorResiduals(Eigen::VectorXd::Zero(free_.size())),
             ControlsLongBefore(fitted));
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

void Fitter::RunWindows() {
  WindowStart start = attracting_.FirstStart(progress_.mean);
  const double total = scene_.last_fitted_frame * (config_.polish ? 2.5 : 1.0);
  if (progress_.next_window > 0) {  // resumed: back to where the windows had come
    Eigen::VectorXd residuals;
    WindowStart end;
    const int frame = std::min(progress_.next_window * window_frames_, scene_.last_fitted_frame);
    if (EvaluateWindow(&attracting_, observations_, start, progress_.mean, 0, frame,
                       WindowRows::kCompressed, &residuals, nullptr, &end) != Outcome::kComplete) {
      return;
    }
    start = std::move(end);
  }
  for (int w = progress_.next_window; w < num_windows_ && !Stopped(); ++w) {
    stage_begin_ = w * window_frames_ / total;
    stage_share_ = window_frames_ / total;
    if (!RunWindow(w, &start)) break;
  }
  if (first_offsets_.size() > 0) progress_.theta(offsets_) = first_offsets_;
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
  stage_begin_ = 1.0 - (stage_share_ = num_windows_ > 1 ? 0.6 : 1.0);
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
  if (of_polish_ >= most_iterations) return;
  const WindowStart start = simulator_.FirstStart(progress_.theta);
  const ceres::Solver::Summary summary =
      Minimise(&simulator_, start, 0, scene_.last_fitted_frame,
               {most_iterations - of_polish_, polish_tolerance_}, free_.prior_jacobian(),
               -free_.PriorResiduals(Eigen::VectorXd::Zero(free_.size())));
  converged_ = summary.termination_type == ceres::CONVERGENCE;
  cost_ = best_cost_;
  of_polish_ += NumIterations(summary);
  if (!summary.iterations.empty()) radius_ = summary.iterations.back().trust_region_radius;
}

bool Fitter::HasWork() const {
  return free_.size() > 0 && observations_.Count(0, scene_.last_fitted_frame) > 0;
}

void Fitter::ToStart() {
  progress_.theta = free_.start();
  progress_.information = free_.PriorInformation();
  progress_.mean = free_.PriorMean();
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
  const bool in_windows = num_windows_ > 1 || !config_.polish || config_.attract;
  if (resume == nullptr) FindHandlePaths();
  if (in_windows && progress_.next_window < num_windows_) RunWindows();
  if (!config_.polish) converged_ = progress_.next_window == num_windows_;
}

FitResult Fitter::End() {
  FitResult result;
  Finish(&result);
  return result;
}

}  // namespace clothfit
