// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the trials' second generator is told: a fabric and the effects planted into it, under the
// names that clothfit gives them, as coefficients of finite elements.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/trials/finite_elements/mesh.h"

namespace clothfit {

constexpr int kThreadPieces = 50;  // along the cloth's diagonal

// Full names -> values; what is not there has no effect.
using FemParameters = std::map<std::string, double>;

// Can the second generator plant this term?
bool FemKnows(const std::string& term);

// Coefficients of one set of parameters, SI units.
struct FemLaws {
  struct Membrane {     // of a triangle
    double warp, weft;  // N/m
    double shear;       // N/m
  };
  std::vector<Membrane> membranes;
  std::vector<double> plates;                             // N m, of the vertices of LaplaciansOf
  double stretch_viscosity = 0.0, shear_viscosity = 0.0;  // N s/m
  double bending_delay = 0.0;                             // s, viscosity over stiffness
  double cubic = 0.0, cubic_onset = 0.0;
  double stretch_share = 0.0, shear_share = 0.0;  // that relax
  double stretch_time = 1.0, shear_time = 1.0;    // s
  double shear_friction = 0.0, shear_onset = 1.0;
  double thread_stiffness = 0.0, thread_gather = 0.0, thread_piece = 1.0;  // N, 1, m
  std::vector<double> mass, extra_mass;  // kg of each vertex: of the fabric, and on top of it
  // Does anything depend on more than the present state?
  bool HasMemory() const {
    return stretch_share != 0.0 || shear_share != 0.0 || shear_friction != 0.0;
  }
  double added_mass = 0.0;  // kg/m^2
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  double drag_normal = 0.0, drag_saturation = 0.0, drag_tangential = 0.0;
  // m/s, of the air over a place of the cloth; all of them add up.
  using Air = std::function<Eigen::Vector3d(const Eigen::Vector3d& place, const Eigen::Vector2d& uv,
                                            double time)>;
  std::vector<Air> air;
  // Pa, of obstacles, attractors and the like.
  using Outside =
      std::function<Eigen::Vector3d(const Eigen::Vector3d& place, const Eigen::Vector3d& velocity)>;
  std::vector<Outside> outside;
};

FemLaws MakeFemLaws(const FemMesh& mesh, const Eigen::Vector2d& size,
                    const FemParameters& parameters);

// The same without the terms' effects.
FemParameters WithoutTerms(const FemParameters& parameters, const std::vector<std::string>& terms);

}  // namespace clothfit
