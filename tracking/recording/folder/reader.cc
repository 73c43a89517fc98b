// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Reading a recording from its folder.
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/folder/inside.h"
#include "tracking/recording/folder/picture_files.h"
#include "tracking/recording/folder/tables.h"
#include "tracking/recording/folder/validation.h"
#include "tracking/recording/recording.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// The file of the recording that a value names. It may not lie outside, nor in truth/.
fs::path FileNamed(const YamlValue& value, const Recording& recording) {
  const fs::path relative = fs::path(value.Text()).lexically_normal();
  const bool leaves = relative.is_absolute() || *relative.begin() == "..";
  if (leaves || *relative.begin() == "truth") {
    value.Fail(Quoted(value.Text()) + " must lie inside the recording and not in truth/");
  }
  fs::path file = recording.path / relative;
  if (!IsThere(file)) value.Fail(fmt::format("no such file: {}", file.string()));
  CheckLiesInside(recording.path, file);
  CheckInputFile(file);
  return file;
}

FlatPlacement ReadFlatPlacement(const YamlValue& value) {
  return {value.Require("origin").Vector3(), value.Require("u_axis").Vector3(),
          value.Require("v_axis").Vector3()};
}

void ReadCloth(const YamlValue& value, Recording* recording) {
  value.AllowKeys({"size", "resolution", "areal_density", "initial", "mesh"});
  ClothDescription& cloth = recording->cloth;
  cloth.size = value.Require("size").Vector2();
  const std::optional<YamlValue> mesh = value.Find("mesh");
  if (!mesh || value.Has("resolution")) {
    cloth.resolution = value.Require("resolution").IntegerPair();
  }
  if (const auto density = value.Find("areal_density")) cloth.areal_density = density->Number();
  if (mesh) {
    if (value.Has("initial")) mesh->Fail("expected either 'mesh' or 'initial', found both");
    cloth.initial = MeshPlacement{FileNamed(*mesh, *recording)};
    return;
  }
  const YamlValue initial = value.Require("initial");
  initial.AllowKeys({"origin", "u_axis", "v_axis", "points"});
  const std::optional<YamlValue> points = initial.Find("points");
  if (!points) {
    cloth.initial = ReadFlatPlacement(initial);
    return;
  }
  if (initial.Entries().size() != 1) points->Fail("expected 'points' alone, or none of it");
  cloth.initial = PointPlacement{ReadPlacedPoints(FileNamed(*points, *recording))};
}

HandleDescription ReadHandle(const YamlValue& value, const Recording& recording) {
  value.AllowKeys({"name", "uv", "path", "path_sigma", "released_after"});
  HandleDescription handle;
  handle.name = value.Require("name").Text();
  handle.uv = value.Require("uv").Vector2();
  if (const auto path = value.Find("path")) {
    handle.path = ReadHandlePath(FileNamed(*path, recording), recording);
  }
  if (const auto sigma = value.Find("path_sigma")) handle.path_sigma = sigma->Number();
  if (const auto release = value.Find("released_after")) handle.released_after = release->Integer();
  return handle;
}

ObstacleDescription ReadObstacle(const YamlValue& value, const Recording& recording) {
  value.AllowKeys({"name", "sphere", "capsule", "box", "mesh", "position", "rotation", "path"});
  ObstacleDescription obstacle;
  obstacle.name = value.Require("name").Text();
  int shapes = 0;
  if (const auto sphere = value.Find("sphere"); sphere && ++shapes > 0) {
    sphere->AllowKeys({"radius"});
    obstacle.shape = BallShape{sphere->Require("radius").Number()};
  }
  if (const auto capsule = value.Find("capsule"); capsule && ++shapes > 0) {
    capsule->AllowKeys({"radius", "length"});
    obstacle.shape =
        BarShape{capsule->Require("radius").Number(), capsule->Require("length").Number()};
  }
  if (const auto box = value.Find("box"); box && ++shapes > 0) {
    box->AllowKeys({"size", "below"});
    BoxShape shape{box->Require("size").Vector3()};
    if (const auto below = box->Find("below")) shape.below = below->Number();
    obstacle.shape = shape;
  }
  if (const auto mesh = value.Find("mesh"); mesh && ++shapes > 0)
    obstacle.shape = MeshShape{FileNamed(*mesh, recording)};
  if (shapes != 1) value.Fail("expected one of 'sphere', 'capsule', 'box' and 'mesh'");
  const auto path = value.Find("path");
  if (path) {
    if (value.Has("position") || value.Has("rotation"))
      path->Fail("expected either 'path' or 'position' and 'rotation', found both");
    obstacle.path = ReadObstaclePath(FileNamed(*path, recording), recording);
    return obstacle;
  }
  obstacle.path[0].position = value.Require("position").Vector3();
  if (const auto rotation = value.Find("rotation")) obstacle.path[0].rotation = rotation->Vector3();
  return obstacle;
}

