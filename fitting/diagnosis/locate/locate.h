// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where and when a force is missing: how surely the map of it is more than what a recording shows
// in which nothing is missing, the patch of cloth and the stretch of time that explain most of it,
// and whether it is the cloth's or one camera's.
#pragma once

#include <string>
#include <vector>

#include "fitting/diagnosis/locate/discrepancy.h"
#include "fitting/diagnosis/locate/residual_force.h"

namespace clothfit {

// An even force on a rectangle of the cloth for a time.
struct ForcePatch {
  enum class Course {
    kConstant,  // begins and ends at once
    kSwell,     // swells and fades as sin^2, as a gust
  };
  Eigen::Vector2d low_uv, high_uv;      // m
  int first_frame = 0, last_frame = 0;  // inclusive
  Course course = Course::kConstant;
  Eigen::Vector3d amplitude;  // N/m^2, largest, along normal, warp and weft
  double score = 0.0;         // by how much it lowers the sum of squares, noise of 1
  Eigen::VectorXd weights;    // of the layout's (node, knot)s, knot after knot
};

// The patch whose even force lowers the sum of squares most: all rectangles on a lattice of
// sixteenths of the cloth, all stretches of frames, both courses, any direction in the cloth's
// frame. The search alternates between place and time from the best of a coarser one.
ForcePatch FindPatch(const MissingForce& missing);

// How far maps are from nothing: for each (node, knot), knot after knot, the root of f' V^-1 f, V
// the covariance that noise gives the estimate of f where nothing is missing. A column each map.
Eigen::MatrixXd MapStatistics(const MissingForce& missing, const Eigen::MatrixXd& forces);

// Share of recordings without a missing force, the observed one counted among them, whose map's
// largest statistic is at least the observed one's. Each (node, knot) is first put in units of what
// all of these show there, so that a place with a large discretisation error is not held for a
// find. Without nulls from a chi-squared table, as if the residuals were noise alone.
double MapPValue(const MissingForce& missing);

struct LocateOptions {
  double significance = 0.05;
};

struct Location {
  Discrepancy discrepancy;
  ForcePatch patch;
};
// `scene` is the one that the force was estimated in.
Location Locate(const Scene& scene, const MissingForce& missing, const LocateOptions& options = {});

// What becomes of the patch's force when one source of observations is left out (Hausman 1978: two
// estimates, of which one uses more, differ by no more than the difference of their covariances).
struct SourceShift {
  int camera = -1;       // -1: markers
  std::string name;      // "camera 2", "markers"
  double kept = 1.0;     // share of the amplitude, along itself, that is left without this source
  double p_value = 1.0;  // of the two being estimates of one force
  bool is_to_blame = false;
};
// One for each source, of an estimate with by_source. At most one is to blame: without it most of
// the force is gone, by more than chance, and without any other source more of it is left. None
// with fewer than two sources.
std::vector<SourceShift> WhoseDiscrepancy(const Recording& recording, const MissingForce& missing,
                                          const ForcePatch& patch);

}  // namespace clothfit
