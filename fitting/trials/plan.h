// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which trials there are: the same list for the same name and seeds, whatever is run of it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "fitting/trials/effects.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

enum class TrialKind {
  kClean,     // nothing is missing
  kFault,     // only the observation is wrong
  kListed,    // an effect of clothfit's own list
  kUnlisted,  // one that clothfit has no term for
  kPair,      // two of clothfit's own at once
};
std::string ToString(TrialKind kind);  // "clean", "fault", "listed", "unlisted", "pair"

enum class TrialObservation {
  kMarkers,      // 7 x 7, sigma 1.5 mm
  kTracks,       // of 7 x 7 points in three cameras, sigma 0.5 px
  kSilhouettes,  // masks of three cameras
  kMixture,      // 4 x 4 markers, sigma 2 mm, and their tracks in two cameras
};
std::string ToString(TrialObservation observation);

enum class FaultKind {
  kCameraPose,   // one camera stands elsewhere than the recording says
  kCameraClock,  // one camera's pictures are taken later than the recording says
  kCameraScale,  // one camera's focal length is larger
  kMarkerShift,  // all markers sit elsewhere on the cloth
  kMarkerSwap,   // two markers change their names in the middle of the recording
};
constexpr std::array<FaultKind, 5> kFaultKinds = {FaultKind::kCameraPose, FaultKind::kCameraClock,
                                                  FaultKind::kCameraScale, FaultKind::kMarkerShift,
                                                  FaultKind::kMarkerSwap};
std::string ToString(FaultKind kind);  // "camera-pose", ...

struct PlantedFault {
  FaultKind kind = FaultKind::kCameraPose;
  int camera = 0;
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();      // rad, about the camera's own axes
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();     // m, along the camera's own axes
  double delay = 0.0;                                  // s
  double scale = 0.0;                                  // share by which the focal length is larger
  Eigen::Vector2d on_cloth = Eigen::Vector2d::Zero();  // m, from where a marker is said to be
  int first_marker = 0, second_marker = 0;             // ids
};

struct PlantedEffect {
  std::string term;
  EffectSize size = EffectSize::kMiddle;
  std::map<std::string, double> parameters;  // full name -> value
};

struct Trial {
  std::string name;  // can be a folder's
  TrialKind kind = TrialKind::kClean;
  TrialObservation observation = TrialObservation::kMarkers;
  Fabric fabric = Fabric::kWoven;
  std::vector<PlantedEffect> effects;  // none, one or two
  std::optional<PlantedFault> fault;
  // Parameters are the fabric's and those of listed effects.
  SyntheticOptions recording;
  bool finite_elements = false;  // simulated by fem_cloth.h
  std::uint64_t seed = 1;

  // Of unlisted effects, full name -> value.
  std::map<std::string, double> UnlistedParameters() const;
};

struct TrialPlanOptions {
  int first_seed = 1;
  int num_seeds = 1;              // how often the whole plan is drawn
  std::vector<std::string> only;  // effects and faults; empty: all
  std::string match;              // in the name of each trial; empty: all
  int sample = 0;  // so many of what is left then, one of each stretch of the list; 0: all
  bool same_generator = false;  // simulate with the fit's mesh and step
  // Simulate by finite elements; trials whose effects those do not have are left out.
  bool finite_elements = false;
  // Size of the recordings.
  int frame_count = 150;
  int resolution = 11;  // particles a side that the recording tells a fit to use
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrialPlanOptions, first_seed, num_seeds, only, match, sample,
                                   same_generator, finite_elements, frame_count, resolution)

// The names: clean, fault, listed, unlisted, pairs, all, quick.
std::vector<std::string> TrialPlanNames();

// Throws InputError, naming `place` or the option, where there is no such plan or effect.
std::vector<Trial> MakeTrialPlan(const std::string& place, const std::string& plan,
                                 const TrialPlanOptions& options = {});

// One line a trial.
std::string DescribePlan(const std::vector<Trial>& trials);

}  // namespace clothfit
