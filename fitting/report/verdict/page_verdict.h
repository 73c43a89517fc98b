// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How good a fit is, in words that its numbers support.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/fit/fit.h"
#include "tracking/text/text.h"

namespace clothfit {

// One kind of observation, over the fitted or over the held-out frames.
struct ErrorChange {
  std::string kind;  // "markers", "tracks", "clouds", "silhouettes"
  bool held_out = false;
  std::string unit;  // "m"; "px"; of silhouettes px that differ in a picture
  std::optional<double> before, after;
};

struct VerdictFacts {
  std::string status;               // as summary.json has it
  std::vector<ErrorChange> errors;  // those that are known
  std::optional<double> noise_factor;
  int num_free = 0;                                 // physical parameters
  std::vector<std::string> undetermined, at_bound;  // names among them
  int recorded_frames = 0, simulated_frames = 0;
  std::optional<Misfit> misfit;              // of markers and tracks
  std::string put_right;                     // wrong labels, in words; empty where there were none
  std::string left_out;                      // gross errors, likewise
  std::string marker_places;                 // how far beside the given ones, likewise
  std::string lack_of_support;               // see DescribeLackOfSupport
  std::string rugged_cost;                   // where a fit rests, see RuggedCostAmong
  std::vector<std::string> unknown_handles;  // in held-out frames
  std::string recording;                     // as the command line names it
  bool is_predicted = false;                 // nothing of the recording was fitted
};

struct PageVerdict {
  enum class Grade { kGood, kPartial, kPoor };
  Grade grade = Grade::kPoor;
  std::string headline;
  std::vector<std::string> sentences;
};
std::string ToString(PageVerdict::Grade grade);

// A sentence on a fit whose status, as summary.json has it, is not "converged".
std::string SayHowItEnded(const std::string& status);

// Good: converged, residuals that noise alone may leave (Misfit::IsNoise; of outlines within 1.5
// times the stated noise), and held-out errors within 1.5 times the fitted ones, where those can be
// judged. Partial: within 5 and 2.5 times, and better than the start. Else poor. Of a recording
// that is predicted its noise alone counts, and whether it is better than with the start values.
PageVerdict JudgeFit(const VerdictFacts& facts);

}  // namespace clothfit
