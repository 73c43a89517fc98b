// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/shooting_windows.h"

#include <algorithm>
#include <cmath>
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
  // Where a handle goes is told by markers beside it, but not by a cloud.
  const bool by_clouds =
      scene.clouds && std::all_of(scene.handles.begin(), scene.handles.end(),
                                  [](const SceneHandle& h) { return h.path.is_known(); });
  return config.window > 0.0 && config.beta > 0.0 && !config.attract &&
         (HasPoints(scene) || by_clouds);
}

std::vector<int> WindowLengths(const Scene& scene, const FitConfig& config) {
  std::vector<int> lengths;
  if (!FitsWindows(scene, config)) return lengths;
  const double frames = config.window * scene.recording.frame_rate;
  int length = std::max(2, static_cast<int>(std::lround(frames)));
  for (; 4 * length < 3 * scene.last_fitted_frame; length *= 2) lengths.push_back(length);
  return lengths;
}

ShootingWindows::ShootingWindows(const Scene& scene, const FitConfig& config,
                                 const FreeParameters& free, const std::atomic<bool>* stop)
    : scene_(scene), config_(config), free_(free), stop_(stop) {
  for (int worker = 0; worker < NumThreads(0); ++worker)
    simulators_.push_back(std::make_unique<WindowSimulator>(scene, config, free, false, stop));
}

std::vector<LaidWindow> LayWindows(const Scene& scene, const FitConfig& config,
                                   const FreeParameters& free, const Eigen::VectorXd& theta,
                                   int frames, const std::atomic<bool>* stop,
                                   double* simulated_frames) {
  constexpr double kTimesAsFast = 10.0;  // as a window is long
  const double rate = kTimesAsFast * scene.recording.frame_rate / frames;
  const double share = std::min(1.0, rate * rate / (kNudgingRate * kNudgingRate));
  const std::optional<FitConfig> nudged =
      NudgedConfig(WithValues(config, free.Values(theta)), scene, share, kScoringDamping);
  if (!nudged) return {};
  const FreeParameters of_nudged(*nudged, scene, MakeParameterTable());
  WindowSimulator simulator(scene, *nudged, of_nudged, true, stop);
  std::vector<State> states;
  const Outcome outcome =
      simulator.Run(simulator.FirstStart(theta), theta, scene.last_fitted_frame, false,
                    [&](int, const State& state, const Sensitivity*) { states.push_back(state); });
  *simulated_frames += simulator.simulated_frames();
  if (outcome != Outcome::kComplete) return {};
  std::vector<LaidWindow> windows;
  for (int first = 0; first < scene.last_fitted_frame; first += frames) {
    windows.push_back({first, first == 0 ? 0 : first + 1,
                       std::min(first + frames, scene.last_fitted_frame),
                       std::move(states[static_cast<std::size_t>(first)])});
  }
  return windows;
}

bool ShootingWindows::Lay(const Eigen::VectorXd& theta, int frames) {
  std::vector<LaidWindow> laid =
      LayWindows(scene_, config_, free_, theta, frames, stop_, &nudged_frames_);
  windows_.clear();
  const Eigen::MatrixXd directions = free_.ValueDirections(theta);
  for (LaidWindow& one : laid) {
    Window window;
    if (one.first_frame > 0)
      window.start = {one.first_frame, one.state, Sensitivity(one.state, directions), theta};
    window.laid = std::move(one);
    windows_.push_back(std::move(window));
  }
  return !windows_.empty();
}

bool ShootingWindows::EvaluateAll(
    const ObservationResiduals& observations, const Eigen::VectorXd& theta, WindowRows kind,
    bool derivatives,
    const std::function<void(int, const Eigen::VectorXd&, const RowMajorMatrix&)>& rows) {
  std::atomic<bool> is_complete = true;
  const int workers = static_cast<int>(simulators_.size());
  ParallelFor(size(), workers, [&](int i, int worker) {
    if (!is_complete) return;
    Window& window = windows_[static_cast<std::size_t>(i)];
    WindowSimulator& simulator = *simulators_[static_cast<std::size_t>(worker)];
    if (i == 0) window.start = simulator.FirstStart(theta);
    Eigen::VectorXd residuals;
    RowMajorMatrix jacobian;
    simulator.SwapMotion(&window.motion);
    const Outcome outcome =
        EvaluateWindow(&simulator, observations, window.start, theta, window.laid.first_row_frame,
                       window.laid.last, kind, &residuals, derivatives ? &jacobian : nullptr);
    simulator.SwapMotion(&window.motion);
    if (outcome == Outcome::kComplete) {
      rows(i, residuals, jacobian);
    } else {
      is_complete = false;
    }
  });
  return is_complete;
}

bool ShootingWindows::Evaluate(const ObservationResiduals& observations,
                               const Eigen::VectorXd& theta, Eigen::VectorXd* residuals,
                               RowMajorMatrix* jacobian) {
  const Eigen::Index rows = free_.size() + 1;
  residuals->setZero(NumResiduals());
  if (jacobian != nullptr) jacobian->setZero(NumResiduals(), free_.size());
  return EvaluateAll(observations, theta, WindowRows::kCompressed, jacobian != nullptr,
                     [&](int i, const Eigen::VectorXd& of_window, const RowMajorMatrix& columns) {
                       residuals->segment(i * rows, rows) = of_window;
                       if (jacobian != nullptr) jacobian->middleRows(i * rows, rows) = columns;
                     });
}

Eigen::VectorXd ShootingWindows::Residuals(const ObservationResiduals& observations,
                                           const Eigen::VectorXd& theta) {
  std::vector<Eigen::VectorXd> of_windows(windows_.size());
  const bool is_complete =
      EvaluateAll(observations, theta, WindowRows::kAll, false,
                  [&](int i, const Eigen::VectorXd& rows, const RowMajorMatrix&) {
                    of_windows[static_cast<std::size_t>(i)] = rows;
                  });
  if (!is_complete) return {};
  Eigen::VectorXd all(observations.Count(0, scene_.last_fitted_frame));
  Eigen::Index next = 0;
  for (const Eigen::VectorXd& rows : of_windows) {
    all.segment(next, rows.size()) = rows;
    next += rows.size();
  }
  return all;
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
