// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How right a diagnosis is about a trial whose truth is known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"
#include "fitting/studies/recovery_study.h"
#include "fitting/trials/recording.h"

namespace clothfit {

enum class TrialStatus { kDone, kFailed };

// One trial's row. What does not apply, or what the diagnosis does not tell, is empty.
struct TrialScore {
  std::string name, kind, motion, observation, size;
  std::string truth;  // effects or the fault, joined by " + "; "none"
  TrialStatus status = TrialStatus::kFailed;
  std::string problem;  // why it failed
  std::string verdict;
  std::string named;  // all effects and faults that the diagnosis names, joined by " + "
  std::string top;    // first of the ranking, named or not
  int num_named = 0;
  // The effect's amount over the diagnosis' detection limit for it.
  std::optional<double> over_limit;
  std::optional<bool> named_first;    // the truth is the first of those named
  std::optional<bool> top_right;      // the truth is the first of the ranking
  std::optional<bool> in_ambiguity;   // the truth is in the ambiguity set
  std::optional<int> ambiguity_size;  // where something is named
  std::optional<bool> both_named;     // of pairs
  std::optional<bool> false_alarm;    // of clean and faulty recordings: physics that is not there
  std::optional<bool> fault_named;    // of faulty recordings: found to be a fault, and which
  std::optional<bool> flagged;        // of unlisted effects: none of the above
  std::optional<bool> class_right;    // where a class is told
  std::optional<bool> tie_right;      // where it is told what the force is tied to
  std::optional<double> region_overlap;  // intersection over union of area on the cloth
  std::optional<int> onset_error;  // frames, found less true, of effects that begin on the way
  std::optional<double> parameter_error;  // relative; the largest of the effects' amounts
  int covered = 0, intervals = 0;         // 90 % intervals that hold the truth, of all there are
  // Held-out root mean squares: of the refitted baseline, which is what a user would do instead,
  // of the answer and of the true model; m, or px where there are no markers.
  std::optional<double> held_out_before, held_out_after, held_out_true;
  std::optional<double> gap_closed;  // (before - after) / (before - true), where true is less
  std::string nonce, digest;         // of the truth's label, see Commitment
  double seconds = 0.0;              // of the diagnosis
};

// Everything but status, nonce, digest and seconds. `held_out_true`: see TrueModelError.
TrialScore ScoreDiagnosis(const Trial& trial, const TrialTruth& truth, const Diagnosis& diagnosis,
                          const std::optional<double>& held_out_true);

// Intersection over union of two boxes' areas; 0 where either is empty.
double BoxOverlap(const Eigen::Vector2d& low_a, const Eigen::Vector2d& high_a,
                  const Eigen::Vector2d& low_b, const Eigen::Vector2d& high_b);

// Whether a diagnosis' name is that of the fault: "camera 2: pose" or, by the camera's name,
// "camera cam2: pose"; "clock" with or without its camera; a scale; something about markers.
bool IsNameOfFault(const std::string& name, const PlantedFault& fault);

// Least held-out error that a model can have: the baseline with the effects' terms at their true
// values, their amounts and the baseline's own parameters fitted again from the truth. An effect
// that clothfit has no term for is simulated at the truth on the fit's mesh and step instead. Root
// mean square of markers (m), else of tracks (px); empty where there are neither, or it fails.
std::optional<double> TrueModelError(const Trial& trial, const TrialRecording& made,
                                     const FitConfig& baseline);

}  // namespace clothfit
