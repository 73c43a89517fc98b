// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Multiple shooting (Bock and Plitt 1984): windows of a recording that are simulated each by
// itself, from the state that a nudged motion has at its first frame. A short window has no time to
// be led astray by wrong parameters or by chaos, so that the cost is smooth far from its minimum;
// windows that grow follow the minimum to that of all frames (quasi-static variational
// assimilation: Pires, Vautard and Talagrand 1996).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "fitting/rollout/joint_scenes.h"
#include "fitting/rollout/window_cost.h"

namespace clothfit {

// Does a config ask for windows, and is there anything to nudge a motion to?
bool FitsWindows(const Scene& scene, const FitConfig& config);

// The lengths (frames) of windows that a fit goes through before all frames: the config's, then
// twice as long each. None where it has none.
std::vector<int> WindowLengths(const Scene& scene, const FitConfig& config);

// A window of frames and the state that it begins with: that of the nudged motion, or (frame 0) the
// recording's own start, which moves with the free vector.
struct LaidWindow {
  int first_frame = 0;      // of the simulation
  int first_row_frame = 0;  // and last: whose observations it is held to
  int last = 0;
  State state;
};

// Simulates the motion that is nudged at the rate of a tenth of a window and lays windows of so
// many frames along it, up to the last fitted frame. Empty where it cannot be simulated, where
// nothing can nudge it, or where it is stopped. simulated_frames: what it took is added.
std::vector<LaidWindow> LayWindows(const Scene& scene, const FitConfig& config,
                                   const FreeParameters& free, const Eigen::VectorXd& theta,
                                   int frames, const std::atomic<bool>* stop,
                                   double* simulated_frames);

// A length of windows that a fit goes through, and how many frames of each recording that are.
struct WindowLength {
  double seconds = 0.0;
  std::vector<int> frames;
};

// Those of all recordings, the shortest first: each has its own lengths, and beyond them all of its
// frames in one window. None where no recording has any.
std::vector<WindowLength> WindowLengths(const JointScenes& scenes);

class ShootingWindows {
 public:
  // The arguments must outlive it.
  ShootingWindows(const JointScenes& scenes, const std::atomic<bool>* stop);

  // Lays windows of so many frames along each recording, see LayWindows; one window where that is
  // all of them. False where there are none.
  bool Lay(const Eigen::VectorXd& theta, const std::vector<int>& frames);
  int size() const { return static_cast<int>(windows_.size()); }
  // Of each window as many as its recording has free entries and one more, see
  // WindowRows::kCompressed.
  int NumResiduals() const;

  // Residuals of all windows and, where asked for, their Jacobian, by all cores; the same numbers
  // for any of them. False where a window cannot be simulated. The first window of a recording
  // moves with the offsets of its initial state; the others' states stay as they were laid.
  bool Evaluate(const Eigen::VectorXd& theta, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian);
  // All residuals, recording after recording, each in the order of ObservationResiduals; empty
  // where a window cannot be simulated.
  Eigen::VectorXd Residuals(const Eigen::VectorXd& theta);

  double simulated_frames() const;
  double differentiated_frames() const;

 private:
  struct Window {
    std::size_t recording = 0;
    LaidWindow laid;
    WindowStart start;
    KnownMotion motion;
  };
  bool LayAlong(std::size_t recording, const Eigen::VectorXd& theta, int frames);
  // Simulates all windows, by all cores: rows(i, residuals, jacobian) gets what comes of each.
  bool EvaluateAll(
      const Eigen::VectorXd& theta, WindowRows kind, bool derivatives,
      const std::function<void(int, const Eigen::VectorXd&, const RowMajorMatrix&)>& rows);
  WindowSimulator& SimulatorOf(const Window& window, int worker) {
    return *simulators_[static_cast<std::size_t>(worker) * scenes_.size() + window.recording];
  }

  const JointScenes& scenes_;
  const std::atomic<bool>* stop_;
  int num_workers_;
  std::vector<std::unique_ptr<WindowSimulator>> simulators_;  // one a core and recording
  std::vector<Window> windows_;
  double nudged_frames_ = 0.0;
};

}  // namespace clothfit
