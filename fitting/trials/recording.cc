// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/recording.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "fitting/files/sha256.h"
#include "fitting/trials/finite_elements/generator.h"
#include "fitting/trials/force.h"
#include "fitting/trials/terms/trial_terms.h"
#include "tracking/files/output_folder.h"
#include "tracking/silhouette/raster.h"
#include "tracking/synthetic/observations.h"
#include "tracking/synthetic/picture_writer.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSilhouetteSigma = 1.0;  // px, of masks that are exact to the pixel

std::vector<VectorXd> FramesAt(const SyntheticSurface& surface, const SyntheticOptions& options,
                               double delay) {
  std::vector<VectorXd> frames;
  for (int f = 0; f < options.frame_count; ++f)
    frames.push_back(SurfaceAt(surface, f / options.frame_rate + delay));
  return frames;
}

// One camera's tracks anew, as it really sees the cloth. The noise is that of the faultless ones,
// and other cameras' tracks stay as they are.
void ReplaceTracks(const PlantedFault& fault, const SyntheticOptions& options,
                   const SyntheticSurface& surface, Recording* recording) {
  Recording seen;
  seen.cameras = recording->cameras;
  seen.cameras[fault.camera] = FaultyCamera(fault, recording->cameras[fault.camera]);
  AddTracks(options, surface.mesh, FramesAt(surface, options, fault.delay), &seen);
  std::vector<Track> tracks;
  for (const Track& track : recording->tracks) {
    if (track.camera != fault.camera) tracks.push_back(track);
  }
  for (const Track& track : seen.tracks) {
    if (track.camera == fault.camera) tracks.push_back(track);
  }
  std::stable_sort(tracks.begin(), tracks.end(), [](const Track& a, const Track& b) {
    return std::make_pair(a.frame, a.camera) < std::make_pair(b.frame, b.camera);
  });
  recording->tracks = std::move(tracks);
}

// Markers sit a little beside where they are said to be.
void ShiftMarkers(const PlantedFault& fault, const SyntheticSurface& surface,
                  Recording* recording) {
  std::vector<Eigen::Vector2d> said, real;
  for (const Marker& marker : recording->markers) {
    said.push_back(marker.uv);
    real.emplace_back(marker.uv + fault.on_cloth);
  }
  const std::vector<SurfacePoint> said_points = LocateOnCloth(surface.mesh, said);
  const std::vector<SurfacePoint> real_points = LocateOnCloth(surface.mesh, real);
  for (std::size_t i = 0; i < recording->markers.size(); ++i) {
    Marker& marker = recording->markers[i];
    const VectorXd& x = surface.positions[marker.frame];
    marker.position =
        RoundedPosition(marker.position + real_points[i].At(x) - said_points[i].At(x));
  }
}

void SwapMarkers(const PlantedFault& fault, Recording* recording) {
  const int from = recording->frame_count / 2;
  for (int frame = from; frame < recording->frame_count; ++frame) {
    Marker *first = nullptr, *second = nullptr;
    for (Marker& marker : recording->markers) {
      if (marker.frame != frame) continue;
      if (marker.id == fault.first_marker) first = &marker;
      if (marker.id == fault.second_marker) second = &marker;
    }
    if (first != nullptr && second != nullptr) std::swap(first->position, second->position);
  }
}

// What the kind of observation does not have.
void TakeOut(const Trial& trial, Recording* recording) {
  const bool has_markers = trial.observation == TrialObservation::kMarkers ||
                           trial.observation == TrialObservation::kMixture;
  if (!has_markers) {
    recording->markers.clear();
    recording->noise.marker.reset();
  }
  if (trial.observation == TrialObservation::kSilhouettes) {
    recording->tracks.clear();
    recording->noise.track.reset();
    recording->noise.silhouette = kSilhouetteSigma;
  }
}

void WriteMasks(const Trial& trial, const SyntheticSurface& surface, const Recording& recording,
                const fs::path& folder) {
  for (std::size_t c = 0; c < recording.cameras.size(); ++c) {
    const bool is_faulty = trial.fault && trial.fault->camera == static_cast<int>(c);
    const Camera camera =
        is_faulty ? FaultyCamera(*trial.fault, recording.cameras[c]) : recording.cameras[c];
    const SilhouetteRaster raster(camera, surface.mesh.triangles);
    BitMask mask(camera.width, camera.height);
    const std::vector<VectorXd> frames =
        FramesAt(surface, trial.recording, is_faulty ? trial.fault->delay : 0.0);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      mask.Clear();
      raster.Draw(frames[f], &mask);
      WritePicture(mask.ToMat(), FrameFile(folder / "masks", camera, static_cast<int>(f)));
    }
  }
}

// force: of finite elements, what the planted effects do; may be null.
SyntheticGenerator GeneratorOf(const Trial& trial, ActingForce* force) {
  if (trial.finite_elements) {
    return FiniteElementGenerator(trial.UnlistedParameters(), PlantedTruth(trial).effects, force);
  }
  SyntheticGenerator generator;
  generator.parameters = trial.UnlistedParameters();
  if (!generator.parameters.empty()) generator.make = MakeTrialSimulation;
  return generator;
}

}  // namespace

TrialTruth PlantedTruth(const Trial& trial) {
  TrialTruth truth;
  for (const PlantedEffect& effect : trial.effects) {
    truth.effects.push_back(effect.term);
    truth.parameters.insert(effect.parameters.begin(), effect.parameters.end());
  }
  if (trial.fault) truth.fault = ToString(trial.fault->kind);
  if (!truth.effects.empty()) truth.effect_class = ClassOf(truth.effects.front());
  return truth;
}