void ReadNoise(const YamlValue& value, NoiseSigmas* noise) {
  value.AllowKeys(
      {"marker", "layout", "track", "silhouette", "cloud", "cloud_spacing", "obstacles"});
  if (const auto marker = value.Find("marker")) noise->marker = marker->Number();
  if (const auto layout = value.Find("layout")) noise->layout = layout->Number();
  if (const auto track = value.Find("track")) noise->track = track->Number();
  if (const auto silhouette = value.Find("silhouette")) noise->silhouette = silhouette->Number();
  if (const auto cloud = value.Find("cloud")) noise->cloud = cloud->Number();
  if (const auto spacing = value.Find("cloud_spacing")) noise->cloud_spacing = spacing->Number();
  if (const auto all = value.Find("obstacles")) noise->obstacles = all->Number();
}

void ReadDepthScales(const YamlValue& list, CloudFiles* clouds) {
  for (const YamlValue& value : list.Items()) {
    value.AllowKeys({"camera", "scale"});
    const YamlValue camera = value.Require("camera");
    if (!clouds->depth_scales.emplace(camera.Text(), value.Require("scale").Number()).second)
      camera.Fail(Quoted(camera.Text()) + " appears more than once");
  }
}

void ReadSplits(const YamlValue& value, Splits* splits) {
  value.AllowKeys({"held_out_frames", "held_out_cameras"});
  if (const auto frames = value.Find("held_out_frames")) {
    const Eigen::Vector2i range = frames->IntegerPair();
    splits->held_out_frames = Splits::FrameRange{range[0], range[1]};
  }
  if (const auto cameras = value.Find("held_out_cameras")) {
    for (const YamlValue& name : cameras->Items()) splits->held_out_cameras.push_back(name.Text());
  }
}

void ReadDescription(const YamlValue& top, Recording* recording) {
  constexpr const char* kRecordingFormat = "cloth-recording/1";
  const YamlValue format = top.Require("format");
  if (format.Text() != kRecordingFormat) {  // first: another version may well have other keys
    format.Fail(fmt::format("expected '{}', found {}", kRecordingFormat, Quoted(format.Text())));
  }
  top.AllowKeys({"format", "name", "frame_rate", "frame_count", "gravity", "ground", "cloth",
                 "handles", "obstacles", "clouds", "depth", "noise", "splits"});
  recording->name = top.Require("name").Text();
  recording->frame_rate = top.Require("frame_rate").Number();
  recording->frame_count = top.Require("frame_count").Integer();
  recording->gravity = top.Require("gravity").Vector3();
  if (const auto ground = top.Find("ground")) {
    ground->AllowKeys({"height"});
    recording->ground_height = ground->Require("height").Number();
  }
  CheckScene(*recording);  // the frame count is needed to read the paths of the handles
  ReadCloth(top.Require("cloth"), recording);
  if (const auto handles = top.Find("handles")) {
    for (const YamlValue& handle : handles->Items()) {
      recording->handles.push_back(ReadHandle(handle, *recording));
    }
  }
  if (const auto obstacles = top.Find("obstacles")) {
    for (const YamlValue& obstacle : obstacles->Items())
      recording->obstacles.push_back(ReadObstacle(obstacle, *recording));
  }
  if (const auto clouds = top.Find("clouds")) {
    clouds->AllowKeys({"camera"});
    recording->clouds.camera = clouds->Require("camera").Text();
  }
  if (const auto depth = top.Find("depth")) ReadDepthScales(*depth, &recording->clouds);
  if (const auto noise = top.Find("noise")) ReadNoise(*noise, &recording->noise);
  if (const auto splits = top.Find("splits")) ReadSplits(*splits, &recording->splits);
}

void ReadCamerasAndFiles(Recording* recording) {
  const fs::path file = recording->path / "cameras.yaml";
  std::vector<std::string> needed_by = PictureFolders(recording->path);
  if (IsThere(recording->path / "tracks.csv")) needed_by.emplace_back("tracks.csv");
  if (!IsThere(file)) {
    if (needed_by.empty()) return;
    throw InputError(file.string(),
                     "no such file; the recording needs it for " + JoinNames(needed_by));
  }
  recording->cameras = ReadCameras(file);
  CheckCameras(*recording);  // before anything is looked up by a camera's name
  recording->files = ListPictures(*recording);
}

}  // namespace

Recording ReadRecording(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_regular_file(folder, ignored))
    throw InputError(folder.string(), "is a file; 'clothfit import' makes a recording of it");
  CheckInputFolder(folder);
  for (const char* name : {"recording.yaml", "cameras.yaml", "markers.csv", "tracks.csv"})
    CheckLinkLiesInside(folder, folder / name);
  Recording recording;
  recording.path = folder;
  ReadDescription(YamlValue::Load(folder / "recording.yaml"), &recording);
  ReadCamerasAndFiles(&recording);
  recording.clouds.files = ListClouds(recording);
  ObservationLines lines;
  const fs::path markers = folder / "markers.csv";
  if (IsThere(markers)) recording.markers = ReadMarkers(markers, &lines.markers);
  const fs::path tracks = folder / "tracks.csv";
  if (IsThere(tracks)) recording.tracks = ReadTracks(tracks, recording, &lines.tracks);
  CheckValues(recording, lines);
  CheckHasObservation(recording);
  return recording;
}

}  // namespace clothfit
