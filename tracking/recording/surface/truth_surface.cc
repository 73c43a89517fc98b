// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/truth_surface.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

std::vector<double> SortedOnce(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

// The grid's mesh; its (u, v) are the points' own, which need not be evenly spaced.
std::unique_ptr<ClothMesh> GridMesh(const std::vector<TruthPoint>& points,
                                    const std::string& place) {
  std::vector<double> all_u, all_v;
  for (const TruthPoint& point : points) {
    all_u.push_back(point.uv.x());
    all_v.push_back(point.uv.y());
  }
  const std::vector<double> u = SortedOnce(all_u), v = SortedOnce(all_v);
  if (u.size() < 2 || v.size() < 2) throw InputError(place, "expected a grid of points in (u, v)");
  auto mesh = std::make_unique<ClothMesh>(
      MakeGrid({u.back() - u.front(), v.back() - v.front()},
               {static_cast<int>(u.size()), static_cast<int>(v.size())}));
  for (std::size_t i = 0; i < mesh->uv.size(); ++i)
    mesh->uv[i] = {u[i % u.size()], v[i / u.size()]};
  return mesh;
}

std::vector<Eigen::VectorXd> FramesOf(const std::vector<TruthPoint>& points, const ClothMesh& mesh,
                                      const std::string& place) {
  std::map<std::pair<double, double>, int> particle;
  for (int i = 0; i < mesh.num_particles(); ++i) particle[{mesh.uv[i].x(), mesh.uv[i].y()}] = i;
  int last = 0;
  for (const TruthPoint& point : points) last = std::max(last, point.frame);
  std::vector<Eigen::VectorXd> frames(static_cast<std::size_t>(last) + 1,
                                      Eigen::VectorXd(3 * mesh.num_particles()));
  std::vector<int> found(frames.size());
  for (const TruthPoint& point : points) {
    const std::size_t frame = static_cast<std::size_t>(point.frame);
    frames[frame].segment<3>(3 * particle.at({point.uv.x(), point.uv.y()})) = point.position;
    ++found[frame];
  }
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (found[f] != mesh.num_particles()) {
      throw InputError(place, fmt::format("expected a grid of {} points in frame {}, found {}",
                                          mesh.num_particles(), f, found[f]));
    }
  }
  return frames;
}

}  // namespace

TruthSurface::TruthSurface(const std::vector<TruthPoint>& points, const std::string& place)
    : mesh_(GridMesh(points, place)), frames_(FramesOf(points, *mesh_, place)), surface_(*mesh_) {}

TruthSurface TruthSurface::Read(const std::filesystem::path& recording_folder) {
  return {ReadTruthPoints(recording_folder), (recording_folder / "truth" / "points.csv").string()};
}

const ClothSurface& TruthSurface::MoveTo(int frame) {
  surface_.MoveTo(positions(frame));
  return surface_;
}

std::vector<Eigen::Vector3d> TruthSurface::At(int frame,
                                              const std::vector<Eigen::Vector2d>& uv) const {
  std::vector<Eigen::Vector3d> places;
  for (const SurfacePoint& point : LocateOnCloth(*mesh_, uv))
    places.push_back(point.At(positions(frame)));
  return places;
}

}  // namespace clothfit
