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

std::vector<WindowLength> WindowLengths(const JointScenes& scenes) {
  std::vector<std::vector<int>> of_each;
  std::size_t longest = 0;  // the recording with most of them
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    of_each.push_back(WindowLengths(scenes[i].scene, scenes[i].config));
    if (of_each[i].size() > of_each[longest].size()) longest = i;
  }
  std::vector<WindowLength> lengths(of_each[longest].size());
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    lengths[k].seconds = of_each[longest][k] / scenes[longest].scene.recording.frame_rate;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      lengths[k].frames.push_back(k < of_each[i].size() ? of_each[i][k]
                                                        : scenes[i].scene.last_fitted_frame);
  }
  return lengths;
}

ShootingWindows::ShootingWindows(const JointScenes& scenes, const std::atomic<bool>* stop)
    : scenes_(scenes), stop_(stop), num_workers_(NumThreads(0)) {
  for (int worker = 0; worker < num_workers_; ++worker) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto& [scene, config, free, observations] = scenes[i];
      simulators_.push_back(std::make_unique<WindowSimulator>(scene, config, free, false, stop));
    }
  }
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

bool ShootingWindows::Lay(const Eigen::VectorXd& theta, const std::vector<int>& frames) {
  windows_.clear();
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    if (LayAlong(i, scenes_.free().Of(i, theta), frames[i])) continue;
    windows_.clear();
    return false;
  }
  return !windows_.empty();
}

bool ShootingWindows::LayAlong(std::size_t recording, const Eigen::VectorXd& theta, int frames) {
  const auto& [scene, config, free, observations] = scenes_[recording];
  std::vector<LaidWindow> laid;
  if (frames < scene.last_fitted_frame) {
    laid = LayWindows(scene, config, free, theta, frames, stop_, &nudged_frames_);
  } else {
    laid.push_back({0, 0, scene.last_fitted_frame, State()});  // it begins as the recording does
  }
  const Eigen::MatrixXd directions = free.ValueDirections(theta);
  for (LaidWindow& one : laid) {
    Window window;
    window.recording = recording;
    if (one.first_frame > 0)
      window.start = {one.first_frame, one.state, Sensitivity(one.state, directions), theta};
    window.laid = std::move(one);
    windows_.push_back(std::move(window));
  }
  return !laid.empty();
}

int ShootingWindows::NumResiduals() const {
  int count = 0;
  for (const Window& window : windows_) count += scenes_[window.recording].free.size() + 1;
  return count;
}

bool ShootingWindows::EvaluateAll(
    const Eigen::VectorXd& theta, WindowRows kind, bool derivatives,
    const std::function<void(int, const Eigen::VectorXd&, const RowMajorMatrix&)>& rows) {
  std::atomic<bool> is_complete = true;
  ParallelFor(size(), num_workers_, [&](int i, int worker) {
    if (!is_complete) return;
    Window& window = windows_[static_cast<std::size_t>(i)];
    WindowSimulator& simulator = SimulatorOf(window, worker);
    const Eigen::VectorXd own = scenes_.free().Of(window.recording, theta);
    if (window.laid.first_frame == 0) window.start = simulator.FirstStart(own);
    Eigen::VectorXd residuals;
    RowMajorMatrix jacobian;
    simulator.SwapMotion(&window.motion);
    const Outcome outcome =
        EvaluateWindow(&simulator, scenes_[window.recording].observations, window.start, own,
                       window.laid.first_row_frame, window.laid.last, kind, &residuals,
                       derivatives ? &jacobian : nullptr);
    simulator.SwapMotion(&window.motion);
    if (outcome == Outcome::kComplete) {
      rows(i, residuals, jacobian);
    } else {
      is_complete = false;
    }
  });
  return is_complete;
}

bool ShootingWindows::Evaluate(const Eigen::VectorXd& theta, Eigen::VectorXd* residuals,
                               RowMajorMatrix* jacobian) {
  std::vector<Eigen::Index> first_rows;
  Eigen::Index count = 0;
  for (const Window& window : windows_) {
    first_rows.push_back(count);
    count += scenes_[window.recording].free.size() + 1;
  }
  residuals->setZero(count);
  if (jacobian != nullptr) jacobian->setZero(count, scenes_.free().size());
  return EvaluateAll(theta, WindowRows::kCompressed, jacobian != nullptr,
                     [&](int i, const Eigen::VectorXd& of_window, const RowMajorMatrix& columns) {
                       const auto window = static_cast<std::size_t>(i);
                       residuals->segment(first_rows[window], of_window.size()) = of_window;
                       if (jacobian == nullptr) return;
                       scenes_.free().PutColumns(windows_[window].recording, columns,
                                                 first_rows[window], jacobian);
                     });
}

Eigen::VectorXd ShootingWindows::Residuals(const Eigen::VectorXd& theta) {
  std::vector<Eigen::VectorXd> of_windows(windows_.size());
  const bool is_complete =
      EvaluateAll(theta, WindowRows::kAll, false,
                  [&](int i, const Eigen::VectorXd& rows, const RowMajorMatrix&) {
                    of_windows[static_cast<std::size_t>(i)] = rows;
                  });
  if (!is_complete) return {};
  Eigen::VectorXd all(scenes_.NumResiduals());
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

// Which simulator differentiated which window differs from run to run, and with it the rounding of
// the sum.
double ShootingWindows::differentiated_frames() const {
  constexpr double kExactly = 1e6;  // parts of a frame
  double frames = 0.0;
  for (const auto& simulator : simulators_) frames += simulator->differentiated_frames();
  return std::round(kExactly * frames) / kExactly;
}

}  // namespace clothfit
