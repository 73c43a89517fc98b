// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/shooting_windows.h"

#include <algorithm>
#include <utility>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/nudging.h"

namespace clothfit {
namespace {

using Outcome = WindowSimulator::Outcome;

// The config with these values of its physical parameters.
FitConfig WithValues(FitConfig config, const Eigen::VectorXd& values) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto setting = config.parameters.find(table[i].name);
    if (setting != config.parameters.end())
      setting->second.value = values[static_cast<Eigen::Index>(i)];
  }
  return config;
}

}  // namespace

bool FitsWindows(const Scene& scene, const FitConfig& config) {
  return config.window > 0.0 && config.beta > 0.0 && !config.attract && HasPoints(scene);
}

ShootingWindows::ShootingWindows(const Scene& scene, const FitConfig& config,
                                 const FreeParameters& free, const std::atomic<bool>* stop)
    : scene_(scene), config_(config), free_(free), stop_(stop) {
  for (int worker = 0; worker < NumThreads(0); ++worker)
    simulators_.push_back(std::make_unique<WindowSimulator>(scene, config, free, false, stop));
}

bool ShootingWindows::Lay(const Eigen::VectorXd& theta, int frames) {
  constexpr double kTimesAsFast = 10.0;  // as a window is long
  const double rate = kTimesAsFast * scene_.recording.frame_rate / frames;
  const double share = std::min(1.0, rate * rate / (kNudgingRate * kNudgingRate));
  const std::optional<FitConfig> nudged =
      NudgedConfig(WithValues(config_, free_.Values(theta)), scene_, share, kScoringDamping);
  if (!nudged) return false;
  const FreeParameters free(*nudged, scene_, MakeParameterTable());
  WindowSimulator simulator(scene_, *nudged, free, true, stop_);
  std::vector<State> states;
  const Outcome outcome =
      simulator.Run(simulator.FirstStart(theta), theta, scene_.last_fitted_frame, false,
                    [&](int, const State& state, const Sensitivity*) { states.push_back(state); });
  nudged_frames_ += simulator.simulated_frames();
  if (outcome != Outcome::kComplete) return false;
  windows_.clear();
  const Eigen::MatrixXd directions = free_.ValueDirections(theta);
  for (int first = 0; first < scene_.last_fitted_frame; first += frames) {
    Window window;
    window.first_row_frame = first == 0 ? 0 : first + 1;
    window.last = std::min(first + frames, scene_.last_fitted_frame);
    State& state = states[static_cast<std::size_t>(first)];
    if (first > 0) window.start = {first, state, Sensitivity(state, directions), theta};
    windows_.push_back(std::move(window));
  }
  return true;
}

bool ShootingWindows::Evaluate(const ObservationResiduals& observations,
                               const Eigen::VectorXd& theta, Eigen::VectorXd* residuals,
                               RowMajorMatrix* jacobian) {
  const Eigen::Index rows = free_.size() + 1;
  residuals->setZero(NumResiduals());
  if (jacobian != nullptr) jacobian->setZero(NumResiduals(), free_.size());
  std::atomic<bool> is_complete = true;
  const int workers = static_cast<int>(simulators_.size());
  ParallelFor(size(), workers, [&](int i, int worker) {
    if (!is_complete) return;
    Window& window = windows_[static_cast<std::size_t>(i)];
    WindowSimulator& simulator = *simulators_[static_cast<std::size_t>(worker)];
    if (i == 0) window.start = simulator.FirstStart(theta);
    Eigen::VectorXd of_window;
    RowMajorMatrix columns;
    simulator.SwapMotion(&window.motion);
    const Outcome outcome = EvaluateWindow(
        &simulator, observations, window.start, theta, window.first_row_frame, window.last,
        WindowRows::kCompressed, &of_window, jacobian != nullptr ? &columns : nullptr);
    simulator.SwapMotion(&window.motion);
    if (outcome != Outcome::kComplete) {
      is_complete = false;
      return;
    }
    residuals->segment(i * rows, rows) = of_window;
    if (jacobian != nullptr) jacobian->middleRows(i * rows, rows) = columns;
  });
  return is_complete;
}

double ShootingWindows::simulated_frames() const {
  double frames = nudged_frames_;
  for (const auto& simulator : simulators_) frames += simulator->simulated_frames();
  return frames;
}

double ShootingWindows::differentiated_frames() const {
  double frames = 0.0;
  for (const auto& simulator : simulators_) frames += simulator->differentiated_frames();
  return frames;
}

}  // namespace clothfit
