// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/truth_surface.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "autodiff_sim/error.h"
#include "tracking/truth.h"

namespace clothfit {
namespace {

constexpr double kSame = 1e-5;  // m, of the rounded coordinates in the file

std::vector<double> Levels(const std::vector<TruthPoint>& points, int axis) {
  std::set<double> all;
  for (const TruthPoint& p : points) all.insert(p.uv[axis]);
  std::vector<double> levels;
  for (const double value : all) {
    if (levels.empty() || value - levels.back() > kSame) levels.push_back(value);
  }
  return levels;
}

int Index(const std::vector<double>& levels, double value) {
  const auto at = std::lower_bound(levels.begin(), levels.end(), value - kSame);
  return static_cast<int>(at - levels.begin());
}

}  // namespace

TruthSurface::TruthSurface(const std::filesystem::path& recording_folder) {
  const std::vector<TruthPoint> points = ReadTruthPoints(recording_folder);
  const std::string place = (recording_folder / "truth" / "points.csv").string();
  const std::vector<double> u = Levels(points, 0), v = Levels(points, 1);
  if (u.size() < 2 || v.size() < 2) throw InputError(place, "expected a grid of points in u and v");
  int last = 0;
  for (const TruthPoint& p : points) last = std::max(last, p.frame);
  const std::size_t count = u.size() * v.size();
  if (points.size() != count * static_cast<std::size_t>(last + 1))
    throw InputError(place, "expected the same grid of points in u and v in every frame");
  mesh_ = MakeGrid({u.back() - u.front(), v.back() - v.front()},
                   {static_cast<int>(u.size()), static_cast<int>(v.size())});
  for (std::size_t i = 0; i < count; ++i) mesh_.uv[i] = {u[i % u.size()], v[i / u.size()]};
  frames_.assign(static_cast<std::size_t>(last) + 1,
                 Eigen::VectorXd::Constant(3 * static_cast<Eigen::Index>(count), std::nan("")));
  for (const TruthPoint& p : points) {
    const int i = Index(u, p.uv.x()) + Index(v, p.uv.y()) * static_cast<int>(u.size());
    frames_[p.frame].segment<3>(3 * i) = p.position;
  }
  for (const Eigen::VectorXd& frame : frames_) {
    if (!frame.allFinite())
      throw InputError(place, "expected the same grid of points in u and v in every frame");
  }
}

std::vector<Eigen::Vector3d> TruthSurface::At(int frame,
                                              const std::vector<Eigen::Vector2d>& uv) const {
  std::vector<Eigen::Vector3d> places;
  for (const SurfacePoint& p : LocateOnCloth(mesh_, uv)) places.push_back(p.At(frames_[frame]));
  return places;
}

}  // namespace clothfit