std::string TrialTruth::Label(const Trial& trial) const {
  std::string label = trial.name +
                      "; effects: " + (effects.empty() ? "none" : JoinNames(effects, " + ")) +
                      "; fault: " + (fault.empty() ? "none" : fault);
  for (const auto& [name, value] : parameters) label += "; " + name + " = " + FormatNumber(value);
  if (!trial.fault) return label;
  const PlantedFault& f = *trial.fault;
  label += fmt::format("; camera {}; turn", f.camera);
  for (int k = 0; k < 3; ++k) label += " " + FormatNumber(f.turn[k]);
  label += "; shift";
  for (int k = 0; k < 3; ++k) label += " " + FormatNumber(f.shift[k]);
  label += "; delay " + FormatNumber(f.delay) + "; scale " + FormatNumber(f.scale);
  label += "; on cloth " + FormatNumber(f.on_cloth.x()) + " " + FormatNumber(f.on_cloth.y());
  return label + fmt::format("; markers {} {}", f.first_marker, f.second_marker);
}

Commitment Commit(const Trial& trial, const TrialTruth& truth) {
  Commitment commitment;
  commitment.nonce = Sha256(fmt::format("nonce {} {}", trial.seed, trial.name)).substr(0, 32);
  commitment.digest = Sha256(truth.Label(trial) + "\n" + commitment.nonce);
  return commitment;
}

VectorXd SurfaceAt(const SyntheticSurface& surface, double time) {
  const int last = static_cast<int>(surface.positions.size()) - 1;
  const double place = std::clamp(time / surface.interval, 0.0, static_cast<double>(last));
  const int i = std::min(static_cast<int>(place), std::max(0, last - 1));
  const double t = place - i;
  if (t == 0.0) return surface.positions[i];
  const auto at = [&](int k) -> const VectorXd& {
    return surface.positions[std::clamp(k, 0, last)];
  };
  // Catmull and Rom 1974.
  const VectorXd before = 0.5 * (at(i + 1) - at(i - 1)), after = 0.5 * (at(i + 2) - at(i));
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * at(i) + (t3 - 2.0 * t2 + t) * before +
         (3.0 * t2 - 2.0 * t3) * at(i + 1) + (t3 - t2) * after;
}

Camera FaultyCamera(const PlantedFault& fault, const Camera& given) {
  Camera real = given;
  const double angle = fault.turn.norm();
  if (angle > 0.0) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Vector3d(fault.turn / angle)).toRotationMatrix();
    real.camera_from_world_rotation = turn * given.camera_from_world_rotation;
    real.camera_from_world_translation = turn * given.camera_from_world_translation;
  }
  real.camera_from_world_translation += fault.shift;
  real.fx *= 1.0 + fault.scale;
  real.fy *= 1.0 + fault.scale;
  return real;
}

void AddFault(const PlantedFault& fault, const SyntheticOptions& options,
              const SyntheticSurface& surface, Recording* recording) {
  switch (fault.kind) {
    case FaultKind::kMarkerShift:
      ShiftMarkers(fault, surface, recording);
      return;
    case FaultKind::kMarkerSwap:
      SwapMarkers(fault, recording);
      return;
    default:
      ReplaceTracks(fault, options, surface, recording);
  }
}

TrialRecording MakeTrialRecording(const Trial& trial, const fs::path& folder) {
  const bool has_effects = !trial.effects.empty();
  ActingForce force;
  SyntheticGenerator generator = GeneratorOf(trial, has_effects ? &force : nullptr);
  TrueForceMeter meter(trial);
  if (has_effects) generator.observe = meter.Observer();
  SyntheticRecording synthetic = MakeSyntheticRecording(trial.recording, {}, generator);
  if (trial.fault) {
    AddFault(*trial.fault, trial.recording, synthetic.surface, &synthetic.recording);
  }
  TakeOut(trial, &synthetic.recording);
  TrialRecording result{synthetic.recording, PlantedTruth(trial), synthetic.truth_parameters,
                        synthetic.surface};
  if (has_effects)
    result.truth.force = trial.finite_elements ? force : meter.Result(synthetic.surface.mesh);
  const bool has_masks = trial.observation == TrialObservation::kSilhouettes;
  if (folder.empty()) {
    if (has_masks) throw std::invalid_argument(trial.name + ": masks need a folder");
    return result;
  }
  const std::map<std::string, std::string> files = FilesOf(synthetic);
  std::vector<std::string> names = NamesOf(files);
  for (const Camera& camera : synthetic.recording.cameras) {
    for (int frame = 0; has_masks && frame < synthetic.recording.frame_count; ++frame)
      names.push_back(FrameFile("masks", camera, frame).string());
  }
  OutputFolder output(folder, FolderKind::kRecording, "trials", Existing::kReplace);
  output.Begin(names);
  if (has_masks) WriteMasks(trial, synthetic.surface, synthetic.recording, folder);
  output.WriteAll(files);
  result.recording = ReadRecording(folder);
  return result;
}

std::vector<TruthPoint> TruePoints(const Trial& trial) {
  return MakeSyntheticRecording(trial.recording, {}, GeneratorOf(trial, nullptr)).truth_points;
}

double DistanceBetween(const std::vector<TruthPoint>& a, const std::vector<TruthPoint>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i].position - b[i].position).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

Trial WithoutEffects(const Trial& trial) {
  Trial without = trial;
  without.effects.clear();
  without.fault.reset();
  for (const auto& [name, value] : PlantedTruth(trial).parameters)
    without.recording.parameters.erase(name);
  return without;
}

}  // namespace clothfit
