// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/rows.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

// How many of the free entries are physical parameters; they come first.
int NumFabric(const FreeParameters& free) { return static_cast<int>(free.Fabric().size()); }

}  // namespace

Eigen::VectorXd ThetaOfPass(const FreeParameters& free, const Eigen::VectorXd& unknown) {
  Eigen::VectorXd theta = free.start();
  theta.tail(unknown.size()) = unknown;
  return theta;
}

bool IsNudged(const FitConfig& config) { return config.attract && !config.polish; }

FittedScene MakeFittedScene(Scene scene, const FitConfig& config, const FitResult& fit) {
  FittedScene fitted{std::move(scene), config, config, {}, fit};
  const FreeParameters free(config, fitted.scene, MakeParameterTable());
  fitted.unknown = fit.theta.tail(free.size() - NumFabric(free));
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (std::size_t i = 0; i < table.size(); ++i) {
    ParameterSetting& setting = fitted.values.parameters.at(table[i].name);
    // What pulled on the way to the fit is none of it.
    const bool pulls = table[i].role == Role::kGuide;
    if (!pulls) setting.value = fit.parameters[static_cast<Eigen::Index>(i)];
    // A logarithm at its bound comes back a rounding error beyond it, which no config may have.
    if (setting.free) setting.value = std::clamp(setting.value, setting.lower, setting.upper);
    setting.free = false;
  }
  return fitted;
}

void AddPriors(const std::vector<FreeEntry>& entries, Eigen::MatrixXd* information) {
  Eigen::Index i = 0;
  for (const FreeEntry& entry : entries) {
    (*information)(i, i) += 1.0 / (entry.prior_sigma * entry.prior_sigma);
    ++i;
  }
}

FittedScene WithOtherSteps(const FittedScene& fitted, const std::array<int, 2>& resolution,
                           double max_step) {
  FittedScene other = fitted;
  for (FitConfig* config : {&other.config, &other.values}) {
    config->resolution = resolution;
    config->max_step = max_step;
  }
  other.scene = MakeScene(fitted.scene.recording, other.config, &fitted.scene);
  return other;
}

Pass BaselinePass(const FittedScene& fitted) {
  Pass pass{fitted.values, true, true};
  for (auto& [name, setting] : pass.config.parameters)
    setting.free = fitted.config.parameters.at(name).free;
  return pass;
}

RowFrames::RowFrames(const Scene& scene, const ObservationResiduals& observations, int most) {
  const int all = observations.Count(0, scene.last_fitted_frame);
  const int stride = std::max(1, (all + most - 1) / std::max(1, most));
  first_row_.push_back(0);
  int seen = 0;
  for (int f = 0; f <= scene.last_fitted_frame; ++f) {
    const int count = observations.Count(f);
    if (count == 0 || seen++ % stride != 0) continue;
    frames_.push_back(f);
    first_row_.push_back(first_row_.back() + count);
  }
}

int RowFrames::FirstRow(int frame) const {
  const auto found = std::lower_bound(frames_.begin(), frames_.end(), frame);
  if (found == frames_.end() || *found != frame) return -1;
  return first_row_[static_cast<std::size_t>(found - frames_.begin())];
}

std::vector<int> RowFrames::FrameOfRows() const {
  std::vector<int> frame_of_rows;
  for (std::size_t i = 0; i < frames_.size(); ++i)
    frame_of_rows.insert(frame_of_rows.end(),
                         static_cast<std::size_t>(first_row_[i + 1] - first_row_[i]), frames_[i]);
  return frame_of_rows;
}

namespace {

// Where a pass begins a stretch of the simulation.
WindowStart StartOf(const LaidWindow& window, const WindowSimulator& simulator,
                    const FreeParameters& free, const Eigen::VectorXd& theta, bool of_unknown) {
  WindowStart start = simulator.FirstStart(theta);
  if (window.first_frame > 0) {
    start = {window.first_frame, window.state,
             Sensitivity(window.state, free.ValueDirections(theta)), theta};
  } else if (!of_unknown) {
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(start.state.x.size(), free.size());
    start.sensitivity.SetInitial(none, none);
  }
  return start;
}

}  // namespace

