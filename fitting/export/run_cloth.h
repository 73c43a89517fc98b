// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The cloth of a run for programs that simulate it themselves: material, rest shape, start, what
// holds it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/export/run_motion.h"

namespace clothfit {

// In quantities of a continuum, which do not go with the mesh. docs/material-elsewhere.md derives
// them, and what other programs make of them.
struct ClothMaterial {
  double density = 0.0;          // kg/m^2
  double stretch = 0.0;          // N/m, tension per width and strain along warp and weft
  double stretch_damping = 0.0;  // N s/m
  double shear = 0.0;            // N/m, shear modulus times thickness
  double shear_damping = 0.0;    // N s/m
  double bending = 0.0;          // N m, of a plate along warp and weft
  double bending_damping = 0.0;  // N m s, of a plate that bends along warp or weft
  double drag_normal = 0.0;      // kg/m^3, air_drag.normal
  // kg/(m^2 s): the drag per area and speed that takes as much energy as the fitted one, over the
  // run's own motion.
  double drag_linear = 0.0;
};

struct PinnedParticle {
  int particle = 0;
  std::string handle;
  int last_frame = 0;  // at which it is held
};

struct RunCloth {
  RunMotion motion;
  ClothMaterial material;
  double spacing = 0.0;                         // m, mean length of the springs along warp and weft
  std::vector<Eigen::Vector3d> rest;            // m, flat, shrunk as the fit has it
  ClothTopology topology;                       // springs, hinges, areas
  Eigen::VectorXd velocity;                     // 3N, m/s, at frame 0
  Eigen::Vector3d gravity = {0.0, 0.0, -9.81};  // m/s^2
  std::optional<double> ground_height;          // m
  double ground_friction = 0.0;                 // 1
  double ground_distance = 0.002;               // m, at which its push begins
  std::vector<PinnedParticle> pins;             // by particle
  std::vector<std::string> left_out;            // one sentence each, for comments in the file
};

// Throws InputError as ReadRunMotion does.
RunCloth ReadRunCloth(const RunFolder& run);

// kg/(m^2 s), see ClothMaterial::drag_linear. `normal`, `saturation`, `tangential`: of air_drag.
double LinearDrag(const RunMotion& motion, double normal, double saturation, double tangential);

}  // namespace clothfit
