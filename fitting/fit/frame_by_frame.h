// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One pass through a recording that finds, frame by frame, where the unknown handles are: the inner
// loop of Hasler et al. 2007, sec. 5, and, with the fabric's parameters among the unknowns of each
// frame, the one loop of sec. 6.1.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/step/simulation.h"
#include "fitting/optimise/optimiser.h"
#include "fitting/residuals/observation_residuals.h"
#include "fitting/residuals/synthesis_error.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/path_guess.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct FrameByFrameOptions {
  std::string optimiser = "pattern";  // of each frame
  bool fabric = false;                // the free parameters are unknowns of each frame too
  double tolerance = 0.05;            // of derivative-free optimisers, in first steps
  int max_evaluations = 200;          // of one frame
  bool attract = false;  // fitted markers and rays pull at the cloth, see AddAttractionTargets
};

// What a pass through the recording found.
struct FrameByFrameResult {
  bool complete = false;
  double error = 0.0;                         // SynthesisError over all frames, as it was reached
  std::vector<std::vector<PathPoint>> paths;  // by handle; of known ones empty
  Eigen::VectorXd theta;                      // with fabric: the mean over the frames
  std::vector<Eigen::VectorXd> positions;     // 3N, m, of the first frame and each after it
  double simulated_frames = 0.0;              // those with derivatives among them
  double differentiated_frames = 0.0;         // those, each as its share of the free vector
};

class FrameByFrame {
 public:
  // The arguments must outlive it. Between two frames an unknown handle moves in a straight line.
  FrameByFrame(const Scene& scene, const FitConfig& config, const FreeParameters& free,
               const FrameByFrameOptions& options, const std::atomic<bool>* stop);

  // Frames 0 to the last fitted one, with the physical parameters of theta (a free vector; its
  // handle paths are not looked at). In each frame the search begins where the handles' motion
  // leads.
  FrameByFrameResult Run(const Eigen::VectorXd& theta);
  // The frames after first to last only, from the state at the first one. There, unknown handles
  // are where the paths of theta have them, and move as those do. The error leaves out the first
  // frame.
  FrameByFrameResult Continue(const Eigen::VectorXd& theta, const State& state, int first,
                              int last);

 private:
  bool Simulate(const Eigen::VectorXd& unknowns, State* state, Sensitivity* sensitivity);
  StepInputs Inputs(double time, const Eigen::VectorXd& unknowns, bool with_directions) const;
  Objective MakeObjective();
  bool Residuals(const Eigen::VectorXd& unknowns, Eigen::VectorXd* residuals,
                 RowMajorMatrix* jacobian);
  // Sets out from a frame: its state, where the unknown handles are and where they were a frame
  // before.
  void Begin(const Eigen::VectorXd& theta, const State& state, int frame,
             const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& before);
  bool FitFrame();
  FrameByFrameResult FitFrames(int last);

  const Scene& scene_;
  const FreeParameters& free_;
  FrameByFrameOptions options_;
  const std::atomic<bool>* stop_;
  SynthesisError error_;
  ObservationResiduals observations_;
  Simulation simulation_;
  std::vector<int> unknown_handles_;  // indices of the scene's handles
  std::vector<int> fabric_;           // entries of the free vector that each frame fits
  double motion_sigma_;               // m, of a handle from where its motion leads

  // The frame at hand.
  int frame_ = 0;
  State state_;                        // at the frame before
  std::vector<Eigen::Vector3d> from_;  // unknown handles there
  Eigen::VectorXd expected_;           // unknowns: where the motion leads, and the fabric
  Eigen::VectorXd theta_;
  FrameByFrameResult result_;
};

}  // namespace clothfit
