// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The fit: windows that hand state and information on, then all frames at once.
#include "fitting/fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>
#include <fmt/format.h>

#include "fitting/evaluation.h"
#include "fitting/uncertainty.h"
#include "fitting/window_cost.h"

namespace clothfit {
namespace {

using Outcome = WindowSimulator::Outcome;

class Fitter {
 public:
  Fitter(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks)
      : scene_(scene),
        config_(config),
        callbacks_(callbacks),
        free_(config, scene, MakeParameterTable()),
        observations_(scene, config),
        simulator_(scene, config, free_, false, callbacks.stop),
        attracting_(scene, config, free_, config.attract, callbacks.stop) {
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

  FitResult Run(const FitCheckpoint* resume);
  // Where a fit stands whose windows ended at this free vector.
  FitCheckpoint AfterWindows(const Eigen::VectorXd& theta) const {
    return {false, num_windows_, theta, free_.PriorInformation(), free_.PriorMean()};
  }

 private:
  // Levenberg-Marquardt on one window and what is known besides. Returns Ceres' summary.
  ceres::Solver::Summary Minimise(WindowSimulator* simulator, const WindowStart& start, int first,
                                  int last, int max_iterations, const Eigen::MatrixXd& prior,
                                  const Eigen::VectorXd& offset);
  void RunWindows();
  bool RunWindow(int window, WindowStart* start);
  // Frees the state at a later window's start: the offsets of the initial state now are offsets
  // there.
  void FreeWindowStart(WindowStart* start);
  // Cuts the ties of a window's start to what moves it so much that a linear tie means nothing.
  void CutRunawayTies(WindowStart* start) const;
  // What is known of everything but these entries, with the entries themselves back at their
  // priors.
  void Marginalise(const std::vector<int>& entries);
  void Polish();
  double Cost(const Eigen::VectorXd& theta, WindowSimulator* simulator) const;
  void Log(const std::string& line) const {
    if (callbacks_.log) callbacks_.log(line);
  }
  bool Stopped() const { return callbacks_.stop != nullptr && *callbacks_.stop; }
  void Report(const ceres::IterationSummary& iteration, int rows);
  // By how much of the cost a full Gauss-Newton step from here would lower it, were the problem
  // linear: near 0 at a minimum, also where Levenberg-Marquardt's own small steps have come to
  // rest.
  double ExpectedDecrease(const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian) const;
  void Finish(FitResult* result);
  void FillEstimates(const Uncertainty& uncertainty, FitResult* result) const;

  const Scene& scene_;
  const FitConfig& config_;
  const FitCallbacks& callbacks_;
  FreeParameters free_;
  ObservationResiduals observations_;
  WindowSimulator simulator_, attracting_;
  int window_frames_ = 0, num_windows_ = 0;
  FitCheckpoint progress_;
  std::vector<int> offsets_;       // entries of the free vector that offset a state
  Eigen::VectorXd best_;           // of the stage under way
  Eigen::VectorXd first_offsets_;  // their values at the recording's start
  std::string stage_;
  double stage_begin_ = 0.0, stage_share_ = 0.0;  // of the whole fit's work
  int iterations_ = 0;
  bool converged_ = false;
  double noise_ = 1.0;
};

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

void Fitter::Report(const ceres::IterationSummary& iteration, int rows) {
  if (iteration.step_is_successful) best_ = progress_.theta;
  if (iteration.step_is_successful && callbacks_.checkpoint) {
    FitCheckpoint checkpoint = progress_;
    if (first_offsets_.size() > 0) checkpoint.theta(offsets_) = first_offsets_;
    callbacks_.checkpoint(checkpoint);
  }
  if (!callbacks_.progress) return;
  FitProgress progress;
  progress.stage = stage_;
  progress.iteration = iteration.iteration;
  progress.cost = iteration.cost;
  progress.rms = std::sqrt(2.0 * iteration.cost / std::max(1, rows));
  constexpr double kExpectedIterations = 8.0;
  progress.fraction =
      stage_begin_ + stage_share_ * std::min(1.0, iteration.iteration / kExpectedIterations);
  progress.simulated_frames = simulator_.simulated_frames() + attracting_.simulated_frames();
  callbacks_.progress(progress);
}

ceres::Solver::Summary Fitter::Minimise(WindowSimulator* simulator, const WindowStart& start,
                                        int first, int last, int max_iterations,
                                        const Eigen::MatrixXd& prior,
                                        const Eigen::VectorXd& offset) {
  ceres::Problem problem;
  double* theta = progress_.theta.data();
  ceres::CostFunction* cost =
      MakeWindowCost(simulator, &observations_, &start, free_.size(), first, last);
  const int rows = cost->num_residuals();
  problem.AddResidualBlock(cost, nullptr, theta);
  problem.AddResidualBlock(new LinearCost(prior, offset), nullptr, theta);
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    if (std::isfinite(entry.lower)) problem.SetParameterLowerBound(theta, i, entry.lower);
    if (std::isfinite(entry.upper)) problem.SetParameterUpperBound(theta, i, entry.upper);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = config_.function_tolerance;
  options.parameter_tolerance = 1e-7;
  options.initial_trust_region_radius = 1.0;       // half a Gauss-Newton step: the cost is rugged
  options.max_num_consecutive_invalid_steps = 20;  // a trial whose simulation diverges
  options.logging_type = ceres::SILENT;
  options.update_state_every_iteration = true;
  IterationReporter reporter([&](const ceres::IterationSummary& s) { Report(s, rows); },
                             callbacks_.stop);
  options.callbacks.push_back(&reporter);
  ceres::Solver::Summary summary;
  best_ = progress_.theta;
  ceres::Solve(options, &problem, &summary);
  progress_.theta = best_;  // Ceres takes back what it had reached when an evaluation fails
  iterations_ += std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  Log(fmt::format("{}: cost {:.6g} -> {:.6g}, {} iterations, {}", stage_, summary.initial_cost,
                  summary.final_cost, summary.iterations.size(), summary.message));
  return summary;
}

void Fitter::Marginalise(const std::vector<int>& entries) {
  std::vector<int> others;
  for (int i = 0; i < free_.size(); ++i) {
    if (std::find(entries.begin(), entries.end(), i) == entries.end()) others.push_back(i);
  }
  const Eigen::MatrixXd all = progress_.information.transpose() * progress_.information;
  const Eigen::MatrixXd cross = all(others, entries);
  const Eigen::MatrixXd own = all(entries, entries);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(free_.size(), free_.size());
  information(others, others) =
      all(others, others) - cross * own.llt().solve(cross.transpose());  // Schur complement
  for (const int i : entries) {
    const double sigma = free_.entries()[i].prior_sigma;
    information(i, i) = 1.0 / (sigma * sigma);
    progress_.mean[i] = free_.entries()[i].prior;
  }
  progress_.information = information.llt().matrixU();
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
  const Eigen::MatrixXd inverse = (progress_.information.transpose() * progress_.information)
                                      .ldlt()
                                      .solve(Eigen::MatrixXd::Identity(free_.size(), free_.size()));
  const Eigen::MatrixXd dx = start->sensitivity.x();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(dx.rows());
  for (int i = 0; i < free_.size(); ++i) {
    const double moved = dx.col(i).lpNorm<Eigen::Infinity>() * std::sqrt(inverse(i, i));
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
    Minimise(&attracting_, *start, first, last, most, progress_.information,
             progress_.information * progress_.mean);
  }
  if (Stopped()) return false;
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
  WindowStart end;
  if (EvaluateWindow(&attracting_, observations_, *start, progress_.theta, first, last, &residuals,
                     &jacobian, &end) != Outcome::kComplete) {
    Log(stage_ + ": the simulation does not reach the end of the window; the windows end here");
    return false;
  }
  // What this window knows of theta, at the size that its residuals really have.
  const double noise2 = std::max(
      1.0, residuals.squaredNorm() / std::max<double>(1.0, static_cast<double>(residuals.size())));
  const Eigen::MatrixXd information = jacobian.transpose() * jacobian / noise2 +
                                      progress_.information.transpose() * progress_.information;
  progress_.information = information.llt().matrixU();
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

void Fitter::RunWindows() {
  WindowStart start = attracting_.FirstStart(progress_.mean);
  const double total = scene_.last_fitted_frame * (config_.polish ? 2.5 : 1.0);
  if (progress_.next_window > 0) {  // resumed: back to where the windows had come
    Eigen::VectorXd residuals;
    WindowStart end;
    const int frame = std::min(progress_.next_window * window_frames_, scene_.last_fitted_frame);
    if (EvaluateWindow(&attracting_, observations_, start, progress_.mean, 0, frame, &residuals,
                       nullptr, &end) != Outcome::kComplete) {
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
                     &residuals, nullptr) != Outcome::kComplete) {
    return std::numeric_limits<double>::infinity();
  }
  return 0.5 * (residuals.squaredNorm() + free_.PriorResiduals(theta).squaredNorm());
}

void Fitter::Polish() {
  stage_ = fmt::format("all frames (0-{})", scene_.last_fitted_frame);
  stage_begin_ = 1.0 - (stage_share_ = num_windows_ > 1 ? 0.6 : 1.0);
  const Eigen::VectorXd reached = progress_.theta;
  const double at_reached = Cost(reached, &simulator_);
  const double at_start = Cost(free_.start(), &simulator_);
  if (at_start < at_reached) {
    Log("the windows' result explains all frames worse than the start does; going on from the "
        "start");
    progress_.theta = free_.start();
  }
  const WindowStart start = simulator_.FirstStart(progress_.theta);
  const ceres::Solver::Summary summary =
      Minimise(&simulator_, start, 0, scene_.last_fitted_frame, config_.max_iterations,
               free_.prior_jacobian(), -free_.PriorResiduals(Eigen::VectorXd::Zero(free_.size())));
  converged_ = summary.termination_type == ceres::CONVERGENCE;
}

FitResult Fitter::Run(const FitCheckpoint* resume) {
  const auto begin = std::chrono::steady_clock::now();
  FitResult result;
  progress_.theta = free_.start();
  progress_.information = free_.PriorInformation();
  progress_.mean = free_.PriorMean();
  result.before = EvaluateScene(scene_, config_, free_, free_.start());
  WindowSimulator unstopped(scene_, config_, free_, false, nullptr);
  result.cost_before = Cost(free_.start(), &unstopped);
  if (resume != nullptr) progress_ = *resume;
  if (free_.size() > 0 && (scene_.markers.size() + scene_.tracks.size()) > 0) {
    const bool in_windows = num_windows_ > 1 || !config_.polish || config_.attract;
    if (in_windows && progress_.next_window < num_windows_) RunWindows();
    if (config_.polish && !Stopped()) Polish();
    if (!config_.polish) converged_ = progress_.next_window == num_windows_;
  } else {
    converged_ = true;
  }
  Finish(&result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

double Fitter::ExpectedDecrease(const Eigen::VectorXd& residuals,
                                const RowMajorMatrix& jacobian) const {
  const Eigen::VectorXd prior = free_.PriorResiduals(progress_.theta);
  const Eigen::MatrixXd& prior_jacobian = free_.prior_jacobian();
  const Eigen::VectorXd gradient =
      jacobian.transpose() * residuals + prior_jacobian.transpose() * prior;
  const Eigen::MatrixXd information =
      jacobian.transpose() * jacobian + prior_jacobian.transpose() * prior_jacobian;
  std::vector<int> inner;  // entries that may follow their gradient
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    const bool held = gradient[i] > 0.0 ? progress_.theta[i] <= entry.lower + 1e-9
                                        : progress_.theta[i] >= entry.upper - 1e-9;
    if (!held) inner.push_back(i);
  }
  if (inner.empty()) return 0.0;
  const Eigen::VectorXd g = gradient(inner);
  const Eigen::MatrixXd h = information(inner, inner);
  const double cost = 0.5 * (residuals.squaredNorm() + prior.squaredNorm());
  return 0.5 * g.dot(h.ldlt().solve(g)) / std::max(cost, 1e-300);
}

void Fitter::Finish(FitResult* result) {
  result->theta = progress_.theta;
  result->parameters = free_.Values(result->theta);
  result->iterations = iterations_;
  // What follows is short and must be done even after an interruption.
  WindowSimulator simulator(scene_, config_, free_, false, nullptr);
  const WindowStart start = simulator.FirstStart(result->theta);
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
  const Outcome outcome = EvaluateWindow(&simulator, observations_, start, result->theta, 0,
                                         scene_.last_fitted_frame, &residuals, &jacobian);
  result->steps = simulator.last_report();
  Uncertainty uncertainty;
  if (outcome == Outcome::kComplete) {
    result->cost_after =
        0.5 * (residuals.squaredNorm() + free_.PriorResiduals(result->theta).squaredNorm());
    uncertainty = QuantifyUncertainty(free_, residuals, jacobian);
    constexpr double kConvergedDecrease = 0.01;
    const double decrease = ExpectedDecrease(residuals, jacobian);
    if (converged_ && config_.polish && decrease > kConvergedDecrease) {
      converged_ = false;
      Log(
          fmt::format("Levenberg-Marquardt came to rest where a full step promises {:.0f} % less "
                      "cost: the cost is rugged here; shorter windows may get past it",
                      100.0 * decrease));
    }
  } else {
    result->cost_after = std::numeric_limits<double>::infinity();
    uncertainty.sigma = uncertainty.lower95 = uncertainty.upper95 =
        Eigen::VectorXd::Constant(free_.size(), std::numeric_limits<double>::quiet_NaN());
    uncertainty.determined.assign(static_cast<std::size_t>(free_.size()), false);
    uncertainty.statements.push_back(
        "the open-loop simulation of all fitted frames diverges at the result");
  }
  result->noise_factor = uncertainty.noise_factor;
  result->statements = uncertainty.statements;
  FillEstimates(uncertainty, result);
  result->after = EvaluateScene(scene_, config_, free_, result->theta);
  result->simulated_frames =
      simulator_.simulated_frames() + attracting_.simulated_frames() + simulator.simulated_frames();
  result->simulations =
      static_cast<int>(std::ceil(result->simulated_frames / std::max(1, scene_.last_fitted_frame)));
  result->status = Stopped()                            ? FitStatus::kInterrupted
                   : !std::isfinite(result->cost_after) ? FitStatus::kFailed
                   : converged_                         ? FitStatus::kConverged
                                                        : FitStatus::kNotConverged;
}

void Fitter::FillEstimates(const Uncertainty& uncertainty, FitResult* result) const {
  const std::vector<NamedParameter> table = MakeParameterTable();
  const Eigen::VectorXd start_values = free_.Values(free_.start());
  std::vector<ParameterEstimate> others;
  for (std::size_t i = 0; i < table.size(); ++i) {
    ParameterEstimate estimate;
    estimate.name = table[i].name;
    estimate.unit = table[i].parameter.unit;
    estimate.value = estimate.lower95 = estimate.upper95 =
        result->parameters[static_cast<Eigen::Index>(i)];
    estimate.start = start_values[static_cast<Eigen::Index>(i)];
    result->estimates.push_back(estimate);
  }
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    const bool physical = entry.kind == FreeEntry::Kind::kParameter;
    ParameterEstimate& estimate = physical ? result->estimates[entry.index] : others.emplace_back();
    const double theta = result->theta[i];
    estimate.name = entry.name;
    estimate.unit = entry.unit;
    estimate.free = true;
    estimate.value = free_.UnitValue(i, theta);
    estimate.start = free_.UnitValue(i, free_.start()[i]);
    estimate.lower95 = free_.UnitValue(i, theta + uncertainty.lower95[i]);
    estimate.upper95 = free_.UnitValue(i, theta + uncertainty.upper95[i]);
    estimate.determined = uncertainty.determined[i];
    const double margin = 1e-6 * (entry.upper - entry.lower);
    estimate.at_bound =
        std::isfinite(margin) && (theta <= entry.lower + margin || theta >= entry.upper - margin);
  }
  result->estimates.insert(result->estimates.end(), others.begin(), others.end());
}

// The config of a fit with a coarser grid, where that is worth while: its iterations cost little,
// and stiffness and damping are the material's, not the mesh's.
std::optional<FitConfig> Coarser(const Scene& scene, const FitConfig& config) {
  const std::array<int, 2> grid = scene.mesh.grid;
  const int longer = std::max(grid[0], grid[1]), coarse = config.coarse_resolution;
  if (!scene.mesh.is_grid() || coarse < 2 || 3 * coarse > 2 * longer || !config.polish) {
    return std::nullopt;
  }
  FitConfig coarser = config;
  for (int k = 0; k < 2; ++k) {
    const double share = static_cast<double>(grid[k] - 1) / (longer - 1);
    coarser.resolution[k] = 1 + std::max(1, static_cast<int>(std::lround(share * (coarse - 1))));
  }
  return coarser;
}

constexpr double kShareOfCoarseFit = 0.3;  // of the time, a guess

FitCallbacks OfCoarseFit(const FitCallbacks& callbacks, const ClothMesh& mesh) {
  FitCallbacks own = callbacks;
  const std::string prefix = fmt::format("{} x {} particles, ", mesh.grid[0], mesh.grid[1]);
  if (callbacks.progress) {
    own.progress = [&callbacks, prefix](FitProgress progress) {
      progress.stage = prefix + progress.stage;
      progress.fraction *= kShareOfCoarseFit;
      callbacks.progress(progress);
    };
  }
  if (callbacks.checkpoint) {
    own.checkpoint = [&callbacks](FitCheckpoint checkpoint) {
      checkpoint.coarse = true;
      callbacks.checkpoint(checkpoint);
    };
  }
  if (callbacks.log) {
    own.log = [&callbacks, prefix](const std::string& line) { callbacks.log(prefix + line); };
  }
  return own;
}

FitCallbacks OfFineFit(const FitCallbacks& callbacks) {
  FitCallbacks own = callbacks;
  if (callbacks.progress) {
    own.progress = [&callbacks](FitProgress progress) {
      progress.fraction = kShareOfCoarseFit + (1.0 - kShareOfCoarseFit) * progress.fraction;
      callbacks.progress(progress);
    };
  }
  return own;
}

}  // namespace

std::string ToString(FitStatus status) {
  switch (status) {
    case FitStatus::kConverged:
      return "converged";
    case FitStatus::kNotConverged:
      return "not converged";
    case FitStatus::kInterrupted:
      return "interrupted";
    case FitStatus::kFailed:
      return "failed";
  }
  return "unknown";
}

FitResult RunFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks,
                 const FitCheckpoint* resume) {
  const std::optional<FitConfig> coarser = Coarser(scene, config);
  if (!coarser || (resume != nullptr && !resume->coarse)) {
    return Fitter(scene, config, callbacks).Run(resume);
  }
  const Scene coarse_scene = MakeScene(scene.recording, *coarser);
  const FitCallbacks coarse_callbacks = OfCoarseFit(callbacks, coarse_scene.mesh);
  const FitResult coarse = Fitter(coarse_scene, *coarser, coarse_callbacks).Run(resume);
  const FitCallbacks fine_callbacks = OfFineFit(callbacks);
  Fitter fine(scene, config, fine_callbacks);
  const FitCheckpoint reached = fine.AfterWindows(coarse.theta);
  FitResult result = fine.Run(&reached);
  result.iterations += coarse.iterations;
  result.simulations += coarse.simulations;
  result.simulated_frames += coarse.simulated_frames;
  result.seconds += coarse.seconds;
  return result;
}

int SimulateFrames(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                   const Eigen::VectorXd& theta, int last_frame,
                   const std::function<void(int frame, const State& state)>& observer,
                   StepReport* steps) {
  WindowSimulator simulator(scene, config, free, false, nullptr);
  int frames = 0;
  simulator.Run(simulator.FirstStart(theta), theta, last_frame, false,
                [&](int frame, const State& state, const Sensitivity*) {
                  observer(frame, state);
                  ++frames;
                });
  if (steps != nullptr) *steps = simulator.last_report();
  return frames;
}

}  // namespace clothfit
