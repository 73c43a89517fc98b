// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Writing a recording to a folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tracking/camera/camera_file.h"
#include "tracking/files/output_folder.h"
#include "tracking/recording/folder/tables.h"
#include "tracking/recording/folder/validation.h"
#include "tracking/recording/recording.h"
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
  const std::string below = box.below == 0.0 ? "" : fmt::format(", below: {}", box.below);
  return fmt::format("    box: {{size: {}{}}}\n", List(box.size), below);
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
  if (noise.layout) text += fmt::format("  layout: {}\n", *noise.layout);
  if (noise.track) text += fmt::format("  track: {}\n", *noise.track);
  if (noise.silhouette) text += fmt::format("  silhouette: {}\n", *noise.silhouette);
  if (noise.cloud) text += fmt::format("  cloud: {}\n", *noise.cloud);
  if (noise.cloud_spacing) text += fmt::format("  cloud_spacing: {}\n", *noise.cloud_spacing);
  if (noise.obstacles) text += fmt::format("  obstacles: {}\n", *noise.obstacles);
  return text.empty() ? "" : "noise:\n" + text;
}

std::string CloudsAsYaml(const CloudFiles& clouds) {
  std::string text;
  if (!clouds.camera.empty())
    text += fmt::format("clouds: {{camera: {}}}\n", YamlText(clouds.camera));
  if (!clouds.depth_scales.empty()) text += "depth:\n";
  for (const auto& [camera, scale] : clouds.depth_scales)
    text += fmt::format("  - {{camera: {}, scale: {}}}\n", YamlText(camera), scale);
  return text;
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
  return text + CloudsAsYaml(recording.clouds) + NoiseAsYaml(recording.noise) +
         SplitsAsYaml(recording.splits);
}

std::string MeshName(const fs::path& mesh) { return mesh.filename().string(); }

}  // namespace

std::map<std::string, std::string> FilesOf(const Recording& recording) {
  CheckValues(recording, {});
  std::map<std::string, std::string> files = {{"recording.yaml", RecordingAsYaml(recording)}};
  if (!recording.cameras.empty()) files["cameras.yaml"] = CamerasAsYaml(recording.cameras);
  if (!recording.markers.empty()) files["markers.csv"] = MarkersAsCsv(recording.markers);
  if (!recording.tracks.empty()) files["tracks.csv"] = TracksAsCsv(recording);
  if (const auto* placement = std::get_if<PointPlacement>(&recording.cloth.initial))
    files["initial.csv"] = PlacedPointsAsCsv(placement->points);
  for (const HandleDescription& handle : recording.handles) {
    if (handle.path) files[HandleFile(handle)] = HandlePathAsCsv(*handle.path);
  }
  for (const ObstacleDescription& obstacle : recording.obstacles) {
    if (obstacle.path.size() > 1) files[ObstacleFile(obstacle)] = ObstaclePathAsCsv(obstacle.path);
    if (const auto* mesh = std::get_if<MeshShape>(&obstacle.shape))
      files[MeshName(mesh->file)] = ReadTextFile(mesh->file);
  }
  if (const auto* mesh = std::get_if<MeshPlacement>(&recording.cloth.initial))
    files[MeshName(mesh->file)] = ReadTextFile(mesh->file);
  return files;
}

void WriteRecording(const Recording& recording, const fs::path& folder, Overwrite overwrite) {
  const std::map<std::string, std::string> files = FilesOf(recording);
  OutputFolder output(folder, FolderKind::kRecording, "recording", ExistingIf(overwrite));
  output.Begin(NamesOf(files));
  output.WriteAll(files);
}

}  // namespace clothfit
