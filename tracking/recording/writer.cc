// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Writing a recording to a folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "autodiff_sim/base/error.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/recording.h"
#include "tracking/recording/tables.h"
#include "tracking/recording/validation.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

template <class Vector>
std::string List(const Vector& vector) {
  return fmt::format("[{}]", fmt::join(vector.data(), vector.data() + vector.size(), ", "));
}

std::string HandleFile(const HandleDescription& handle) {
  return "handles/" + handle.name + ".csv";
}

std::string PlacementAsYaml(const FlatPlacement& flat) {
  return fmt::format(
      "  initial:\n"
      "    origin: {}\n"
      "    u_axis: {}\n"
      "    v_axis: {}\n",
      List(flat.origin), List(flat.u_axis), List(flat.v_axis));
}

std::string PlacementAsYaml(const PointPlacement&) { return "  initial: {points: initial.csv}\n"; }

std::string PlacementAsYaml(const MeshPlacement& mesh) {
  return fmt::format("  mesh: {}\n", YamlText(mesh.file.filename().string()));
}

std::string ClothAsYaml(const ClothDescription& cloth) {
  std::string text = fmt::format("cloth:\n  size: {}\n  resolution: {}\n", List(cloth.size),
                                 List(cloth.resolution));
  if (cloth.areal_density) text += fmt::format("  areal_density: {}\n", *cloth.areal_density);
  return text +
         std::visit([](const auto& initial) { return PlacementAsYaml(initial); }, cloth.initial);
}

std::string HandleAsYaml(const HandleDescription& handle) {
  std::string text =
      fmt::format("  - name: {}\n    uv: {}\n", YamlText(handle.name), List(handle.uv));
  if (handle.path) text += fmt::format("    path: {}\n", YamlText(HandleFile(handle)));
  if (handle.path_sigma) text += fmt::format("    path_sigma: {}\n", *handle.path_sigma);
  if (handle.released_after) {
    text += fmt::format("    released_after: {}\n", *handle.released_after);
  }
  return text;
}

std::string ObstacleFile(const ObstacleDescription& obstacle) {
  return "obstacles/" + obstacle.name + ".csv";
}

std::string ShapeAsYaml(const BallShape& ball) {
  return fmt::format("    sphere: {{radius: {}}}\n", ball.radius);
}
std::string ShapeAsYaml(const BarShape& bar) {
  return fmt::format("    capsule: {{radius: {}, length: {}}}\n", bar.radius, bar.length);
}
std::string ShapeAsYaml(const BoxShape& box) {
  return fmt::format("    box: {{size: {}}}\n", List(box.size));
}
std::string ShapeAsYaml(const MeshShape& mesh) {
  return fmt::format("    mesh: {}\n", YamlText(mesh.file.filename().string()));
}

std::string ObstacleAsYaml(const ObstacleDescription& obstacle) {
  std::string text = fmt::format("  - name: {}\n", YamlText(obstacle.name)) +
                     std::visit([](const auto& s) { return ShapeAsYaml(s); }, obstacle.shape);
  if (obstacle.path.size() > 1)
    return text + fmt::format("    path: {}\n", YamlText(ObstacleFile(obstacle)));
  text += fmt::format("    position: {}\n", List(obstacle.path[0].position));
  return text + fmt::format("    rotation: {}\n", List(obstacle.path[0].rotation));
}

std::string NoiseAsYaml(const NoiseSigmas& noise) {
  std::string text;
  if (noise.marker) text += fmt::format("  marker: {}\n", *noise.marker);
  if (noise.track) text += fmt::format("  track: {}\n", *noise.track);
  if (noise.silhouette) text += fmt::format("  silhouette: {}\n", *noise.silhouette);
  return text.empty() ? "" : "noise:\n" + text;
}

std::string SplitsAsYaml(const Splits& splits) {
  std::string text;
  if (const auto& range = splits.held_out_frames) {
    text += fmt::format("  held_out_frames: [{}, {}]\n", range->first, range->last);
  }
  std::string names;
  for (const std::string& name : splits.held_out_cameras) {
    names += (names.empty() ? "" : ", ") + YamlText(name);
  }
  if (!names.empty()) text += fmt::format("  held_out_cameras: [{}]\n", names);
  return text.empty() ? "" : "splits:\n" + text;
}

