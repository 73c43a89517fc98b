// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What physics a recording shows that the simulation lacks: where and when the two differ, what
// class of effect that is, which one, how much of it, what else it could be, and whether frames
// that no fit has seen are predicted better with it. docs/diagnosis.md tells the method.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "fitting/config/config.h"
#include "fitting/diagnosis/acting_force.h"
#include "fitting/diagnosis/diagnosis_motions.h"
#include "fitting/diagnosis/separating_motion.h"
#include "fitting/fit/fit.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// Where in the pipeline a part of the answer comes from can be switched off to see what it is
// worth.
struct DiagnosisOptions {
  // Terms that are not looked for, whatever the recording has.
  std::vector<std::string> excluded;
  int max_effects = 3;  // that are added one after the other
  int max_models = 4;   // candidates that are fitted in earnest, each time
  // Particles a side, at most; finer ones take longer and tell more, as a coarse mesh errs like a
  // draught. A recording's own mesh is made coarser where it is finer.
  int finest_side = 13;
  int num_nulls = 400;            // residuals drawn of the re-simulated null
  double false_discovery = 0.05;  // expected share of false ones among those short-listed
  double least_share = 0.1;  // of the unexplained residual; below it a candidate is no explanation
  double held_out_share =
      1.0 / 3.0;  // of the frames, at the end, where the recording holds none out
  std::uint64_t seed = 1;
  // Ablations.
  bool project = true;  // candidates compete after the baseline and the faults took their part
  bool simulate_null = true;  // false: chi-squared tables
  bool prove = true;          // false: keep what fits better, held-out frames or not
  bool guide = true;          // false: no scores along a guided motion
  std::function<void(const std::string& stage, double fraction)> progress;
  std::function<void(const std::string&)> log;
  const std::atomic<bool>* stop = nullptr;
  // Where finished fits are kept, see fit_runner.h; empty: nowhere.
  std::filesystem::path kept_fits;
};

enum class CandidateKind { kPhysics, kObservation };

struct EffectParameter {
  std::string name, unit;  // "wind.x", "m/s"
  double value = 0.0;
  double lower90 = 0.0, upper90 = 0.0;
};

// One candidate in the score test.
struct Candidate {
  std::string name;  // a term's, or a fault's: "camera 2: pose", "clock", "marker offsets"
  CandidateKind kind = CandidateKind::kPhysics;
  // First-order estimates at the best of the places and times that were tried.
  std::vector<EffectParameter> parameters;
  double score = 0.0;      // decrease of the sum of squares (in sigmas) that it promises
  double raw_score = 0.0;  // the same with nothing projected out
  double share = 0.0;      // score over the sum of squares that the baseline leaves
  double p_value = 1.0;    // against the re-simulated null
  double q_value = 1.0;    // after false-discovery control
  // Along a guided motion (guided_ranking.h), of those that stand out there.
  std::optional<double> guided_p_value;
  // Amount of the first parameter's vector that the null passes for in 1 of 20 recordings, in its
  // unit: less of it cannot be told from nothing here.
  double detection_limit = 0.0;
  bool is_short_listed = false;
  std::string why_not;  // where it is not
};

// Open-loop prediction of frames that the fit has not seen, root mean squares (m; px where there
// are no markers, or where a camera's fault is proven by what that camera tracks).
struct HeldOutProof {
  double before = 0.0, after = 0.0;
  double improvement_lower95 = 0.0;  // of before - after, by a block bootstrap
  double noise = 0.0;                // what the observations' noise alone comes to
  double floor = 0.0;                // what mesh, step and noise alone may make of `before`
  bool is_proven = false;
  bool is_in_pixels = false;
  // Of a fault of one source: the errors are its own alone, along a motion that follows whatever
  // else was seen in those frames, not a prediction's.
  bool is_against_others = false;
  // Where those frames tell nothing: the second half of the fitted ones, predicted after fits to
  // the first half.
  std::optional<Splits::FrameRange> earlier;
  // Where mesh and step may err by more than the improvement: the most that such a model gains in
  // fitted frames of recordings of the baseline alone, of what it gains in these. `floor` holds
  // what it gains in the prediction of those recordings then.
  std::optional<double> gain_of_null;
};

// A candidate switched on and everything fitted again.
struct Model {
  std::vector<std::string> effects;         // all that are on, the newest last
  FitConfig config;                         // an ordinary config: simulate, fit and predict take it
  std::vector<EffectParameter> parameters;  // the effects'
  double cost = 0.0;                        // half the sum of squares, of fitted frames
  double explained = 0.0;                   // share of the excess cost of the baseline that is gone
  HeldOutProof proof;
  bool is_kept = false;
};

