// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take/layout.h"

#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/import/markers/marker_layout.h"

namespace clothfit {
namespace {

constexpr double kMillimetres = 1e3;

std::vector<Eigen::Vector2d> GivenLayout(const MarkerTake& take, const TakeOptions& options) {
  std::vector<Eigen::Vector2d> uv;
  for (const MarkerPath& marker : take.markers) {
    const auto place = options.layout->find(marker.name);
    if (place == options.layout->end()) {
      throw InputError(options.layout_file.string(),
                       fmt::format("marker '{}' of {} is missing; expected a row {},u,v, or "
                                   "--ignore '{}'",
                                   marker.name, take.file.string(), marker.name, marker.name));
    }
    uv.push_back(place->second);
  }
  return uv;
}

Eigen::Vector2d UpperCorner(const std::vector<Eigen::Vector2d>& uv) {
  Eigen::Vector2d upper = uv.front();
  for (const Eigen::Vector2d& point : uv) upper = upper.cwiseMax(point);
  return upper;
}

// Of all markers, or else of those that nothing holds.
std::optional<MarkerGrid> FindGrid(const std::vector<size_t>& held,
                                   std::vector<Eigen::Vector2d>* uv) {
  std::vector<size_t> all, free;
  for (size_t i = 0; i < uv->size(); ++i) {
    all.push_back(i);
    if (std::count(held.begin(), held.end(), i) == 0) free.push_back(i);
  }
  std::optional<MarkerGrid> grid = SnapToGrid(all, uv);
  if (!grid) grid = SnapToGrid(free, uv);
  return grid;
}

// Onto the cloth: away from its edge by the margin, or in the middle of a given size.
void PlaceOnCloth(const TakeOptions& options, std::vector<Eigen::Vector2d>* uv) {
  constexpr double kRounding = 1e5;  // places a metre; a layout is never better than a hundredth of
                                     // a millimetre, and files of short numbers are easier to read
  Eigen::Vector2d lower = Eigen::Vector2d::Constant(options.margin.value_or(0.0));
  if (options.size) {
    const Eigen::Vector2d span = UpperCorner(*uv);
    lower = 0.5 * (*options.size - span);
    if (lower.minCoeff() < 0.0) {
      throw InputError("--size",
                       fmt::format("expected at least {:.5f} {:.5f} m, which the markers span, "
                                   "found {} {}",
                                   span.x(), span.y(), options.size->x(), options.size->y()));
    }
  }
  for (Eigen::Vector2d& place : *uv) {
    place = ((place + lower).array() * kRounding).round() / kRounding;
  }
}

std::vector<Eigen::Vector2d> FoundLayout(const MarkerTake& take, const std::vector<size_t>& held,
                                         const Eigen::MatrixXd& distances,
                                         const TakeOptions& options,
                                         std::vector<std::string>* notes) {
  std::vector<Eigen::Vector3d> positions;
  for (const MarkerPath& marker : take.markers) positions.push_back(*marker.positions.front());
  std::vector<Eigen::Vector2d> uv = FindFlatLayout(distances);
  std::optional<MarkerGrid> grid;
  if (options.snap_to_grid) grid = FindGrid(held, &uv);
  OrientLayout(held, positions, grid ? &*grid : nullptr, &uv);
  if (grid) {
    notes->push_back(
        fmt::format("{} x {} markers sit on a grid, {:.1f} and {:.1f} mm apart (rms "
                    "{:.1f} mm)",
                    grid->count.x(), grid->count.y(), kMillimetres * grid->spacing.x(),
                    kMillimetres * grid->spacing.y(), kMillimetres * grid->rms));
  }
  PlaceOnCloth(options, &uv);
  return uv;
}

}  // namespace

LayoutOfTake MakeLayout(const MarkerTake& take, const std::vector<size_t>& held,
                        const Eigen::MatrixXd& distances, const TakeOptions& options,
                        std::vector<std::string>* notes) {
  LayoutOfTake layout;
  layout.uv = options.layout ? GivenLayout(take, options)
                             : FoundLayout(take, held, distances, options, notes);
  const LayoutFit fit = CompareLayout(layout.uv, distances);
  layout.rms = fit.rms;
  notes->push_back(
      fmt::format("layout: rms {:.1f} mm against the largest distances of {} "
                  "markers; they exceed it by at most {:.1f} %",
                  kMillimetres * fit.rms, layout.uv.size(), 100.0 * fit.largest_stretch));
  constexpr double kRounding = 1e5;  // never inwards, where a marker would fall off the cloth
  constexpr double kRepresentation = 1e-3;  // of a step, that rounded doubles may be off
  const Eigen::Array2d span = UpperCorner(layout.uv).array() + options.margin.value_or(0.0);
  layout.size = options.size.value_or((span * kRounding - kRepresentation).ceil() / kRounding);
  return layout;
}

}  // namespace clothfit
