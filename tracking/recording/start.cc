// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/start.h"

#include <limits>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/picture_files.h"
#include "tracking/recording/tables.h"
#include "tracking/recording/validation.h"
#include "tracking/text/text.h"

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
  FlatPlacement flat{
      {0.0, 0.0, start.ground_height.value_or(0.0) + kAboveGround}, start.u_axis, start.v_axis};
  if (start.origin) flat.origin = *start.origin;
  recording.cloth.initial = flat;
  return recording;
}

}  // namespace

std::string NameOfFolder(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::vector<std::string> MissingOptions(const SceneStart& start) {
  std::vector<std::string> missing;
  if (!start.size) missing.emplace_back("--size");
  if (!start.frame_count) missing.emplace_back("--frames");
  if (!start.frame_rate) missing.emplace_back("--rate");
  if (!start.ground_height && !start.origin) missing.emplace_back("--ground or --origin");
  return missing;
}

void CheckMayWrite(const fs::path& file, Overwrite overwrite) {
  if (overwrite == Overwrite::kAllow || !fs::exists(file)) return;
  throw InputError(file.string(), "exists already; --force replaces it");
}

void WriteStart(const SceneStart& start, const fs::path& folder, Overwrite overwrite) {
  CheckMayWrite(folder / "recording.yaml", overwrite);
  const Recording recording = RecordingOf(start, folder);
  CheckScene(recording);
  CheckCloth(recording);
  // Written elsewhere first: in the folder itself, what lies there would be taken for the remains
  // of another recording and removed.
  const fs::path part = folder / "recording.part";
  try {
    WriteRecording(recording, part, Overwrite::kAllow);
    fs::rename(part / "recording.yaml", folder / "recording.yaml");
    fs::remove_all(part);
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(),
                     fmt::format("cannot be written ({})", error.code().message()));
  }
}

void WriteCameras(const std::vector<Camera>& cameras, const fs::path& folder, Overwrite overwrite) {
  const fs::path file = folder / "cameras.yaml";
  CheckMayWrite(file, overwrite);
  Recording recording;
  recording.path = folder;
  recording.frame_count = std::numeric_limits<int>::max();  // only the names are looked at here
  recording.cameras = cameras;
  CheckCameras(recording);
  ListPictures(recording);
  if (fs::exists(folder / "tracks.csv")) {
    std::vector<int> lines;
    ReadTracks(folder / "tracks.csv", recording, &lines);
  }
  WriteTextFile(file, CamerasAsYaml(cameras));
}

}  // namespace clothfit
