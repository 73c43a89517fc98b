// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer of a diagnosis.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "fitting/config/config.h"
#include "fitting/diagnosis/answer/motions.h"
#include "fitting/diagnosis/classify/acting_force.h"
#include "fitting/diagnosis/classify/classes.h"
#include "fitting/diagnosis/compare/separating_motion.h"
#include "fitting/diagnosis/fitted/effect_parameter.h"
#include "fitting/diagnosis/locate/discrepancy.h"
#include "fitting/diagnosis/rank/candidate.h"
#include "fitting/diagnosis/validate/held_out_validation.h"
#include "fitting/fit/fit.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// A candidate switched on and everything fitted again.
struct Model {
  std::vector<std::string> effects;         // all that are on, the newest last
  FitConfig config;                         // an ordinary config: simulate, fit and predict take it
  std::vector<EffectParameter> parameters;  // the effects'
  double cost = 0.0;                        // half the sum of squares, of fitted frames
  double log_evidence = 0.0;  // for the newest effect against the fit without it (LogEvidence)
  double explained = 0.0;     // share of the excess cost of the baseline that is gone
  HeldOutValidation validation;
  bool is_kept = false;
};

enum class Verdict {
  kNothingMissing,    // the baseline explains the recording within its discretisation error
  kNamed,             // effects are kept
  kObservationFault,  // the only thing wrong is the observation
  kNoneOfTheAbove,    // something is missing, and no candidate explains most of it
  kUndecided,         // the baseline's fit came to no minimum, or mesh and step may leave as much
  kInterrupted,
};
std::string ToString(Verdict verdict);

// A law that was learned where no effect explains the missing force.
struct Law {
  Model model;          // with its coefficients as parameters
  std::string formula;  // with units and range
};

// Pictures of the missing force, 8-bit BGR: its map over the cloth and time, and its arrows on the
// cloth.
struct DiscrepancyPictures {
  cv::Mat map, cloth;
};

// A fit of the deciding mesh, as `clothfit fit` would have made it: what the answer was read from,
// or the baseline where there is none.
struct DiagnosisFit {
  Scene scene;  // faults of the observation put right
  FitConfig config;
  FitResult result;
};

struct Diagnosis {
  Verdict verdict = Verdict::kNothingMissing;
  std::string words;  // the answer as a paragraph
  FitConfig baseline;
  FitResult baseline_fit;
  double residual_rms = 0.0;        // of the baseline's fit, in sigmas
  double discretisation_rms = 0.0;  // D, in sigmas
  std::optional<Misfit> misfit;     // of the baseline's markers and tracks
  // Of the whole residual against the null; not a number where that was not asked for.
  double gate_p_value = std::numeric_limits<double>::quiet_NaN();
  // The residual when the observation's faults have taken their part, in sigmas: of the recording
  // (not a number as above), and of every draw of the null.
  double left_rms = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> null_left_rms;
  double promised = 0.0;  // share of the cost that a full step of the baseline's fit would take
  std::optional<Discrepancy> discrepancy;
  std::optional<DiscrepancyClass> discrepancy_class;
  std::optional<DiscrepancyPictures> discrepancy_pictures;
  // Where, when and how the physics of the answer acts: its terms' force in the fitted model.
  std::optional<ActingForce> acting;
  std::optional<ActingClass> acting_class;
  std::vector<Candidate> ranking;    // best first
  std::vector<Model> models;         // all that were fitted
  std::optional<Model> answer;       // the last that was kept, or the law's
  std::optional<Law> law;            // where one was learned and validated
  std::vector<std::string> effects;  // of the answer, and faults named
  std::vector<std::string>
      confidence_set;  // what cannot be told from the first effect, itself included
  // What cannot be told from a later effect, beside those before it: itself first. None of an
  // effect that stands alone.
  std::vector<std::vector<std::string>> sets_beside;
  // Of those of the confidence set that were fitted: the motion that would tell them apart best.
  std::optional<SeparatingMotion> separating;
  std::vector<std::pair<std::string, double>> seconds;  // where the time went
  DiagnosisMotions motions;                             // for pages and pictures
  std::optional<DiagnosisFit> fit;  // none where it was interrupted before there was any
};

}  // namespace clothfit
