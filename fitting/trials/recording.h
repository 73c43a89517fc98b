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

#include "fitting/diagnosis/classify/acting_force.h"
#include "fitting/trials/plan.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

struct TrialTruth {
  std::vector<std::string> effects;          // terms' names
  std::string fault;                         // ToString of it; empty for none
  std::map<std::string, double> parameters;  // of the effects, full name -> value
  // Of the planted effects, measured on the generator along the true motion.
  ActingForce force;
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
Camera FaultyCamera(const PlantedFault& fault, const Camera& given);

// The true places of a grid of points in every frame, noise-free, and how far apart two such lists
// are: root mean square, m.
std::vector<TruthPoint> TruePoints(const Trial& trial);
double DistanceBetween(const std::vector<TruthPoint>& a, const std::vector<TruthPoint>& b);

// The trial with nothing planted and nothing wrong.
Trial WithoutEffects(const Trial& trial);

}  // namespace clothfit
