// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The regular grid and the orientation of a layout of markers.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Dense>

#include "tracking/import/markers/marker_layout.h"

namespace clothfit {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Eigen::Vector2d MeanOf(const Points& points) {
  const Eigen::Vector2d sum =
      std::accumulate(points.begin(), points.end(), Eigen::Vector2d(0.0, 0.0));
  return sum / double(points.size());
}

Eigen::Vector2d LowerCorner(const Points& points) {
  Eigen::Vector2d lower = points.front();
  for (const Eigen::Vector2d& point : points) lower = lower.cwiseMin(point);
  return lower;
}

Eigen::Vector2d Extent(const Points& points) {
  Eigen::Vector2d upper = points.front();
  for (const Eigen::Vector2d& point : points) upper = upper.cwiseMax(point);
  return upper - LowerCorner(points);
}

// Turned so that the direction, of any length but zero, becomes the x axis.
Points TurnedTo(const Eigen::Vector2d& direction, const Points& points) {
  const Eigen::Vector2d x = direction.normalized();
  Eigen::Matrix2d turn;
  turn << x.x(), x.y(), -x.y(), x.x();
  Points turned;
  for (const Eigen::Vector2d& point : points) turned.emplace_back(turn * point);
  return turned;
}

// Column and row of each point, if there are so many of either.
std::vector<Eigen::Vector2d> PlacesOnGrid(const Points& points, size_t columns, size_t rows) {
  std::vector<size_t> order(points.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return points[a].y() < points[b].y(); });
  std::vector<Eigen::Vector2d> places(points.size());
  for (size_t row = 0; row < rows; ++row) {
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(row * columns);
    const auto end = begin + static_cast<std::ptrdiff_t>(columns);
    std::sort(begin, end, [&](size_t a, size_t b) { return points[a].x() < points[b].x(); });
    for (size_t column = 0; column < columns; ++column) {
      places[*(begin + static_cast<std::ptrdiff_t>(column))] = {double(column), double(row)};
    }
  }
  return places;
}

// The grid of least squares through points whose places on it are known; columns and rows of a full
// grid are uncorrelated, so that each side is found on its own.
MarkerGrid FitGrid(const Points& points, const Points& places, Points* on_grid) {
  const Eigen::Vector2d mean = MeanOf(points);
  const Eigen::Vector2d middle = MeanOf(places);
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();  // a column for each side
  Eigen::Vector2d spread = Eigen::Vector2d::Zero();
  for (size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector2d place = places[k] - middle;
    moments += (points[k] - mean) * place.transpose();
    spread += place.cwiseProduct(place);
  }
  // Both sides have their say in how the grid is turned, by their share in the moments.
  const Eigen::Vector2d x =
      Eigen::Vector2d(moments(0, 0) + moments(1, 1), moments(1, 0) - moments(0, 1)).normalized();
  const Eigen::Vector2d y(-x.y(), x.x());
  MarkerGrid grid;
  grid.side = x;
  grid.spacing = {x.dot(moments.col(0)) / spread.x(), y.dot(moments.col(1)) / spread.y()};
  on_grid->clear();
  double sum = 0.0;
  for (size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector2d along = (places[k] - middle).cwiseProduct(grid.spacing);
    on_grid->push_back(mean + along.x() * x + along.y() * y);
    sum += (on_grid->back() - points[k]).squaredNorm();
  }
  grid.rms = std::sqrt(sum / double(points.size()));
  return grid;
}

// Of the cloth from where u runs counter-clockwise to v, in space: of the plane that fits best.
Eigen::Vector3d FrontNormal(const Points& uv, const std::vector<Eigen::Vector3d>& positions) {
  const auto n = static_cast<Eigen::Index>(uv.size());
  Eigen::MatrixXd flat(n, 3);
  Eigen::MatrixXd space(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    flat.row(i) << 1.0, uv[static_cast<size_t>(i)].transpose();
    space.row(i) = positions[static_cast<size_t>(i)].transpose();
  }
  const Eigen::MatrixXd slopes = flat.colPivHouseholderQr().solve(space);
  const Eigen::Vector3d along_u = slopes.row(1);
  const Eigen::Vector3d along_v = slopes.row(2);
  return along_u.cross(along_v);
}

bool LooksAgainstAxis(const Eigen::Vector3d& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return normal[axis] < 0.0;
}

