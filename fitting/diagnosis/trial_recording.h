// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The recording of a trial, and the truth about what was planted into it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/diagnosis/trial_plan.h"
#include "tracking/synthetic_recording.h"

namespace clothfit {

// Where and when the planted effects acted, and what they did to the energy: measured on the
// generator, as the force with them less the force without, along the true motion.
struct TrueForce {
  bool acts = false;
  // Box around the particles where the force per area (rms over time) is at least half of its
  // largest, m on the cloth.
  Eigen::Vector2d low_uv = Eigen::Vector2d::Zero(), high_uv = Eigen::Vector2d::Zero();
  // Frames in which the force (rms over the cloth) is at least a tenth of its largest.
  int first_frame = 0, last_frame = 0;
  double peak = 0.0;      // N/m^2, rms over time where it is largest
  double work_in = 0.0;   // J, where it gave energy to the cloth
  double work_out = 0.0;  // J, where it took some, positive
};

struct TrialTruth {
  std::vector<std::string> effects;          // terms' names
  std::string fault;                         // ToString of it; empty for none
  std::map<std::string, double> parameters;  // of the effects, full name -> value
  TrueForce force;
  EffectClass effect_class;  // of the first effect

  // All of it but the force in one line without commas.
  std::string Label(const Trial& trial) const;
};

struct TrialRecording {
  Recording recording;
  TrialTruth truth;
  std::map<std::string, double> fabric;  // every parameter of the generator, full name -> value
  SyntheticSurface surface;              // of the generator's mesh
};

// What was planted, without making the recording; the force is left out.
TrialTruth PlantedTruth(const Trial& trial);

// A digest of the label and a nonce, to be published before anything is scored: it binds to the
// label. The nonce is made of the trial's seed, so it hides the label only from those who do not
// know the plan.
struct Commitment {
  std::string nonce, digest;
};
Commitment Commit(const Trial& trial, const TrialTruth& truth);

// Simulates and observes, with the observation's fault. Masks are files: a trial with silhouettes
// is written to `folder` (and its recording names it), others only where the folder is not empty.
// Throws as MakeSyntheticRecording and WriteRecording do.
TrialRecording MakeTrialRecording(const Trial& trial, const std::filesystem::path& folder = {});

// The part of that which can be tested by itself: what the fault makes of a faultless recording.
// `frames`: every particle's position (3N, m) in every frame.
void AddFault(const PlantedFault& fault, const SyntheticOptions& options,
              const SyntheticSurface& surface, Recording* recording);

// Positions (3N, m) at any time by cubic interpolation between frames; at rest outside.
Eigen::VectorXd SurfaceAt(const SyntheticSurface& surface, double time);

// Where the camera of a fault really is, and what its focal length.
Camera FaultyCamera(const PlantedFault& fault, const Camera& told);

// The true places of a grid of points in every frame, noise-free, and how far apart two such lists
// are: root mean square, m.
std::vector<TruthPoint> TruePoints(const Trial& trial);
double DistanceBetween(const std::vector<TruthPoint>& a, const std::vector<TruthPoint>& b);

// The trial with nothing planted and nothing wrong.
Trial WithoutEffects(const Trial& trial);

}  // namespace clothfit
