// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits a simulated cloth to a recording by Levenberg-Marquardt through the differentiated
// simulation.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/config/config.h"
#include "fitting/fit/misfit.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/scene.h"

namespace clothfit {

enum class FitStatus {
  kConverged,     // Levenberg-Marquardt stopped because nothing improves any more
  kNotConverged,  // it used up its iterations
  kInterrupted,   // the result is the best so far
  kFailed,        // the simulation fails already at the start
};
std::string ToString(FitStatus status);

// Where a fit stands; can be written to disk and gone on from.
struct FitCheckpoint {
  bool coarse = false;    // of the fit with a coarser grid, that goes first
  int next_window = 0;    // lengths of windows that are done; all when only the polish is left
  Eigen::VectorXd theta;  // best so far
};

struct FitProgress {
  std::string stage;  // "window 3 of 12 (frames 241-360)", "all frames"
  int iteration = 0;  // of this stage
  double cost = 0.0;  // half the sum of squared residuals, this stage
  double rms = 0.0;   // root mean square of this stage's residuals, in their sigmas
  // Of a search without derivatives, whose iterations are simulations and whose cost the hard
  // error: what to say of them.
  std::string detail;
  double fraction = 0.0;  // of the whole fit, an estimate
  // So far, and how many of them with derivatives, each as the share of the unknowns that had moved
  // anything by then.
  double simulated_frames = 0.0, differentiated_frames = 0.0;
};

class EvaluationJournal;  // fitting/files/evaluation_journal.h
struct FitResult;

struct FitCallbacks {
  std::function<void(const FitProgress&)> progress;
  std::function<void(const FitCheckpoint&)> checkpoint;  // after every accepted step
  std::function<void(const std::string&)> log;           // lines for the log
  const std::atomic<bool>* stop = nullptr;               // set from outside to end early
  // What the same fit evaluated before it was interrupted, and evaluates now; null: nothing is
  // kept.
  EvaluationJournal* journal = nullptr;
  std::function<void(const std::string&)> note;  // lines for who waits, of fits into a run
  // A whole fit, while it is tried whether another start or mesh explains more.
  std::function<void(const Scene&, const FitConfig&, const FitResult&)> stands;
};

// How well one simulation of all frames explains the observations. Open loop: only the handles
// drive it.
struct Evaluation {
  bool complete = false;  // the simulation reached the last frame
  int frames = 0;         // simulated
  // Root mean square distance of markers (m) and tracks (px), over the fitted and the held-out
  // frames; empty where there are none. Markers are compared where they best sit on the cloth, as
  // far as noise.layout lets them.
  std::optional<double> marker_rms, held_out_marker_rms, track_rms, held_out_track_rms;
  // Root mean square distance (m) of clouds' points from the surface.
  std::optional<double> cloud_rms, held_out_cloud_rms;
  // Pixels in which simulated and measured silhouettes differ, mean over the pictures.
  std::optional<double> silhouette_error, held_out_silhouette_error;
  // m along u and v, by id: where fitted frames have markers beside their given place; none where
  // noise.layout is not given.
  std::map<int, Eigen::Vector2d> marker_shifts;
};

struct ParameterEstimate {
  std::string name, unit;
  double value = 0.0, start = 0.0;
  bool free = false;
  double lower95 = 0.0, upper95 = 0.0;  // where free
  bool determined = true;               // by the data, rather than by its prior
  bool at_bound = false;
};

struct FitResult {
  FitStatus status = FitStatus::kFailed;
  Eigen::VectorXd theta;
  Eigen::VectorXd parameters;  // all physical ones, in the table's order
  int iterations = 0;
  int simulations = 0;                 // of any length, counted in whole recordings, rounded up
  double simulated_frames = 0.0;       // in all, with and without derivatives
  double differentiated_frames = 0.0;  // those with, as in FitProgress
  double seconds = 0.0;
  double cost_before = 0.0, cost_after = 0.0;  // all fitted frames, open loop, with priors
  Evaluation before, after;
  std::vector<ParameterEstimate>
      estimates;  // every physical parameter, then the other free entries
  // Plain statements on what the data leave open and what the fit came to, one a line.
  std::vector<std::string> statements;
  double noise_factor = 1.0;  // residuals over their stated sigmas; above 1 it widens the intervals
  std::optional<Misfit>
      misfit;        // of markers and tracks; of whole fits (FitByStrategy, AppraiseFit) alone
  StepReport steps;  // halvings and the like, summed over the last simulation
  // Of a fit of several recordings (FitJointly): what is to be said of each.
  std::vector<FitResult> recordings;
};

// Iterations, simulations and seconds of another fit, which it took as well.
void AddWork(const FitResult& other, FitResult* result);

// Every physical parameter at theta, then the other free entries. Their intervals are not known:
// NaN.
std::vector<ParameterEstimate> EstimatesAt(const FreeParameters& free,
                                           const Eigen::VectorXd& theta);

// Those of a part of a fit, without notes: from there on, of this share of the whole. `name`
// goes before what it tells.
FitCallbacks OfPart(const FitCallbacks& callbacks, const std::string& name, double from,
                    double share);

// Runs the fit. `resume` goes on from a checkpoint of the same scene and config. tells_misfit: with
// a misfit of markers and tracks, and intervals that hold the discretisation error, see
// AppraiseFit.
FitResult RunFit(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks = {},
                 const FitCheckpoint* resume = nullptr, bool tells_misfit = false);

// A fit of all frames from where one on a coarser mesh has ended, with its misfit.
FitResult GoOnFitting(const Scene& scene, const FitConfig& config, const Eigen::VectorXd& theta,
                      const FitCallbacks& callbacks = {});

// What a whole fit would say of theta, without any fitting: errors, intervals with what mesh and
// step do to them, and the misfit of markers and tracks.
FitResult AppraiseFit(const Scene& scene, const FitConfig& config, const Eigen::VectorXd& theta);

// One open-loop simulation of frames 0 to last_frame. observer(frame, state) is called for every
// frame. Returns the number of frames reached, last_frame + 1 where all went well.
int SimulateFrames(const Scene& scene, const FitConfig& config, const FreeParameters& free,
                   const Eigen::VectorXd& theta, int last_frame,
                   const std::function<void(int frame, const State& state)>& observer,
                   StepReport* steps = nullptr);

}  // namespace clothfit