std::optional<Rows> EvaluateRows(
    const FittedScene& fitted, const Pass& pass, const RowFrames& frames,
    const std::vector<Fault>& faults,
    const std::function<void(int frame, const State& state)>& observer) {
  const Scene& scene = fitted.scene;
  const FreeParameters free(pass.config, scene, MakeParameterTable());
  const int fabric = NumFabric(free);
  const int kept = pass.of_unknown ? free.size() : fabric;
  const ObservationResiduals observations(scene, pass.config);
  const Eigen::VectorXd theta = ThetaOfPass(free, fitted.unknown);
  std::vector<int> others;
  if (!pass.of_unknown)
    for (int i = fabric; i < free.size(); ++i) others.push_back(i);
  Rows rows;
  rows.entries.assign(free.entries().begin(), free.entries().begin() + kept);
  rows.residuals.setZero(frames.num_rows());
  rows.jacobian.setZero(frames.num_rows(), kept);
  if (pass.of_faults) rows.faults.setZero(frames.num_rows(), static_cast<int>(faults.size()));
  const std::vector<LaidWindow> whole = {{0, 0, scene.last_fitted_frame, {}}};
  const std::vector<LaidWindow>& windows = fitted.forecasts ? *fitted.forecasts : whole;
  std::atomic<bool> usable = true;
  std::mutex observing;
  ParallelFor(static_cast<int>(windows.size()), NumThreads(0), [&](int i, int) {
    if (!usable) return;
    const LaidWindow& window = windows[static_cast<std::size_t>(i)];
    WindowSimulator simulator(scene, pass.config, free, IsNudged(pass.config), nullptr);
    simulator.Hold(others);
    Eigen::VectorXd of_frame;
    RowMajorMatrix jacobian;
    const auto outcome =
        simulator.Run(StartOf(window, simulator, free, theta, pass.of_unknown), theta, window.last,
                      kept > 0, [&](int frame, const State& state, const Sensitivity* sensitivity) {
                        if (frame < window.first_row_frame) return;
                        if (observer) {
                          const std::lock_guard<std::mutex> lock(observing);
                          observer(frame, state);
                        }
                        const int row = frames.FirstRow(frame);
                        if (row < 0 || !usable) return;
                        const int count = observations.Count(frame);
                        of_frame.resize(count);
                        jacobian.resize(count, free.size());
                        RowMajorMatrix* const own = sensitivity != nullptr ? &jacobian : nullptr;
                        if (!observations.Evaluate(frame, state, sensitivity, 0, &of_frame, own)) {
                          usable = false;
                          return;
                        }
                        rows.residuals.segment(row, count) = of_frame;
                        if (own != nullptr)
                          rows.jacobian.middleRows(row, count) = jacobian.leftCols(kept);
                        if (pass.of_faults) {
                          rows.faults.middleRows(row, count) =
                              FaultColumns(scene, pass.config, observations, faults, frame, state);
                        }
                      });
    if (outcome != WindowSimulator::Outcome::kComplete) usable = false;
  });
  const bool is_good = usable && rows.residuals.allFinite() && rows.jacobian.allFinite();
  return is_good ? std::optional<Rows>(std::move(rows)) : std::nullopt;
}

std::optional<Eigen::VectorXd> ResidualsOfOtherSteps(const FittedScene& fine,
                                                     const FittedScene& coarse,
                                                     const RowFrames& frames) {
  const ObservationResiduals on_fine(fine.scene, fine.config);
  const ObservationResiduals on_coarse(coarse.scene, coarse.config);
  const std::vector<SurfacePoint> particles = LocateOnCloth(fine.scene.mesh, coarse.scene.mesh.uv);
  Eigen::VectorXd residuals = Eigen::VectorXd::Zero(frames.num_rows());
  bool usable = true;
  const Pass pass{fine.values, false, false};
  const FreeParameters free(pass.config, fine.scene, MakeParameterTable());
  WindowSimulator simulator(fine.scene, pass.config, free, IsNudged(pass.config), nullptr);
  const Eigen::VectorXd theta = ThetaOfPass(free, fine.unknown);
  const auto outcome = simulator.Run(
      simulator.FirstStart(theta), theta, coarse.scene.last_fitted_frame, false,
      [&](int frame, const State& state, const Sensitivity*) {
        const int row = frames.FirstRow(frame);
        if (row < 0 || !usable) return;
        // Silhouettes count particles, so they are those of the coarse mesh laid onto the fine one;
        // markers and tracks are where the fine surface has them.
        State restricted;
        restricted.x.resize(3 * static_cast<Eigen::Index>(particles.size()));
        for (std::size_t i = 0; i < particles.size(); ++i)
          restricted.x.segment<3>(3 * static_cast<Eigen::Index>(i)) = particles[i].At(state.x);
        Eigen::VectorXd own(on_coarse.Count(frame)), points(on_fine.Count(frame));
        usable = on_coarse.Evaluate(frame, restricted, nullptr, 0, &own, nullptr) &&
                 on_fine.Evaluate(frame, state, nullptr, 0, &points, nullptr);
        if (!usable) return;
        const std::vector<ResidualSource> sources = SourcesOfFrame(coarse.scene, frame);
        for (std::size_t i = 0; i < sources.size(); ++i) {
          const bool is_point = sources[i].kind == ResidualSource::Kind::kMarker ||
                                sources[i].kind == ResidualSource::Kind::kTrack;
          if (is_point) own[static_cast<Eigen::Index>(i)] = points[static_cast<Eigen::Index>(i)];
        }
        residuals.segment(row, own.size()) = own;
      });
  usable = usable && outcome == WindowSimulator::Outcome::kComplete && residuals.allFinite();
  return usable ? std::optional<Eigen::VectorXd>(residuals) : std::nullopt;
}

}  // namespace clothfit