enum class Verdict {
  kNothingMissing,    // the baseline explains the recording within its numerical floor
  kNamed,             // effects are kept
  kObservationFault,  // the only thing wrong is the observation
  kNoneOfTheAbove,    // something is missing, and no candidate explains most of it
  kUndecided,         // the baseline's fit came to no minimum, so what it leaves tells nothing
  kInterrupted,
};
std::string ToString(Verdict verdict);

// Of what class the missing force is, each with how sure that is.
struct MismatchClass {
  // Shares of the missing force's work: 1 for what is certain.
  bool is_internal = false;       // no net force, no net moment over the cloth
  bool is_internal_known = true;  // false: it may be internal or come from outside
  bool is_dissipative = false;    // takes energy out wherever it acts
  bool is_driving = false;        // puts energy in
  double net_force_sigmas = 0.0, net_moment_sigmas = 0.0;  // how far each is from nothing
  double power = 0.0, power_sigma = 0.0;                   // W, mean over the time where it acts
  std::string tied_to;  // "world", "material", "contact", "clock" or empty where it cannot be told
  std::string words;    // one sentence
};

// What was learned where no effect explains what is missing.
struct Law {
  Model model;          // with its coefficients as parameters
  std::string formula;  // with units and range
};

// Where and when a force is missing.
struct Mismatch {
  bool is_significant = false;  // against the re-simulated null
  double p_value = 1.0;
  int first_frame = 0, last_frame = 0;  // inclusive
  Eigen::Vector2d low_uv, high_uv;      // m, corners of the region on the cloth
  Eigen::Vector3d direction;            // world, unit; mean over region and time
  double peak = 0.0, peak_sigma = 0.0;  // N/m^2, where and when it is largest
  double even = 0.0, even_sigma = 0.0;  // N/m^2, of the even force on the region that explains most
  std::string words;
};

// Of what class the terms of a named effect are, measured by their own force.
struct ActingClass {
  bool is_internal = false;  // no net force, no net moment
  bool is_dissipative = false, is_driving = false;
  std::string words;  // where, when and how they act: one or two sentences
};

// Pictures of the missing force, 8-bit BGR: its map over the cloth and time, and its arrows on the
// cloth.
struct MismatchPictures {
  cv::Mat map, cloth;
};

struct Diagnosis {
  Verdict verdict = Verdict::kNothingMissing;
  std::string words;  // the answer as a paragraph
  FitConfig baseline;
  FitResult baseline_fit;
  double residual_rms = 0.0;  // of the baseline's fit, in sigmas
  double floor_rms = 0.0;     // that mesh and step leave, in sigmas
  double gate_p_value = 1.0;  // of the whole residual against the null
  // What is left when the observation's faults have taken their part, in sigmas: of the recording,
  // and of every draw of the null.
  double left_rms = 0.0;
  std::vector<double> null_left_rms;
  double promised = 0.0;  // share of the cost that a full step of the baseline's fit would take
  // Particles a side of a mesh that would show more, where the finest that was allowed
  // (`DiagnosisOptions::finest_side`) leaves more than noise does; 0: none.
  int finer_side = 0;
  std::optional<Mismatch> mismatch;
  std::optional<MismatchClass> mismatch_class;
  std::optional<MismatchPictures> mismatch_pictures;
  // Where, when and how the physics of the answer acts: its terms' force in the fitted model.
  std::optional<ActingForce> acting;
  std::optional<ActingClass> acting_class;
  std::vector<Candidate> ranking;      // best first
  std::vector<Model> models;           // all that were fitted
  std::optional<Model> answer;         // the last that was kept, or the law's
  std::optional<Law> law;              // where one was learned and proven
  std::vector<std::string> effects;    // of the answer, and faults named
  std::vector<std::string> ambiguity;  // what cannot be told from the first effect, itself included
  // Of those that were fitted: the motion that would tell them apart best.
  std::optional<SeparatingMotion> separating;
  std::vector<std::pair<std::string, double>> seconds;  // where the time went
  DiagnosisMotions motions;                             // for pages and pictures
};

// p-value of what the baseline leaves below which something is missing.
inline constexpr double kGate = 0.01;
// Share of the cost that a full step may promise of a fit that has come to rest.
inline constexpr double kAtMinimum = 0.05;

// Fits the baseline and goes through the eight steps. Throws InputError where the recording cannot
// be fitted at all.
Diagnosis Diagnose(const Recording& recording, const FitConfig& baseline,
                   const DiagnosisOptions& options = {});

}  // namespace clothfit
