// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Does a fit find the parameters that made a recording, and do its intervals tell how well? Fits
// synthetic recordings, whose truth is known, from the default start.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fitting/fit/fit.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

struct RecoveryOptions {
  // The recording, of which each seed changes the noise. The parameters are the truth.
  SyntheticOptions recording;
  SyntheticGenerator generator;  // of it
  int first_seed = 1;
  int num_seeds = 20;
  int num_threads = 2;  // seeds fitted at the same time; has no influence on the result
  int max_iterations = 60;
  int finest = FitConfig().finest;
};

// One free parameter of one fit.
struct RecoveredParameter {
  std::string name, unit;
  double truth = 0.0, start = 0.0, estimate = 0.0, lower95 = 0.0, upper95 = 0.0;
  bool determined = false;  // by the recording; others are told of, but not judged
  double error = 0.0;       // estimate less truth, in the fit's scale: natural logarithm or amount
  double z = 0.0;  // error over the reported sigma on the side of the truth: the interval / 1.96

  bool IsCovered() const { return truth >= lower95 && truth <= upper95; }
};

struct RecoveredSeed {
  int seed = 0;
  FitStatus status = FitStatus::kFailed;
  int iterations = 0;
  double seconds = 0.0;       // of the fit
  double marker_rms = 0.0;    // m, fitted frames
  double held_out_rms = 0.0;  // m
  double noise_factor = 1.0;
  std::vector<RecoveredParameter> parameters;
};

// How many of the intervals hold the truth.
struct Coverage {
  int covered = 0, total = 0;
  double share() const { return total > 0 ? static_cast<double>(covered) / total : 0.0; }
  // Wilson 1927: the 95 % interval of the share.
  double lower() const { return Wilson(-1.0); }
  double upper() const { return Wilson(1.0); }

 private:
  double Wilson(double side) const;
};

// Fits one recording of this seed.
RecoveredSeed RecoverSeed(const RecoveryOptions& options, int seed);

// Seeds in order. `done` is called after each, from any thread but one at a time.
std::vector<RecoveredSeed> RunRecoveryStudy(const RecoveryOptions& options,
                                            const std::function<void(const RecoveredSeed&)>& done);

// Over the determined parameters; all of them where the name is empty.
Coverage CountCoverage(const std::vector<RecoveredSeed>& seeds, const std::string& name = "");

// One line a seed and parameter.
std::string RecoveryAsCsv(const std::vector<RecoveredSeed>& seeds);
// A table over the parameters (coverage, bias, spread, mean |z|) and what the fits took.
std::string RecoveryAsMarkdown(const std::vector<RecoveredSeed>& seeds);

// A cloth whose parameters lie two to three times off the defaults, 2 mm of marker noise.
SyntheticOptions DemoRecording();

}  // namespace clothfit
