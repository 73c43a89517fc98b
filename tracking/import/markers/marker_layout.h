// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where markers sit on the cloth, found from how far apart they ever were.
//
// Between two points of a cloth that does not stretch, the straight distance in space never exceeds
// the distance along the cloth, and reaches it where the cloth between them is taut. So the largest
// distance over all frames is a lower bound, and often about equal.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "tracking/recording/recording.h"

namespace clothfit {

// The largest distance (m) of each pair over all frames, symmetric; the few largest are passed over
// as outliers. Negative where a pair was never seen together.
Eigen::MatrixXd LargestDistances(const std::vector<HandleDescription::Path>& paths);

// How well flat distances agree with the largest that were measured, over all pairs.
struct LayoutFit {
  double rms = 0.0;              // m, of flat minus measured
  double largest_stretch = 0.0;  // by which a measured distance exceeds the flat one, of the latter
};

LayoutFit CompareLayout(const std::vector<Eigen::Vector2d>& uv, const Eigen::MatrixXd& distances);

// The flat layout whose distances fit best: not shorter than those measured, as far as it can be
// had, and as little longer. Begins with classical multidimensional scaling (Torgerson 1952). Its
// position, orientation and handedness are arbitrary.
std::vector<Eigen::Vector2d> FindFlatLayout(const Eigen::MatrixXd& distances);

// A marker that came off the cloth, or is no part of it: without it the others fit a flat layout
// kLooseGain times better than with it, which is off by kLooseRms or more. Empty where there is
// none, or fewer than six markers (the rest would fit whatever they do).
inline constexpr double kLooseRms = 0.01;  // m; of cloth without one it is 1 to 3.5 mm
inline constexpr double kLooseGain = 3.0;
std::optional<size_t> FindLooseMarker(const Eigen::MatrixXd& distances);

// The direction of a side of the smallest rectangle around the points, of which one goes through
// two of them.
Eigen::Vector2d SideOfSmallestRectangle(const std::vector<Eigen::Vector2d>& points);

// A regular grid that markers sit on.
struct MarkerGrid {
  Eigen::Vector2i count;    // markers along the two sides
  Eigen::Vector2d spacing;  // m, along the two sides
  Eigen::Vector2d side;     // direction of the first side
  double rms = 0.0;         // m, by which the markers were moved onto it
};

// Moves those members of a layout onto the full grid, of two or more either way, that explains
// them. Where there is none, nothing changes and nothing is returned.
std::optional<MarkerGrid> SnapToGrid(const std::vector<size_t>& members,
                                     std::vector<Eigen::Vector2d>* uv);

// Turns and mirrors a layout, and moves it to where the smallest u and v are zero.
//
// Its sides are those of the grid (null: there is none), which are put in the order u, v, or else
// of the smallest rectangle around the markers. With two handles or more, u runs from the first
// towards the second (along the line between them where there is no grid and it is within 10
// degrees of a side) and v towards the other markers. Otherwise u runs along the longer side and
// away from the first handle or marker, and v so that the front, from where u turns
// counter-clockwise to v, looks along the positive one of the world's axis it is nearest to while
// the markers are at `positions` (m, world).
void OrientLayout(const std::vector<size_t>& handles, const std::vector<Eigen::Vector3d>& positions,
                  MarkerGrid* grid, std::vector<Eigen::Vector2d>* uv);

}  // namespace clothfit
