// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/tracking_folder.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/files/output_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOrigin = "origin.txt";

std::string MaskFile(const Camera& camera, int frame) {
  return fmt::format("masks/{}/{:06d}.png", camera.name, frame);
}

void WriteMask(const cv::Mat& mask, const fs::path& file) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file.string(), mask);
  } catch (const cv::Exception&) {
  }
  if (!is_written) throw InputError(file.string(), "cannot be written");
}

// What tracking hands on as it is, and under which name.
std::vector<std::pair<fs::path, std::string>> CopiedFiles(const Recording& recording) {
  std::vector<std::pair<fs::path, std::string>> files;
  for (std::size_t c = 0; c < recording.files.size(); ++c) {
    for (const auto& [frame, file] : recording.files[c].masks)
      files.emplace_back(file, MaskFile(recording.cameras[c], frame));
    for (const auto& [frame, file] : recording.files[c].depth)
      files.emplace_back(file,
                         fmt::format("depth/{}/{:06d}.png", recording.cameras[c].name, frame));
  }
  for (const auto& [frame, file] : recording.clouds.files)
    files.emplace_back(file, "clouds/" + file.filename().string());
  return files;
}

// All that tracking may write.
std::vector<std::string> FilesOfTracking(const Recording& recording, bool find_masks) {
  std::vector<std::string> files = NamesOf(FilesOf(recording));
  files.insert(files.end(), {"tracks.csv", "markers.csv", "pictures.csv", "filters.csv", kOrigin});
  for (std::size_t c = 0; c < recording.cameras.size(); ++c) {
    for (int frame = 0; frame < recording.frame_count; ++frame) {
      if (find_masks) files.push_back(MaskFile(recording.cameras[c], frame));
    }
  }
  for (const auto& [file, copy] : CopiedFiles(recording)) files.push_back(copy);
  return files;
}

void CopyFiles(const Recording& recording, const fs::path& folder) {
  for (const auto& [file, name] : CopiedFiles(recording)) {
    const fs::path copy = folder / name;
    std::error_code error;
    fs::copy_file(file, copy, error);
    if (error) throw InputError(copy.string(), "cannot be written (" + error.message() + ")");
  }
}

}  // namespace

TrackingResult TrackIntoFolder(const Recording& recording, const TrackingOptions& options,
                               const fs::path& folder, Overwrite overwrite,
                               const TrackingCallbacks& callbacks) {
  std::error_code error;
  if (overwrite == Overwrite::kAllow && fs::equivalent(folder, recording.path, error))
    throw InputError(folder.string(), "is the recording itself; expected another folder");
  OutputFolder output(folder, FolderKind::kRecording, "track", ExistingIf(overwrite));
  output.Begin(FilesOfTracking(recording, options.find_masks));
  CopyFiles(recording, folder);
  TrackingCallbacks with_masks = callbacks;
  with_masks.on_silhouette = [&](int camera, int frame, const Silhouette& silhouette) {
    WriteMask(silhouette.mask, folder / MaskFile(recording.cameras[camera], frame));
    if (callbacks.on_silhouette) callbacks.on_silhouette(camera, frame, silhouette);
  };
  TrackingResult result = TrackRecording(recording, options, with_masks);
  std::map<std::string, std::string> files = FilesOf(WithObservations(recording, result));
  files["pictures.csv"] = PicturesAsCsv(recording, result);
  files["filters.csv"] = FiltersAsCsv(result);
  files[kOrigin] = fs::absolute(recording.path).lexically_normal().string() + "\n";
  output.WriteAll(files);
  return result;
}

std::optional<fs::path> OriginOfTracking(const fs::path& folder) {
  if (!fs::exists(folder / kOrigin)) return std::nullopt;
  const std::string text = ReadTextFile(folder / kOrigin);
  return text.substr(0, text.find('\n'));
}

}  // namespace clothfit
