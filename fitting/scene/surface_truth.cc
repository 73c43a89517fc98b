// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/scene/surface_truth.h"

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/text/csv.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

fs::path CloudFile(const fs::path& folder, int frame) {
  return folder / "truth" / fmt::format("cloud_{:06d}.csv", frame);
}

}  // namespace

SurfaceTruth::SurfaceTruth(const fs::path& folder, const Scene& scene) : folder_(folder) {
  if (HasTruthPoints(folder)) {
    for (const TruthPoint& p : ReadTruthPoints(folder)) points_[p.frame].push_back(p);
  }
  std::vector<SurfacePoint> located;  // of the frame before: the points are mostly the same
  std::vector<Eigen::Vector2d> located_uv;
  for (const auto& [frame, points] : points_) {
    std::vector<Eigen::Vector2d> uv;
    for (const TruthPoint& p : points) uv.push_back(p.uv);
    if (uv != located_uv) located = LocateOnCloth(scene.mesh, uv);
    located_uv = std::move(uv);
    on_cloth_[frame] = located;
  }
  bool any_cloud = false;
  for (int f = 0; f < scene.recording.frame_count && !any_cloud; ++f)
    any_cloud = fs::exists(CloudFile(folder, f));
  if (any_cloud || !points_.empty()) return;
  throw InputError((folder / "truth").string(),
                   "nothing to compare with: expected points.csv or cloud_000000.csv ...");
}

std::vector<double> SurfaceTruth::PointDistances(int frame, const Eigen::VectorXd& x) const {
  std::vector<double> distances;
  const auto found = points_.find(frame);
  if (found == points_.end()) return distances;
  const std::vector<SurfacePoint>& on_cloth = on_cloth_.at(frame);
  for (std::size_t i = 0; i < on_cloth.size(); ++i)
    distances.push_back((on_cloth[i].At(x) - found->second[i].position).norm());
  return distances;
}

std::vector<Eigen::Vector3d> SurfaceTruth::Cloud(int frame) const {
  std::vector<Eigen::Vector3d> points;
  const fs::path file = CloudFile(folder_, frame);
  if (!fs::exists(file)) return points;
  ReadCsv(file, {"x", "y", "z"}, [&](const CsvRow& row) { points.push_back(row.Vector3(0)); });
  return points;
}

}  // namespace clothfit
