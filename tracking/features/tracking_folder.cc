// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/tracking_folder.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOrigin = "origin.txt";

fs::path MaskFile(const fs::path& folder, const Camera& camera, int frame) {
  return folder / "masks" / camera.name / fmt::format("{:06d}.png", frame);
}

void WriteMask(const cv::Mat& mask, const fs::path& file) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file.string(), mask);
  } catch (const cv::Exception&) {
  }
  if (!is_written) throw InputError(file.string(), "cannot be written");
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made (" + error.message() + ")");
}

void CopyMasks(const Recording& recording, const fs::path& folder) {
  for (std::size_t c = 0; c < recording.files.size(); ++c) {
    for (const auto& [frame, file] : recording.files[c].masks) {
      const fs::path copy = MaskFile(folder, recording.cameras[c], frame);
      std::error_code error;
      fs::copy_file(file, copy, fs::copy_options::overwrite_existing, error);
      if (error) throw InputError(copy.string(), "cannot be written (" + error.message() + ")");
    }
  }
}

}  // namespace

TrackingResult TrackIntoFolder(const Recording& recording, const TrackingOptions& options,
                               const fs::path& folder, Overwrite overwrite,
                               const TrackingCallbacks& callbacks) {
  if (fs::exists(folder / "recording.yaml")) {
    if (overwrite == Overwrite::kRefuse) {
      throw InputError(folder.string(), "already holds a recording; --force replaces it");
    }
    std::error_code error;
    if (fs::equivalent(folder, recording.path, error)) {
      throw InputError(folder.string(), "is the recording itself; expected another folder");
    }
    fs::remove_all(folder / "masks", error);
  }
  for (const Camera& camera : recording.cameras) MakeFolder(folder / "masks" / camera.name);
  CopyMasks(recording, folder);
  TrackingCallbacks with_masks = callbacks;
  with_masks.on_silhouette = [&](int camera, int frame, const Silhouette& silhouette) {
    WriteMask(silhouette.mask, MaskFile(folder, recording.cameras[camera], frame));
    if (callbacks.on_silhouette) callbacks.on_silhouette(camera, frame, silhouette);
  };
  TrackingResult result = TrackRecording(recording, options, with_masks);
  WriteRecording(WithObservations(recording, result), folder, Overwrite::kAllow);
  WriteTextFile(folder / "pictures.csv", PicturesAsCsv(recording, result));
  WriteTextFile(folder / "filters.csv", FiltersAsCsv(result));
  WriteTextFile(folder / kOrigin, fs::absolute(recording.path).lexically_normal().string() + "\n");
  return result;
}

std::optional<fs::path> OriginOfTracking(const fs::path& folder) {
  if (!fs::exists(folder / kOrigin)) return std::nullopt;
  const std::string text = ReadTextFile(folder / kOrigin);
  return text.substr(0, text.find('\n'));
}

}  // namespace clothfit
