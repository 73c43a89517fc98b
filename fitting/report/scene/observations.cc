// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/scene/observations.h"

#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace clothfit {
namespace {

using Json = ReportBlobs::Json;

constexpr std::size_t kMostTracks = 60000;

// Points of the cloth, each once.
class PointTable {
 public:
  std::int32_t IndexOf(const SurfacePoint& point) {
    const auto [entry, is_new] = indices_.try_emplace({point.nodes, point.weights},
                                                      static_cast<std::int32_t>(indices_.size()));
    if (is_new) {
      nodes_.insert(nodes_.end(), point.nodes.begin(), point.nodes.end());
      weights_.insert(weights_.end(), point.weights.begin(), point.weights.end());
    }
    return entry->second;
  }
  Json AsJson(ReportBlobs* blobs) const {
    return {{"nodes", blobs->AddIntegers(nodes_, 3)}, {"weights", blobs->AddList(weights_, 3)}};
  }

 private:
  std::map<std::pair<std::array<int, 3>, std::array<double, 3>>, std::int32_t> indices_;
  std::vector<std::int32_t> nodes_;
  std::vector<double> weights_;
};

Json MarkersAsJson(const Scene& scene, PointTable* points, ReportBlobs* blobs) {
  std::vector<std::int32_t> items;  // frame, point
  std::vector<double> positions;
  for (const MarkerObservation& marker : scene.markers) {
    items.insert(items.end(), {marker.frame, points->IndexOf(marker.on_cloth)});
    positions.insert(positions.end(), marker.position.data(), marker.position.data() + 3);
  }
  return {{"items", blobs->AddIntegers(items, 2)}, {"positions", blobs->AddList(positions, 3)}};
}

Json TracksAsJson(const Scene& scene, PointTable* points, ReportBlobs* blobs,
                  std::vector<std::string>* notes) {
  const std::size_t every = 1 + scene.tracks.size() / kMostTracks;
  std::vector<std::int32_t> items;  // frame, camera, point
  std::vector<double> pixels;
  for (const TrackObservation& track : scene.tracks) {
    if (static_cast<std::size_t>(track.id) % every != 0) continue;
    items.insert(items.end(), {track.frame, track.camera, points->IndexOf(track.on_cloth)});
    pixels.insert(pixels.end(), track.pixel.data(), track.pixel.data() + 2);
  }
  if (every > 1) {
    notes->push_back(
        fmt::format("Of the tracks one in {} is drawn; all of them are in the errors.", every));
  }
  return {{"items", blobs->AddIntegers(items, 3)}, {"pixels", blobs->AddList(pixels, 2)}};
}

}  // namespace

Json MeshAsJson(const ClothMesh& mesh, ReportBlobs* blobs) {
  std::vector<std::int32_t> triangles;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  std::vector<double> uv;
  for (const Eigen::Vector2d& point : mesh.uv) uv.insert(uv.end(), {point.x(), point.y()});
  return {{"particles", mesh.num_particles()},
          {"grid", mesh.is_grid() ? Json(mesh.grid) : Json(nullptr)},
          {"triangles", blobs->AddIntegers(triangles, 3)},
          {"uv", blobs->AddList(uv, 2)}};
}

Json ObservationsAsJson(const Scene& scene, ReportBlobs* blobs, std::vector<std::string>* notes) {
  PointTable points;
  Json json;
  json["markers"] = scene.markers.empty() ? Json() : MarkersAsJson(scene, &points, blobs);
  json["tracks"] = scene.tracks.empty() ? Json() : TracksAsJson(scene, &points, blobs, notes);
  json["points"] = points.AsJson(blobs);
  return json;
}

Json HandlesAsJson(const ReportScene& report, ReportBlobs* blobs) {
  Json handles = Json::array();
  const Scene& scene = report.scene();
  for (const SceneHandle& handle : scene.handles) {
    std::vector<Eigen::VectorXd> places;
    for (const Eigen::VectorXd& x : report.motions.back().positions) {
      places.emplace_back(handle.on_cloth.At(x));
    }
    const bool to_the_end = std::isinf(handle.released_after);
    handles.push_back(
        {{"name", handle.name},
         {"known", handle.path.is_known()},
         {"released_after",
          to_the_end ? Json() : Json(handle.released_after * scene.recording.frame_rate)},
         {"positions", blobs->AddNumbers(places, 3)}});
  }
  return handles;
}

}  // namespace clothfit
