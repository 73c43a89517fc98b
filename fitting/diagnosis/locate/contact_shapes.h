// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an obstacle that no one told of would stand. What a contact does to a cloth points along
// the obstacle's outward normal, where the cloth is at a place that is fixed in the world, and
// nowhere else: among all planes, edges of tables, balls and bars, those whose push explains most
// of the missing force.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "fitting/diagnosis/evidence/candidates.h"
#include "fitting/diagnosis/locate/residual_force.h"

namespace clothfit {

struct ContactShape {
  std::string term;  // obstacle_plane, obstacle_table, obstacle_sphere or obstacle_capsule
  Probe probe;       // its shape, as the term has it
  double score;      // by how much its push lowers the sum of squares, in units of the noise
};

// The best few of each kind, the best first; none where no push outwards explains anything.
//
// An obstacle pushes what is within 2 cm of its surface, or beyond it, along its normal with one
// pressure a times a share that grows over these 2 cm. With p that pattern for a = 1 in the
// missing force's own coefficients (force_layout.h), N and b their equations, and nu the noise, the
// best pressure lowers the sum of squares by (b'p)^2 / (p'Np nu^2), and counts where it is
// positive. There is no cloth inside of an obstacle: the score is 1 - i/o of that, i the cloth
// (area times time) that would be deeper than 2 cm, o the rest of what is pushed. Shapes are looked
// for on a grid over all places where the cloth comes and then by Nelder and Mead's simplex. mesh:
// the one that the force was estimated on; gravity in m/s^2.
std::vector<ContactShape> FindContactShapes(const ClothMesh& mesh, const Eigen::Vector3d& gravity,
                                            const MissingForce& missing);

// obstacle_capsule with its middle where a ball's is and as thick, level, in four directions;
// reach: how far it goes on either way, m.
std::vector<Probe> BarsThroughBall(const Probe& ball, const Eigen::Vector3d& gravity, double reach);

}  // namespace clothfit
