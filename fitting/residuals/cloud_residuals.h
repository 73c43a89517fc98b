// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far the simulated surface is from points of which nobody knows where on the cloth they are.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/closest_on_mesh.h"
#include "autodiff_sim/mesh/cloth_mesh.h"
#include "fitting/residuals/point_residual.h"
#include "fitting/scene/clouds.h"

namespace clothfit {

struct Scene;

// The distance (m) of a point from the closest of a surface, signed along the triangle's normal
// where the closest point lies inside the triangle. Its derivative by the triangle's particles is
// exact: the closest point's own sliding has none, as it is the closest, and neither has the
// normal's turning (Chen and Medioni 1992). The closest point may jump.
PointResidual DistanceToSurface(const ClosestOnMesh& surface,
                                const std::vector<std::array<int, 3>>& triangles,
                                const Eigen::VectorXd& x, const Eigen::Vector3d& point);

// Two kinds of residuals, in m:
// - of each point of a cloud: its distance to the surface;
// - of each particle: by how much farther it is from the nearest point of the cloud than two
//   spacings of the points, if the cloud should show it: always, or where the camera that saw the
//   cloud sees the particle. That is where it is in the picture and not behind points of the cloud.
// Without the second, cloth that has no points near it would be free to fly.
class CloudResiduals {
 public:
  // coverage: weight of the second kind's squares, of which there are as many as points of the
  // cloud then. The scene must outlive it.
  CloudResiduals(const Scene& scene, double coverage);

  int Count(const CloudObservation& cloud) const;
  // Count(cloud) residuals for particles at x (3N, m, world), first those of the points. Appends.
  void Evaluate(const CloudObservation& cloud, const Eigen::VectorXd& x,
                std::vector<PointResidual>* residuals) const;
  // The first kind alone.
  std::vector<PointResidual> OfPoints(const CloudObservation& cloud,
                                      const Eigen::VectorXd& x) const;

 private:
  PointResidual OfParticle(const CloudObservation& cloud, const Eigen::VectorXd& x,
                           int particle) const;
  bool ShouldShow(const CloudObservation& cloud, const Eigen::Vector3d& place) const;

  const Scene& scene_;
  double coverage_;
  ClosestOnMesh surface_;  // of the initial mesh: its tree's shape
};

}  // namespace clothfit
