// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/frame_by_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/rollout/attraction_targets.h"
#include "fitting/rollout/window_simulator.h"

namespace clothfit {
namespace {

constexpr double kFirstHandleStep = 0.02;  // m: of a derivative-free search
constexpr double kFirstFabricStep = 0.3;   // of a logarithm, or in sigmas of the prior

}  // namespace

FrameByFrame::FrameByFrame(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                           const FrameByFrameOptions& options, const std::atomic<bool>* stop)
    : scene_(scene),
      free_(free),
      options_(options),
      stop_(stop),
      error_(scene, config),
      observations_(scene, config),
      simulation_(scene.mesh, scene.world, scene.HandlePoints(), StepOptions(config)) {
  for (int h = 0; h < static_cast<int>(scene.handles.size()); ++h) {
    if (!scene.handles[h].path.is_known()) unknown_handles_.push_back(h);
  }
  if (options.fabric) fabric_ = free.Fabric();
  const double dt = scene.FrameTime(1);
  motion_sigma_ = config.spline_acceleration * dt * dt;
}

StepInputs FrameByFrame::Inputs(double time, const Eigen::VectorXd& unknowns,
                                bool with_directions) const {
  StepInputs inputs;
  const double begin = scene_.FrameTime(frame_ - 1);
  const double share = std::clamp((time - begin) * scene_.recording.frame_rate, 0.0, 1.0);
  std::vector<std::pair<int, int>> moved;  // row of the inputs, unknown
  for (int h = 0; h < static_cast<int>(scene_.handles.size()); ++h) {
    const SceneHandle& handle = scene_.handles[h];
    if (time > handle.released_after + 1e-9) continue;
    const auto place = std::find(unknown_handles_.begin(), unknown_handles_.end(), h);
    Eigen::Vector3d position;
    if (place == unknown_handles_.end()) {
      position = handle.path.At(time);
    } else {
      const auto k = static_cast<int>(place - unknown_handles_.begin());
      position = (1.0 - share) * from_[k] + share * unknowns.segment<3>(3 * k);
      moved.emplace_back(3 * static_cast<int>(inputs.handles.size()), 3 * k);
    }
    inputs.handles.push_back({handle.on_cloth, position});
  }
  if (options_.attract) AddAttractionTargets(scene_, frame_, &inputs);
  if (with_directions && !moved.empty()) {
    inputs.directions.setZero(inputs.num_rows(), unknowns.size());
    for (const auto& [row, unknown] : moved) {
      inputs.directions.block<3, 3>(row, unknown) = share * Eigen::Matrix3d::Identity();
    }
  }
  return inputs;
}

bool FrameByFrame::Simulate(const Eigen::VectorXd& unknowns, State* state,
                            Sensitivity* sensitivity) {
  Eigen::VectorXd theta = theta_;
  const auto handles = static_cast<Eigen::Index>(3 * unknown_handles_.size());
  for (std::size_t k = 0; k < fabric_.size(); ++k)
    theta[fabric_[k]] = unknowns[handles + static_cast<Eigen::Index>(k)];
  simulation_.SetParameters(free_.Values(theta));
  simulation_.Reset();  // the same numbers whatever was tried before
  *state = state_;
  if (sensitivity != nullptr) {
    const Eigen::MatrixXd of_free = free_.ValueDirections(theta);
    Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(of_free.rows(), unknowns.size());
    for (std::size_t k = 0; k < fabric_.size(); ++k)
      directions.col(handles + static_cast<Eigen::Index>(k)) = of_free.col(fabric_[k]);
    *sensitivity = Sensitivity(*state, directions);
  }
  const Drive drive = [&](double time, bool with_directions) {
    return Inputs(time, unknowns, with_directions);
  };
  result_.simulated_frames += 1.0;
  if (sensitivity != nullptr)
    result_.differentiated_frames +=
        std::min(1.0, static_cast<double>(unknowns.size()) / std::max(1, free_.size()));
  for (int k = 0; k < scene_.steps_per_frame; ++k) {
    const StepReport report = simulation_.Advance(scene_.step, drive, state, sensitivity);
    if (report.status != StepStatus::kConverged || !state->x.allFinite()) return false;
  }
  state->time = scene_.FrameTime(frame_);
  return true;
}

// The soft error of the frame, and what is known without it: a handle goes on as it went, the
// fabric stays as it was.
bool FrameByFrame::Residuals(const Eigen::VectorXd& unknowns, Eigen::VectorXd* residuals,
                             RowMajorMatrix* jacobian) {
  State state;
  Sensitivity sensitivity;
  if (!Simulate(unknowns, &state, jacobian != nullptr ? &sensitivity : nullptr)) return false;
  const int observed = observations_.Count(frame_);
  const auto n = static_cast<int>(unknowns.size());
  residuals->resize(observed + n);
  if (jacobian != nullptr) jacobian->setZero(observed + n, n);
  if (!observations_.Evaluate(frame_, state, jacobian != nullptr ? &sensitivity : nullptr, 0,
                              residuals, jacobian)) {
    return false;
  }
  const auto handles = static_cast<int>(3 * unknown_handles_.size());
  for (int i = 0; i < n; ++i) {
    const double sigma = i < handles
                             ? motion_sigma_
                             : kFirstFabricStep * free_.entries()[fabric_[i - handles]].prior_sigma;
    (*residuals)[observed + i] = (unknowns[i] - expected_[i]) / sigma;
    if (jacobian != nullptr) (*jacobian)(observed + i, i) = 1.0 / sigma;
  }
  return true;
}

Objective FrameByFrame::MakeObjective() {
  Objective objective;
  const auto n = expected_.size();
  const auto handles = static_cast<Eigen::Index>(3 * unknown_handles_.size());
  objective.start = expected_;
  objective.lower = Eigen::VectorXd::Constant(n, -std::numeric_limits<double>::infinity());
  objective.upper = -objective.lower;
  objective.step = Eigen::VectorXd::Constant(n, kFirstHandleStep);
  for (std::size_t k = 0; k < fabric_.size(); ++k) {
    const FreeEntry& entry = free_.entries()[fabric_[k]];
    const Eigen::Index i = handles + static_cast<Eigen::Index>(k);
    objective.lower[i] = entry.lower;
    objective.upper[i] = entry.upper;
    objective.step[i] = kFirstFabricStep * (entry.is_log ? 1.0 : entry.prior_sigma);
  }
  objective.value = [this](const Eigen::VectorXd& unknowns, int) {
    State state;
    if (!Simulate(unknowns, &state, nullptr)) return std::numeric_limits<double>::infinity();
    return error_.OfFrame(frame_, state.x);
  };
  if (NeedsDerivatives(options_.optimiser)) {
    objective.num_residuals = observations_.Count(frame_) + static_cast<int>(n);
    objective.residuals = [this](const Eigen::VectorXd& unknowns, Eigen::VectorXd* residuals,
                                 RowMajorMatrix* jacobian) {
      return Residuals(unknowns, residuals, jacobian);
    };
  }
  return objective;
}

bool FrameByFrame::FitFrame() {
  Eigen::VectorXd unknowns = expected_;
  // A released handle or a frame that is not fitted leaves nothing to search for.
  if (unknowns.size() > 0 && scene_.is_fitted[frame_]) {
    OptimiserOptions options;
    options.tolerance = options_.tolerance;
    options.budget.evaluations = options_.max_evaluations;
    options.stop = stop_;
    unknowns = Minimise(options_.optimiser, MakeObjective(), options).x;
  }
  State state;
  if (!Simulate(unknowns, &state, nullptr)) return false;
  state_ = std::move(state);
  result_.error += error_.OfFrame(frame_, state_.x);
  result_.positions.push_back(state_.x);
  for (std::size_t k = 0; k < unknown_handles_.size(); ++k) {
    const Eigen::Vector3d to = unknowns.segment<3>(3 * static_cast<Eigen::Index>(k));
    result_.paths[unknown_handles_[k]].push_back({state_.time, to});
    expected_.segment<3>(3 * static_cast<Eigen::Index>(k)) = 2.0 * to - from_[k];
    from_[k] = to;
  }
  const auto fabric = static_cast<Eigen::Index>(fabric_.size());
  expected_.tail(fabric) = unknowns.tail(fabric);
  return true;
}

FrameByFrameResult FrameByFrame::Run(const Eigen::VectorXd& theta) {
  State state;
  Eigen::VectorXd x, v;
  free_.InitialState(theta, &x, &v);
  state = simulation_.MakeState(x);
  state.v = v;
  std::vector<Eigen::Vector3d> at_rest;
  for (const int h : unknown_handles_) at_rest.push_back(scene_.handles[h].on_cloth.At(x));
  Begin(theta, state, 0, at_rest, at_rest);
  result_.error = error_.OfFrame(0, state_.x);
  return FitFrames(scene_.last_fitted_frame);
}

FrameByFrameResult FrameByFrame::Continue(const Eigen::VectorXd& theta, const State& state,
                                          int first, int last) {
  std::vector<SceneHandle> handles = scene_.handles;
  free_.ApplyToHandles(theta, &handles);
  std::vector<Eigen::Vector3d> from, before;
  for (const int h : unknown_handles_) {
    from.push_back(handles[h].path.At(scene_.FrameTime(first)));
    before.push_back(handles[h].path.At(scene_.FrameTime(std::max(0, first - 1))));
  }
  Begin(theta, state, first, from, before);
  return FitFrames(last);
}

void FrameByFrame::Begin(const Eigen::VectorXd& theta, const State& state, int frame,
                         const std::vector<Eigen::Vector3d>& from,
                         const std::vector<Eigen::Vector3d>& before) {
  result_ = {};
  result_.positions.push_back(state.x);
  result_.paths.resize(scene_.handles.size());
  theta_ = theta;
  state_ = state;
  frame_ = frame;
  from_ = from;
  const auto handles = static_cast<Eigen::Index>(3 * unknown_handles_.size());
  expected_.resize(handles + static_cast<Eigen::Index>(fabric_.size()));
  for (std::size_t k = 0; k < unknown_handles_.size(); ++k) {
    expected_.segment<3>(3 * static_cast<Eigen::Index>(k)) = 2.0 * from[k] - before[k];
    result_.paths[unknown_handles_[k]].push_back({scene_.FrameTime(frame), from[k]});
  }
  for (std::size_t k = 0; k < fabric_.size(); ++k)
    expected_[handles + static_cast<Eigen::Index>(k)] = theta[fabric_[k]];
}

FrameByFrameResult FrameByFrame::FitFrames(int last) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fabric_.size()));
  const int count = last - frame_;
  while (frame_ < last) {
    ++frame_;
    if ((stop_ != nullptr && *stop_) || !FitFrame()) return result_;
    sum += expected_.tail(sum.size());
  }
  result_.theta = theta_;
  for (std::size_t k = 0; k < fabric_.size(); ++k)
    result_.theta[fabric_[k]] = sum[static_cast<Eigen::Index>(k)] / std::max(1, count);
  result_.complete = true;
  return result_;
}

}  // namespace clothfit
