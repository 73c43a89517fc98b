// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings of a cloth that swings between two hands and feels something that its model lacks.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "fitting/diagnosis/locate/residual_force.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/scene/scene.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

// An even force on a rectangle of the cloth from one frame to another, along world axes.
struct PlantedForce {
  Eigen::Vector2d low_uv = {0.0, 0.0}, high_uv = {0.0, 0.0};  // m
  int first_frame = 0, last_frame = -1;                       // inclusive
  double along_normal = 0.0;                                  // N/m^2
};

struct DiscrepancyProblemOptions {
  std::map<std::string, double> missing;  // parameters of the truth that the model has off
  PlantedForce planted;
  bool tracks_only = false;                     // of three cameras; else markers
  bool held = false;                            // what was seen pulls at the cloth (IsNudged)
  Eigen::Vector2d shifted_camera = {0.0, 0.0};  // px, by which camera 1's tracks are off
  int particles = 7;                            // along each side of 0.4 m
  int frames = 48;                              // at 60 Hz
  std::uint64_t seed = 1;
};

// With the truth of all that is not missing for a baseline; two of the fabric's parameters are
// free.
struct DiscrepancyProblem {
  FitConfig config;
  Scene scene;
  std::unique_ptr<FreeParameters> free;
  Eigen::VectorXd theta;
  std::vector<Eigen::VectorXd> true_x;  // m, by frame
};
DiscrepancyProblem MakeDiscrepancyProblem(const DiscrepancyProblemOptions& options);

// Residuals of recordings in which nothing is missing, as the problem's model moves, one a column.
// Markers and tracks only.
Eigen::MatrixXd NoiseNulls(const DiscrepancyProblem& problem, int count, std::uint64_t seed);

// Area that two rectangles share over the area of both.
double IntersectionOverUnion(const Eigen::Vector2d& low1, const Eigen::Vector2d& high1,
                             const Eigen::Vector2d& low2, const Eigen::Vector2d& high2);

}  // namespace clothfit