// Of a layout whose sides lie along the axes: the direction that u is to take. `may_turn`: the
// sides are not so certain that the line between two handles cannot say better.
Eigen::Vector2d DirectionOfU(const std::vector<size_t>& handles, bool may_turn, const Points& uv) {
  if (handles.size() >= 2) {
    Eigen::Vector2d between = uv[handles[1]] - uv[handles[0]];
    Eigen::Index along = 0;
    between.cwiseAbs().maxCoeff(&along);
    const double tangent = std::abs(between[1 - along]) / std::abs(between[along]);
    if (may_turn && tangent < std::tan(10.0 * M_PI / 180.0)) return between;
    return std::copysign(1.0, between[along]) * Eigen::Vector2d::Unit(along);
  }
  const Eigen::Vector2d extent = Extent(uv);
  const Eigen::Index along = extent.y() > extent.x() ? 1 : 0;
  const Eigen::Vector2d first = uv[handles.empty() ? 0 : handles[0]] - LowerCorner(uv);
  return (first[along] > 0.5 * extent[along] ? -1.0 : 1.0) * Eigen::Vector2d::Unit(along);
}

}  // namespace

Eigen::Vector2d SideOfSmallestRectangle(const Points& points) {
  Eigen::Vector2d best = Eigen::Vector2d::UnitX();
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const Eigen::Vector2d side = points[i] - points[j];
      if (side.norm() < 1e-9) continue;
      const double area = Extent(TurnedTo(side, points)).prod();
      if (area >= smallest) continue;
      smallest = area;
      best = side.normalized();
    }
  }
  return best;
}

std::optional<MarkerGrid> SnapToGrid(const std::vector<size_t>& members, Points* uv) {
  constexpr double kTolerance = 0.05;  // rms, of the smaller spacing; further off it is no grid
  Points points;
  for (const size_t member : members) points.push_back((*uv)[member]);
  if (points.size() < 4) return std::nullopt;
  const Eigen::Vector2d side = SideOfSmallestRectangle(points);
  const Points turned = TurnedTo(side, points);
  std::optional<MarkerGrid> best;
  for (size_t columns = 2; columns <= points.size() / 2; ++columns) {
    if (points.size() % columns != 0) continue;
    const size_t rows = points.size() / columns;
    Points on_grid;
    MarkerGrid grid = FitGrid(points, PlacesOnGrid(turned, columns, rows), &on_grid);
    if (!(grid.rms < kTolerance * grid.spacing.minCoeff())) continue;
    if (best && best->rms <= grid.rms) continue;
    grid.count = {int(columns), int(rows)};
    best = grid;
    for (size_t k = 0; k < members.size(); ++k) (*uv)[members[k]] = on_grid[k];
  }
  return best;
}

void OrientLayout(const std::vector<size_t>& handles, const std::vector<Eigen::Vector3d>& positions,
                  MarkerGrid* grid, std::vector<Eigen::Vector2d>* uv) {
  Points turned = TurnedTo(grid != nullptr ? grid->side : SideOfSmallestRectangle(*uv), *uv);
  const Eigen::Vector2d direction = DirectionOfU(handles, grid == nullptr, turned);
  if (grid != nullptr && std::abs(direction.y()) > std::abs(direction.x())) {
    std::swap(grid->count.x(), grid->count.y());
    std::swap(grid->spacing.x(), grid->spacing.y());
    grid->side = Eigen::Vector2d(-grid->side.y(), grid->side.x());
  }
  turned = TurnedTo(direction, turned);
  bool mirror = LooksAgainstAxis(FrontNormal(turned, positions));
  if (handles.size() >= 2) {
    constexpr double kAside =
        0.05;  // of the extent; markers nearer to the line are on neither side
    const double line = 0.5 * (turned[handles[0]].y() + turned[handles[1]].y());
    const double aside = MeanOf(turned).y() - line;
    if (std::abs(aside) > kAside * Extent(turned).y()) mirror = aside < 0.0;
  }
  if (mirror) {
    for (Eigen::Vector2d& point : turned) point.y() = -point.y();
  }
  const Eigen::Vector2d lower = LowerCorner(turned);
  for (Eigen::Vector2d& point : turned) point -= lower;
  *uv = turned;
}

}  // namespace clothfit
