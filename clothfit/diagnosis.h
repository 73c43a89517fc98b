// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What physics a recording shows that the simulation lacks. docs/diagnosis.md tells the method.
#pragma once

#include "clothfit/run.h"

namespace clothfit::v0 {

struct DiagnosisOptions {
  std::string folder;  // of the answer; empty: none is written
  Existing existing = Existing::kRefuse;
  std::vector<std::string> exclude;  // terms that are not looked for
  int max_effects = 3;               // that are added one after the other
  int max_models = 5;                // candidates that are fitted, each time
  int finest_side = 31;              // particles a side of the mesh that decides, at most
  Callbacks callbacks;
};

// An amount of an effect with its 90 % interval, whose ends are no numbers where the diagnosis was
// interrupted.
struct Amount {
  std::string name, unit;
  double value = 0.0, lower = 0.0, upper = 0.0;
};

// A force term or a fault of the observation that was looked for.
struct Candidate {
  std::string name;
  bool physics = true;  // else a fault of cameras or markers
  double share = 0.0;   // of the misfit that it explains to first order
  double p_value = 1.0;
  bool short_listed = false;
};

// A candidate switched on and everything fitted again.
struct Model {
  std::vector<std::string> effects;  // all that are on, the newest last
  std::vector<Amount> amounts;
  double log_evidence = 0.0;  // for the newest effect, natural logarithm of the odds
  double explained = 0.0;     // share of the baseline's residual that is gone
  bool kept = false;
};

struct Diagnosis {
  // "nothing missing", "named", "observation fault", "none of the above", "undecided" or
  // "interrupted".
  std::string verdict;
  std::string headline;              // the answer, with all that the recording cannot tell apart
  std::string words;                 // the same as a paragraph, which begins with the headline
  std::vector<std::string> effects;  // that were named, and faults
  std::vector<std::string>
      cannot_tell;  // what the recording cannot tell from the first, itself too
  // The same of each later effect that does not stand alone, beside those before it.
  std::vector<std::vector<std::string>> cannot_tell_beside;
  double residual_rms = 0.0;          // of the baseline's fit, in sigmas
  double discretisation_rms = 0.0;    // the discretisation error, in sigmas
  std::vector<Candidate> candidates;  // best first
  std::vector<Model> models;          // that were fitted
  Config config;                      // of the answer, else of the baseline: fit it, simulate it
};

// Throws InputError where the recording cannot be fitted at all.
CLOTHFIT_API Diagnosis Diagnose(const Recording& recording, const Config& config,
                                const DiagnosisOptions& options = {});

}  // namespace clothfit::v0
