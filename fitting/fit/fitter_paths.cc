// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the paths of unknown handles are found before a fit of outlines alone.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/fit/fitter.h"

namespace clothfit {
namespace {

bool AnyUnknown(const std::vector<SceneHandle>& handles) {
  return std::any_of(handles.begin(), handles.end(),
                     [](const SceneHandle& handle) { return !handle.path.is_known(); });
}

}  // namespace

void Fitter::FindHandlePathsApart() {
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const auto& [scene, config, free, observations] = scenes_[i];
    if (!AnyUnknown(scene.handles) || Stopped()) continue;
    FitCallbacks callbacks = callbacks_;
    callbacks.checkpoint = {};  // of the whole alone
    Fitter alone({scenes_.named(i)}, callbacks);
    alone.ToStart();
    alone.FindHandlePaths();
    iterations_ += alone.iterations_;
    frames_for_paths_ += alone.SimulatedFrames();
    differentiated_for_paths_ += alone.DifferentiatedFrames();
    for (int k = 0; k < free.size(); ++k)
      if (free.entries()[k].kind == FreeEntry::Kind::kHandle)
        progress_.theta[free_.EntriesOf(i)[k]] = alone.progress_.theta[k];
  }
}

void Fitter::FindHandlePaths() {
  if (scenes_.size() > 1) return FindHandlePathsApart();
  const auto& [scene, config, free, observations] = scenes_[0];
  if (!AnyUnknown(scene.handles)) return;
  const double at_start = Cost(free_.start(), &rollout_);
  constexpr int kControls = 2;  // of a path that each stretch adds
  const int stride = std::max(1, static_cast<int>(std::lround(kControls * config_.spline_spacing *
                                                              scene.recording.frame_rate)));
  FrameByFrameOptions options;
  options.optimiser = "lm";
  FrameByFrame search(scene, config, free, options, callbacks_.stop);
  int fitted = 0;  // the last frame of the last fit of all that is unknown
  for (int last = 0; last < scene.last_fitted_frame && !Stopped();) {
    const int next = std::min(last + stride, scene.last_fitted_frame);
    stage_ = fmt::format("handles, frames 0-{}", next);
    if (!ContinueHandlePaths(&search, last, next)) break;
    last = next;
    // Such a fit begins at the first frame: the more there are, the more new ones are worth one.
    constexpr double kGrowth = 0.15;
    const bool is_last = last == scene.last_fitted_frame;
    if (!is_last && last - fitted < kGrowth * last) continue;
    if (observations.Count(0, last) == 0) continue;
    // The tolerance is of a cost of which most may be the masks' own.
    constexpr Patience kPatience{5, 1e-6};
    MinimiseRollout(&rollout_, last, kPatience, ControlsLongBefore(fitted));
    fitted = last;
  }
  if (Cost(progress_.theta, &rollout_) < at_start) return;
  Log("handles: what was found explains all frames worse than the start does");
  progress_.theta = free_.start();
}

std::vector<int> Fitter::ControlsLongBefore(int frame) const {
  constexpr double kLag = 8.0;  // control points: what came before has been fitted often enough
  const double now = scenes_[0].scene.FrameTime(frame) / config_.spline_spacing;
  std::vector<int> entries;
  for (int i = 0; i < free_.size(); ++i) {
    const FreeEntry& entry = free_.entries()[i];
    if (entry.kind == FreeEntry::Kind::kHandle && entry.control < now - kLag) entries.push_back(i);
  }
  return entries;
}

bool Fitter::ContinueHandlePaths(FrameByFrame* search, int first, int last) {
  const Scene& scene = scenes_[0].scene;
  const FreeParameters& free = scenes_[0].free;
  State state;
  std::vector<std::vector<PathPoint>> paths(scene.handles.size());
  std::vector<SceneHandle> handles = scene.handles;
  free.ApplyToHandles(progress_.theta, &handles);
  const WindowSimulator::Outcome outcome =
      rollout_[0].Run(rollout_[0].FirstStart(progress_.theta), progress_.theta, first, false,
                      [&](int frame, const State& at, const Sensitivity*) {
                        state = at;
                        const double time = scene.FrameTime(frame);
                        for (std::size_t h = 0; h < handles.size(); ++h)
                          paths[h].push_back({time, handles[h].path.At(time)});
                      });
  if (outcome != WindowSimulator::Outcome::kComplete) return false;
  const FrameByFrameResult found = search->Continue(progress_.theta, state, first, last);
  frames_for_paths_ += found.simulated_frames;
  differentiated_for_paths_ += found.differentiated_frames;
  if (!found.complete) {
    Log(stage_ + ": the simulation does not reach the last one");
    return false;
  }
  for (std::size_t h = 0; h < handles.size(); ++h)
    paths[h].insert(paths[h].end(), found.paths[h].begin(), found.paths[h].end());
  constexpr double kPriorSigma = 0.001;  // m
  progress_.theta = free.WithHandlePaths(progress_.theta, scene, paths, kPriorSigma);
  return true;
}

}  // namespace clothfit
