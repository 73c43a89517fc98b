// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A point in space from the rays that several cameras see it along.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/camera/plucker_ray.h"

namespace clothfit {

// The mean over the closest points of all pairs of rays (m, world), Hasler 2007, sec. 4:
// p = 1 / (N (N - 1)) sum_i sum_j c_ij, i != j. The paper divides by N, which is right for N = 2
// only: there are N (N - 1) points c_ij. Pairs of parallel rays have none and are left out; empty
// where no pair is left.
std::optional<Eigen::Vector3d> MeanClosestPoint(const std::vector<PluckerRay<double>>& rays);

// Where a camera (index into some list of cameras) sees a point.
struct Sighting {
  int camera = 0;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

struct TriangulationOptions {
  double gate = 3.0;  // px, largest reprojection error of a sighting that agrees
  int min_sightings = 2;
  // rad; two rays under a smaller angle do not make a point
  double min_angle = 0.05;
};

struct Triangulation {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m, world
  std::vector<bool> agrees;                            // one a sighting
  int num_agreeing = 0;
  double reprojection_rms = 0.0;  // px, over the sightings that agree
};

// Reprojection errors (px) of a point in every sighting; infinite behind a camera.
std::vector<double> ReprojectionErrors(const std::vector<Camera>& cameras,
                                       const std::vector<Sighting>& sightings,
                                       const Eigen::Vector3d& position);

// The point that most sightings agree on: the best of all pairs (by the closest points of their
// rays), then the one with the least sum of squared reprojection errors over those that agree
// (Levenberg-Marquardt), until nothing changes. Deterministic; the cost is quadratic in the number
// of sightings. Empty where no pair agrees or fewer than min_sightings do.
std::optional<Triangulation> TriangulateRobustly(const std::vector<Camera>& cameras,
                                                 const std::vector<Sighting>& sightings,
                                                 const TriangulationOptions& options = {});

}  // namespace clothfit
