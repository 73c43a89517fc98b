// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One fit of a study: a recording, what of it is used, how it is searched, and how far from the
// observations and from the truth it ends.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fitting/fit/search.h"
#include "fitting/jobs/job.h"
#include "fitting/studies/study_options.h"

namespace clothfit {

struct StudyFit {
  std::string experiment;
  std::string search;           // optimiser/strategy
  std::string points = "none";  // of what was tracked: none, markers (in space), tracks (in views)
  // Pull of all of a frame's points together while the cloth is simulated: N/m, and N m^2.
  double linear = 0.0, reciprocal = 0.0;
  double alpha = 1.0, beta = 0.0;  // E = alpha E_s + beta E_a, px and mm, see SynthesisError
  int cameras = 7;                 // that are used: first the perimeter's, evenly spread
  int start = 0;                   // 0: the parameters' initial values; others are moved at random
  bool keep_surface = false;       // the result has the particles' positions in the last frame
};

struct StudyFitResult {
  double error = 0.0;       // E over all frames, as the search has it
  double all_pixels = 0.0;  // E_s of what was found in all seven cameras, mean px a picture
  double attractor = 0.0;   // E_a of what was found, mean over the frames, mm; NaN without points
  double truth_rms = 0.0;   // mm, of the surface's points
  double roughness = 0.0, true_roughness = 0.0;  // see Roughness(), in the last frame
  double simulations = 0.0, seconds = 0.0;       // seconds are told only
  int unknowns = 0;
  bool converged = false;
  std::string reason;
  std::vector<SearchPoint> history;
  std::vector<double> surface, true_surface;  // m, 3N, if kept
  std::vector<double> fabric;                 // values, in the order of the free parameters
};

// The name says what is done; jobs of one list differ in it.
Job FitJob(const std::string& name, const StudyFit& fit, const StudyOptions& options);

// Does it, with the recordings in this folder. The result is that of ReadStudyFit.
nlohmann::json RunStudyFit(const std::filesystem::path& recordings, const StudyOptions& options,
                           const Job& job, const JobContext& context);

StudyFit StudyFitOf(const Job& job);
StudyFitResult ReadStudyFit(const nlohmann::json& output);

}  // namespace clothfit
