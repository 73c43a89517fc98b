// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One fit at one resolution, of one recording or several: windows that grow, then all frames at
// once.
// Behind RunFit and FitByStrategy; nothing else includes it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <ceres/solver.h>

#include "fitting/fit/discretisation.h"
#include "fitting/fit/fit.h"
#include "fitting/fit/frame_by_frame.h"
#include "fitting/fit/recalled_evaluation.h"
#include "fitting/fit/uncertainty.h"
#include "fitting/optimise/simulation_cost.h"
#include "fitting/rollout/joint_rollout.h"
#include "fitting/rollout/shooting_windows.h"

namespace clothfit {

class Fitter {
 public:
  // The arguments must outlive this object. How several recordings are searched is as the first
  // one's config says.
  Fitter(std::vector<NamedScene> scenes, const FitCallbacks& callbacks);
  Fitter(const Scene& scene, const FitConfig& config, const FitCallbacks& callbacks)
      : Fitter({{"", &scene, &config}}, callbacks) {}

  // It stops where what follows changes the cost by more than last iterations would.
  void OnlyComeNear();
  // It begins where a coarser one has ended.
  void BeginNear() { is_near_ = true; }
  // Its result tells noise from the discretisation error (MeasurePoints).
  void TellMisfit() { tells_misfit_ = true; }
  void Begin(const FitCheckpoint* resume);
  // Instead of what follows: fits windows alone, the first most_lengths of num_lengths lengths. See
  // FitForecasts.
  FitResult Forecast(int num_lengths, int most_lengths, const FitCheckpoint* from);
  void Advance(int most_iterations);
  FitResult End();
  // Measures the config's own start for a result; what comes before the fit of all frames must not
  // explain them worse than that.
  void MeasureStart(FitResult* result);
  const Eigen::VectorXd& theta() const { return progress_.theta; }
  // Adds the iterations and the simulated frames so far.
  void AddWorkTo(FitResult* result) const;
  // What is to be said of this free vector, wherever it comes from.
  FitResult At(const Eigen::VectorXd& theta);
  // Where a fit stands whose windows ended at this free vector.
  FitCheckpoint AfterWindows(const Eigen::VectorXd& theta) const {
    return {false, NumStages(), theta};
  }