std::string RecordingAsYaml(const Recording& recording) {
  std::string text = "format: cloth-recording/1\n";
  text += fmt::format("name: {}\n", YamlText(recording.name));
  text += fmt::format("frame_rate: {}\n", recording.frame_rate);
  text += fmt::format("frame_count: {}\n", recording.frame_count);
  text += fmt::format("gravity: {}\n", List(recording.gravity));
  if (recording.ground_height) {
    text += fmt::format("ground: {{height: {}}}\n", *recording.ground_height);
  }
  text += ClothAsYaml(recording.cloth);
  if (!recording.handles.empty()) text += "handles:\n";
  for (const HandleDescription& handle : recording.handles) text += HandleAsYaml(handle);
  if (!recording.obstacles.empty()) text += "obstacles:\n";
  for (const ObstacleDescription& obstacle : recording.obstacles) text += ObstacleAsYaml(obstacle);
  return text + NoiseAsYaml(recording.noise) + SplitsAsYaml(recording.splits);
}

// What an earlier recording left would otherwise be read as part of this one.
void RemoveEarlierFiles(const fs::path& folder) {
  for (const char* name : {"cameras.yaml", "markers.csv", "tracks.csv", "initial.csv"}) {
    fs::remove(folder / name);
  }
  for (const char* name : {"handles", "obstacles"}) {
    if (!fs::is_directory(folder / name)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / name)) {
      if (entry.path().extension() == ".csv") fs::remove(entry.path());
    }
  }
}

void CopyMesh(const fs::path& mesh, const fs::path& folder) {
  const fs::path copy = folder / mesh.filename();
  if (fs::exists(copy) && fs::equivalent(mesh, copy)) return;
  fs::copy_file(mesh, copy, fs::copy_options::overwrite_existing);
}

void WriteFiles(const Recording& recording, const fs::path& folder) {
  WriteTextFile(folder / "recording.yaml", RecordingAsYaml(recording));
  if (!recording.cameras.empty()) {
    WriteTextFile(folder / "cameras.yaml", CamerasAsYaml(recording.cameras));
  }
  if (!recording.markers.empty()) {
    WriteTextFile(folder / "markers.csv", MarkersAsCsv(recording.markers));
  }
  if (!recording.tracks.empty()) WriteTextFile(folder / "tracks.csv", TracksAsCsv(recording));
  if (const auto* placement = std::get_if<PointPlacement>(&recording.cloth.initial)) {
    WriteTextFile(folder / "initial.csv", PlacedPointsAsCsv(placement->points));
  }
  for (const HandleDescription& handle : recording.handles) {
    if (handle.path) WriteTextFile(folder / HandleFile(handle), HandlePathAsCsv(*handle.path));
  }
  for (const ObstacleDescription& obstacle : recording.obstacles) {
    if (obstacle.path.size() > 1)
      WriteTextFile(folder / ObstacleFile(obstacle), ObstaclePathAsCsv(obstacle.path));
    if (const auto* mesh = std::get_if<MeshShape>(&obstacle.shape)) CopyMesh(mesh->file, folder);
  }
  if (const auto* mesh = std::get_if<MeshPlacement>(&recording.cloth.initial)) {
    CopyMesh(mesh->file, folder);
  }
}

}  // namespace

void WriteRecording(const Recording& recording, const fs::path& folder, Overwrite overwrite) {
  CheckValues(recording, {});
  if (fs::exists(folder / "recording.yaml") && overwrite == Overwrite::kRefuse) {
    throw InputError(folder.string(), "already holds a recording; expected a new or empty folder");
  }
  try {
    RemoveEarlierFiles(folder);
    WriteFiles(recording, folder);
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(),
                     fmt::format("cannot be written ({})", error.code().message()));
  }
}

}  // namespace clothfit
