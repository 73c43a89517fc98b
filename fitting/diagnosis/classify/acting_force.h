// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where, when and how the force of known terms acts along a motion: of what was planted into a
// trial, and of what a diagnosis has named.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "autodiff_sim/step/cloth_model.h"
#include "fitting/diagnosis/fitted/rows.h"

namespace clothfit {

struct ActingForce {
  bool acts = false;
  // Box on the cloth, m: along either side where the middle four fifths of the force are (rms over
  // time), and a quarter longer about its middle, so that of an even force it is where that acts.
  Eigen::Vector2d low_uv = Eigen::Vector2d::Zero(), high_uv = Eigen::Vector2d::Zero();
  // The frames that hold all but a hundredth of the force (rms over the cloth) at either end, found
  // in the same way.
  int first_frame = 0, last_frame = 0;
  double peak = 0.0;  // N/m^2, rms over time where it is largest
  // World; the mean over time of the net force, over the mean of the sum of all parts' lengths: 1
  // where all parts point one way all the time.
  Eigen::Vector3d mean_direction = Eigen::Vector3d::Zero();
  // The same of the net force and of the net moment about the middle, each rms over time: 0 of what
  // the cloth does to itself.
  double net_force_share = 0.0, net_moment_share = 0.0;
  double work_in = 0.0;   // J, where it gave energy to the cloth
  double work_out = 0.0;  // J, where it took some, positive
};

// Sums up a force over a motion.
class ForceMeter {
 public:
  ForceMeter(std::vector<double> areas, int frame_count);  // m^2 of each particle
  // force: 3N, N; x, v: 3N, m and m/s; `step` (s): how long it acts so.
  void Add(int frame, const Eigen::VectorXd& force, const Eigen::VectorXd& x,
           const Eigen::VectorXd& v, double step);
  ActingForce Result(const ClothMesh& mesh) const;

 private:
  void FindRegion(const ClothMesh& mesh, ActingForce* result) const;
  void FindFrames(ActingForce* result) const;

  std::vector<double> areas_;
  std::vector<double> of_frames_;  // sum of squared forces, N^2
  Eigen::VectorXd of_particles_;   // sum of squared forces per area, (N/m^2)^2
  Eigen::Vector3d net_ = Eigen::Vector3d::Zero();
  double net2_ = 0.0, moment2_ = 0.0, parts_ = 0.0, parts2_ = 0.0, part_moments2_ = 0.0;
  double work_in_ = 0.0, work_out_ = 0.0;
  int num_steps_ = 0;
};

// The force with these parameters (full names) as they are less that with all of them off, 3N, N.
Eigen::VectorXd ForceOfParameters(const ClothModel& model, const ForcePoint& at,
                                  const std::vector<std::string>& names);

// Full names of what switches these terms, or single parameters, on.
std::vector<std::string> SwitchesOf(const std::vector<std::string>& effects);

// Of terms, or of single parameters by their full names, that a fitted model has on, at every
// fitted frame; other names are of nothing that acts. Empty where it cannot be simulated.
std::optional<ActingForce> MeasureActingForce(const FittedScene& fitted,
                                              const std::vector<std::string>& effects);

}  // namespace clothfit