 private:
  // The relative change of the cost at which nothing worth having is left, where so many residuals
  // say as much as one.
  double PolishTolerance(double correlation) const;
  // Of the residuals at what has been reached; 1 where that is not known.
  double ResidualCorrelation();
  struct Patience {
    int iterations;
    double tolerance;  // relative change of the cost at which to stop
    // Of the trust region after such a step: about that of half a Gauss-Newton step at least.
    double least_radius = 1.0;
    int small_steps = 3;  // in turn, at which to stop whatever the trust region
  };
  // What is to be made small, beside the priors.
  struct Misfits {
    SimulationCost::Evaluator evaluate;
    int num_rows = 0, num_observed = 0;
  };
  struct Minimum {
    ceres::Solver::Summary summary;
    bool converged = false;
  };
  // Levenberg-Marquardt; entries that are held stay as they are.
  Minimum Minimise(const Misfits& misfits, const Patience& patience, double first_radius,
                   const std::vector<int>& held = {});
  // One simulation of frames 0 to last.
  Minimum MinimiseRollout(JointRollout* rollout, int last, const Patience& patience,
                          const std::vector<int>& held = {});
  // Fits windows that grow up to all frames, see ShootingWindows.
  void LengthenWindows();
  void FitPulled(int most_iterations);
  // What comes before the fit of all frames: lengths of windows, or one fit that is pulled at.
  int NumStages() const { return lengths_.empty() ? 1 : static_cast<int>(lengths_.size()); }
  // Finds the paths of unknown handles: all that is unknown is fitted to the first frames, then to
  // more and more of them, each stretch of the paths found frame by frame before. So a path never
  // has to be found from far away, nor with a fabric that the frames before contradict.
  void FindHandlePaths();
  // Of several recordings: each one's by itself.
  void FindHandlePathsApart();
  // Control points of hidden handles' paths that matter only long before a frame.
  std::vector<int> ControlsLongBefore(int frame) const;
  // Frame by frame from the first frame on to the last; beyond it as the prior expects. False where
  // the simulation does not get there.
  bool ContinueHandlePaths(FrameByFrame* search, int first, int last);
  void ToStart();
  bool HasWork() const;
  // All frames at once from here, with derivatives, as at_best_; which is not at theta where they
  // cannot be simulated.
  void Linearise(const Eigen::VectorXd& theta, JointRollout* rollout);
  // Where the fit of all frames begins.
  void StartPolish();
  double Cost(const Eigen::VectorXd& theta, JointRollout* rollout) const;
  // Half the sum of squares of compressed residuals and priors: of all, and of a recording alone.
  double CostOf(const Eigen::VectorXd& residuals, const Eigen::VectorXd& theta) const;
  double CostOf(std::size_t recording, const Eigen::VectorXd& residuals,
                const Eigen::VectorXd& theta) const;
  void Log(const std::string& line) const {
    if (callbacks_.log) callbacks_.log(line);
  }
  double SimulatedFrames() const {
    return rollout_.simulated_frames() + attracting_.simulated_frames() + frames_for_paths_ +
           in_windows_.simulated + recalled_.simulated;
  }
  double DifferentiatedFrames() const {
    return rollout_.differentiated_frames() + attracting_.differentiated_frames() +
           differentiated_for_paths_ + in_windows_.differentiated + recalled_.differentiated;
  }
  // Through the journal, where there is one; named by the stage under way.
  RecalledEvaluation Recalled(RecalledEvaluation::Simulated simulated);
  bool Stopped() const { return callbacks_.stop != nullptr && *callbacks_.stop; }
  void Report(const ceres::IterationSummary& iteration, int rows);
  // By how much of the cost a full Gauss-Newton step from here would lower it, were the problem
  // linear: near 0 at a minimum, also where Levenberg-Marquardt's own small steps have come to
  // rest.
  double ExpectedDecrease(const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian) const;
  // J'J with the priors' own.
  Eigen::MatrixXd Information(const RowMajorMatrix& jacobian) const;
  void Finish(FitResult* result);
  // What is to be said of each of several recordings, after what is said of all.
  void FinishEach(const Uncertainty& uncertainty, const std::optional<JointPointFit>& points,
                  FitResult* result) const;
  // Of a recording, into its own result.
  void FillEstimates(std::size_t recording, const Uncertainty& uncertainty,
                     FitResult* result) const;

  JointScenes scenes_;
  const JointVector& free_;
  const FitConfig& config_;  // the first one's
  const FitCallbacks& callbacks_;
  JointRollout rollout_, attracting_;
  std::vector<WindowLength> lengths_;  // of windows; none where all frames are fitted at once
  FitCheckpoint progress_;
  Eigen::VectorXd best_;  // of the stage under way
  double best_cost_ = 0.0;
  // All frames simulated open loop, with derivatives: the newest of the stage under way, and that
  // of its best.
  struct Linearisation {
    Eigen::VectorXd theta, residuals;
    RowMajorMatrix jacobian;
    StepReport steps;
    bool IsAt(const Eigen::VectorXd& point) const {
      return residuals.size() > 0 && theta.size() == point.size() && theta == point;
    }
  };
  Linearisation newest_, at_best_;
  std::string stage_;
  double stage_begin_ = 0.0, stage_share_ = 0.0;  // of the whole fit's work
  int iterations_ = 0, of_polish_ = 0;
  // Simulated frame by frame, and those of them with derivatives.
  double frames_for_paths_ = 0.0, differentiated_for_paths_ = 0.0;
  struct {
    double simulated = 0.0, differentiated = 0.0;  // frames
    double cost = std::numeric_limits<double>::infinity();
    bool converged = false;
    Eigen::VectorXd residuals;
  } in_windows_;  // where asked for, of the longest
  FrameCounts recalled_;
  bool has_begun_polish_ = false, converged_ = false;
  double cost_ = std::numeric_limits<double>::infinity();
  double cost_before_ = std::numeric_limits<double>::infinity();
  struct Start {
    Evaluation evaluation;
    double cost = std::numeric_limits<double>::infinity();
  };
  std::vector<Start> starts_;  // of the recordings, where they were measured
  double polish_tolerance_;
  double radius_ = 0.0;  // of the trust region that the polish has come to; 0 before
  int most_lengths_ = std::numeric_limits<int>::max();  // of windows
  bool is_near_ = false, only_comes_near_ = false, only_forecasts_ = false, tells_misfit_ = false;
};

}  // namespace clothfit
