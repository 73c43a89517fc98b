// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the true model would predict: the end of the scale for what a diagnosis has closed.
#include <algorithm>
#include <cmath>
#include <exception>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/trials/score.h"
#include "fitting/trials/terms/trial_terms.h"

namespace clothfit {
namespace {

// The baseline with the material parameters and the effects at the truth; the effects' amounts are
// free.
FitConfig TrueConfig(const Trial& trial, const TrialRecording& made, const FitConfig& baseline) {
  FitConfig config = baseline;
  config.coarse_resolution = 0;  // it starts at the truth
  for (auto& [name, setting] : config.parameters) {
    const auto value = made.fabric.find(name);
    if (value == made.fabric.end() || !setting.free) continue;
    setting.value = std::clamp(value->second, setting.lower, setting.upper);
  }
  for (const PlantedEffect& effect : trial.effects) {
    for (const Parameter& parameter : TermOf(effect.term).parameters) {
      const std::string name = effect.term + "." + parameter.name;
      ParameterSetting& setting = config.parameters.at(name);
      const auto value = effect.parameters.find(name);
      if (value == effect.parameters.end()) continue;
      setting.value = value->second;
      setting.free = SwitchesOff(parameter);
    }
  }
  return config;
}

std::optional<double> HeldOutOf(const Evaluation& evaluation) {
  return evaluation.held_out_marker_rms ? evaluation.held_out_marker_rms
                                        : evaluation.held_out_track_rms;
}

// Root mean square distance of what was observed in held-out frames from the simulated surface.
std::optional<double> ObservedError(const Recording& recording, const SyntheticSurface& surface) {
  double sum = 0.0;
  int count = 0;
  const auto add = [&](double square) {
    sum += square;
    ++count;
  };
  for (const Marker& marker : recording.markers) {
    if (!IsHeldOutFrame(recording, marker.frame)) continue;
    const SurfacePoint point = LocateOnCloth(surface.mesh, {marker.uv})[0];
    add((point.At(surface.positions[marker.frame]) - marker.position).squaredNorm());
  }
  for (const Track& track : recording.tracks) {
    if (!recording.markers.empty() || !IsHeldOutFrame(recording, track.frame)) continue;
    const SurfacePoint point = LocateOnCloth(surface.mesh, {track.uv})[0];
    const Eigen::Vector3d place = point.At(surface.positions[track.frame]);
    const Camera& camera = recording.cameras[track.camera];
    if (IsInFront(camera, place)) add((ProjectPoint(camera, place) - track.pixel).squaredNorm());
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / count);
}

std::optional<double> SimulatedError(const Trial& trial, const Recording& recording,
                                     const FitConfig& baseline) {
  SyntheticOptions coarse = trial.recording;
  coarse.refinement = 1;
  coarse.steps_per_frame = std::max(
      1, static_cast<int>(std::ceil(1.0 / (coarse.frame_rate * baseline.max_step) - 1e-9)));
  SyntheticGenerator generator;
  generator.parameters = trial.UnlistedParameters();
  generator.make = MakeTrialSimulation;
  return ObservedError(recording, MakeSyntheticRecording(coarse, {}, generator).surface);
}

}  // namespace

std::optional<double> TrueModelError(const Trial& trial, const TrialRecording& made,
                                     const FitConfig& baseline) {
  try {
    if (trial.kind == TrialKind::kUnlisted) return SimulatedError(trial, made.recording, baseline);
    const FitConfig config = TrueConfig(trial, made, baseline);
    return HeldOutOf(RunFit(MakeScene(made.recording, config), config).after);
  } catch (const std::exception&) {
    return std::nullopt;  // the trial is scored without
  }
}

}  // namespace clothfit
