// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Searches for what explains a recording, by any optimiser and strategy, all judged by the same
// error.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/fit/fit.h"
#include "fitting/optimise/optimiser.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// The best so far, when this much had been spent.
struct SearchPoint {
  double simulations = 0.0, seconds = 0.0;
  double error = 0.0;  // SynthesisError over all fitted frames
};

struct SearchOptions {
  Eigen::VectorXd start;     // a free vector; empty: the config's
  bool fabric_only = false;  // of a joint search: the rest stays as it starts
  double step_scale = 1.0;   // of first steps
  // Fitted markers and rays pull at the cloth in all that is simulated and judged, see
  // AddAttractionTargets. Not for the joint search by Levenberg-Marquardt.
  bool attract = false;
  Budget budget;  // evaluations: simulations of the whole recording, those with derivatives at cost
  unsigned seed = 1;
  int num_threads = 1;  // of pattern search
  // Points that pattern search has under way at a time, which decides its course; at least one a
  // thread.
  int under_way = 1;
  // What a simulation with derivatives along all of the free vector costs, in simulations without.
  double derivative_cost = 2.0;
  const std::atomic<bool>* stop = nullptr;
  // What has been spent and the best error so far, after every evaluation; one call at a time.
  std::function<void(const SearchPoint&)> progress;
  std::function<void(const Eigen::VectorXd& theta)> improved;  // of joint searches
  // As in FitCallbacks; not of one loop, nor of the joint search by Levenberg-Marquardt.
  EvaluationJournal* journal = nullptr;
  std::function<void(const std::string&)> log;
};

struct SearchResult {
  // The free vector found; of passes frame by frame with splines through their paths and, with one
  // loop, the mean fabric.
  Eigen::VectorXd theta;
  // SynthesisError over the fitted frames: of what the strategy itself simulated, whose positions
  // (3N, m) of frames 0 to the last are these, and of theta, simulated from the start with nothing
  // in its way. Infinite where the simulation does not get there.
  double error = 0.0, open_loop_error = 0.0;
  std::vector<Eigen::VectorXd> positions;
  std::vector<SearchPoint> history;  // one entry each time that the best improved
  double simulations = 0.0, seconds = 0.0;
  bool converged = false;
  std::string reason;  // why it ended, in words
};

// By the strategy and the optimiser of the config, from the config's values. The joint search by
// Levenberg-Marquardt is RunFit, on the soft error; every other optimiser gets the hard error
// itself. Two loops by Levenberg-Marquardt have it inside and BOBYQA outside. First steps: half a
// logarithm (a factor of 1.6) or half a sigma of the prior along the fabric's parameters, 5 cm
// along a path's control points. Throws InputError where the optimiser does not suit the strategy.
SearchResult Search(const Scene& scene, const FitConfig& config, const SearchOptions& options);

// A whole fit with report and intervals, by whatever the config asks for: that of
// FitFromTwoStarts, followed where it stalls by a search of the fabric on the hard error; or
// Search. Of markers and tracks it tells noise from the discretisation error (MeasurePoints).
FitResult FitByStrategy(const Scene& scene, const FitConfig& config,
                        const FitCallbacks& callbacks = {});

// A fit and its mesh.
struct FitOnMesh {
  std::shared_ptr<const Scene> scene;  // where the fit has chosen another than it was given
  FitConfig config;                    // names the mesh that was chosen
  FitResult result;
};

// FitByStrategy, and then again on finer and finer meshes (FinerSide), each fit from where the one
// before ended, until no more of the discretisation error is in the residuals than half the noise,
// or the mesh is the finest that the config allows. Only where the config gives no resolution, the
// cloth is a grid, and the fit has come to rest and has a misfit; the result says so. No
// checkpoints are told of.
FitOnMesh FitOnChosenMesh(const Scene& scene, const FitConfig& config,
                          const FitCallbacks& callbacks = {});

}  // namespace clothfit
