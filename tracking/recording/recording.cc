// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/recording.h"

#include <algorithm>

namespace clothfit {

std::optional<int> FindCamera(const Recording& recording, const std::string& name) {
  const auto found = std::find_if(recording.cameras.begin(), recording.cameras.end(),
                                  [&](const Camera& camera) { return camera.name == name; });
  if (found == recording.cameras.end()) return std::nullopt;
  return static_cast<int>(found - recording.cameras.begin());
}

bool HasMasks(const Recording& recording) {
  return std::any_of(recording.files.begin(), recording.files.end(),
                     [](const CameraFiles& files) { return !files.masks.empty(); });
}

bool HasClouds(const Recording& recording) {
  return !recording.clouds.files.empty() ||
         std::any_of(recording.files.begin(), recording.files.end(),
                     [](const CameraFiles& files) { return !files.depth.empty(); });
}

bool HasPictures(const Recording& recording) {
  return std::any_of(recording.files.begin(), recording.files.end(), [](const CameraFiles& files) {
    return !files.images.empty() || files.video.has_value();
  });
}

bool IsHeldOutFrame(const Recording& recording, int frame) {
  const std::optional<Splits::FrameRange>& range = recording.splits.held_out_frames;
  return range && frame >= range->first && frame <= range->last;
}

bool IsHeldOutCamera(const Recording& recording, int camera) {
  const std::vector<std::string>& names = recording.splits.held_out_cameras;
  const std::string& name = recording.cameras.at(static_cast<size_t>(camera)).name;
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace clothfit
