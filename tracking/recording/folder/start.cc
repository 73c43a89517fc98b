// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/folder/start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/folder/picture_files.h"
#include "tracking/recording/folder/tables.h"
#include "tracking/recording/folder/validation.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr double kAboveGround = 0.002;  // m; a cloth that lies is about as thick

Recording RecordingOf(const SceneStart& start, const fs::path& folder) {
  Recording recording;
  recording.path = folder;
  recording.name = NameOfFolder(folder);
  recording.frame_count = start.frame_count.value_or(0);
  recording.frame_rate = start.frame_rate.value_or(0.0);
  recording.ground_height = start.ground_height;
  recording.cloth.size = start.size.value_or(Eigen::Vector2d::Zero());
  recording.cloth.areal_density = start.areal_density;
  FlatPlacement flat{
      {0.0, 0.0, start.ground_height.value_or(0.0) + kAboveGround}, start.u_axis, start.v_axis};
  if (start.origin) flat.origin = *start.origin;
  recording.cloth.initial = flat;
  recording.handles = start.handles;
  HoldOut(start.held_out_share, &recording);
  return recording;
}

}  // namespace

void HoldOut(double share, Recording* recording) {
  if (!(share >= 0.0 && share < 1.0)) {
    throw InputError("--held-out", fmt::format("expected 0 to less than 1, found {}", share));
  }
  if (share == 0.0) return;
  const int count = recording->frame_count;
  const int held_out =
      std::min(std::max(static_cast<int>(std::lround(share * count)), 1), count - 1);
  recording->splits.held_out_frames = Splits::FrameRange{count - held_out, count - 1};
}

std::string NameOfFolder(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::vector<std::string> MissingOptions(const SceneStart& start) {
  std::vector<std::string> missing;
  if (!start.size) missing.emplace_back("--size");
  if (!start.frame_count) missing.emplace_back("--frames");
  if (!start.frame_rate) missing.emplace_back("--rate");
  if (!start.ground_height && !start.origin) missing.emplace_back("--ground, --origin or --corner");
  return missing;
}

OutputFolder OpenRecording(const fs::path& folder, const std::string& command,
                           Overwrite overwrite) {
  return OutputFolder(folder, FolderKind::kRecording, command,
                      overwrite == Overwrite::kAllow ? Existing::kAddAndReplace : Existing::kAdd);
}

void WriteStart(const SceneStart& start, OutputFolder* folder) {
  const std::map<std::string, std::string> files = FilesOf(RecordingOf(start, folder->path()));
  folder->Add(NamesOf(files));
  folder->WriteAll(files);
}

void WriteCameras(const std::vector<Camera>& cameras, OutputFolder* folder) {
  constexpr const char* kFile = "cameras.yaml";
  folder->CheckMayWrite(kFile);
  Recording recording;
  recording.path = folder->path();
  recording.frame_count = std::numeric_limits<int>::max();  // only the names are looked at here
  recording.cameras = cameras;
  CheckCameras(recording);
  ListPictures(recording);
  if (IsThere(folder->path() / "tracks.csv")) {
    std::vector<int> lines;
    ReadTracks(folder->path() / "tracks.csv", recording, &lines);
  }
  folder->Add({kFile});
  folder->WriteAll({{kFile, CamerasAsYaml(cameras)}});
}

}  // namespace clothfit
