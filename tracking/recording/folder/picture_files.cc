// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/folder/picture_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/clouds/file.h"
#include "tracking/recording/folder/inside.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// What a folder of a recording holds, in order of name; nothing when there is no such folder.
std::vector<fs::path> SortedEntries(const fs::path& recording_folder, const fs::path& folder) {
  if (!IsThere(folder)) return {};
  CheckLinkLiesInside(recording_folder, folder);
  std::vector<fs::path> entries = ListInputFolder(folder);
  for (const fs::path& entry : entries) CheckLinkLiesInside(recording_folder, entry);
  return entries;
}

size_t CameraNamed(const Recording& recording, const std::string& name, const fs::path& place) {
  const std::optional<int> camera = FindCamera(recording, name);
  if (camera) return static_cast<size_t>(*camera);
  throw InputError(place.string(), IsNoCamera(name, recording.cameras));
}

// The frame that a name such as 000042.png stands for.
int FrameOfFile(const Recording& recording, const fs::path& file,
                const std::vector<std::string>& extensions) {
  const std::string stem = file.stem().string();
  const bool is_numbered =
      stem.size() == 6 &&
      std::all_of(stem.begin(), stem.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  const std::optional<int> frame = is_numbered ? ParseInteger(stem) : std::nullopt;
  if (!frame ||
      std::find(extensions.begin(), extensions.end(), file.extension()) == extensions.end()) {
    throw InputError(file.string(), "expected a name of six digits such as 000042" +
                                        JoinNames(extensions, " or 000042"));
  }
  if (*frame >= recording.frame_count) {
    throw InputError(file.string(),
                     fmt::format("frame {} is outside 0..{}", *frame, recording.frame_count - 1));
  }
  return *frame;
}

// CAMERA/%06d.png below the folder, by frame.
void ListFrames(const Recording& recording, const fs::path& folder,
                std::map<int, fs::path> CameraFiles::*frames, std::vector<CameraFiles>* files) {
  for (const fs::path& entry : SortedEntries(recording.path, folder)) {
    const size_t camera = CameraNamed(recording, entry.filename().string(), entry);
    for (const fs::path& file : SortedEntries(recording.path, entry)) {
      ((*files)[camera].*frames)[FrameOfFile(recording, file, {".png"})] = file;
    }
  }
}

// CAMERA.anything below the folder.
void ListSingles(const Recording& recording, const fs::path& folder,
                 std::optional<fs::path> CameraFiles::*single, std::vector<CameraFiles>* files) {
  for (const fs::path& file : SortedEntries(recording.path, folder)) {
    std::optional<fs::path>& place =
        (*files)[CameraNamed(recording, file.stem().string(), file)].*single;
    if (place)
      throw InputError(file.string(), "is the second for its camera beside " + place->string());
    place = file;
  }
}

}  // namespace

std::vector<std::string> PictureFolders(const fs::path& recording_folder) {
  std::vector<std::string> folders;
  for (const char* name : {"images", "videos", "background", "masks", "depth"}) {
    if (!SortedEntries(recording_folder, recording_folder / name).empty())
      folders.emplace_back(name);
  }
  return folders;
}

std::vector<CameraFiles> ListPictures(const Recording& recording) {
  std::vector<CameraFiles> files(recording.cameras.size());
  ListFrames(recording, recording.path / "images", &CameraFiles::images, &files);
  ListFrames(recording, recording.path / "masks", &CameraFiles::masks, &files);
  ListFrames(recording, recording.path / "depth", &CameraFiles::depth, &files);
  ListSingles(recording, recording.path / "videos", &CameraFiles::video, &files);
  ListSingles(recording, recording.path / "background", &CameraFiles::background, &files);
  return files;
}

std::map<int, fs::path> ListClouds(const Recording& recording) {
  std::map<int, fs::path> files;
  for (const fs::path& file : SortedEntries(recording.path, recording.path / "clouds")) {
    const auto [first, is_new] =
        files.try_emplace(FrameOfFile(recording, file, CloudExtensions()), file);
    if (!is_new)
      throw InputError(file.string(),
                       "is the second of its frame beside " + first->second.string());
  }
  return files;
}

}  // namespace clothfit
