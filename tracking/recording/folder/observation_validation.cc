// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks of what was observed, and of a recording as a whole.
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/recording/folder/validation.h"
#include "tracking/recording/limits.h"

namespace clothfit {
namespace {

// Line of the i-th entry; where none is known, that at which WriteRecording would put it.
int LineOf(const std::vector<int>& lines, size_t i) {
  return i < lines.size() ? lines[i] : static_cast<int>(i) + 2;
}

void CheckMarkers(const Recording& recording, const std::vector<int>& lines) {
  std::map<std::tuple<int, int>, int> line_of_key;
  for (size_t i = 0; i < recording.markers.size(); ++i) {
    const Marker& marker = recording.markers[i];
    const int line = LineOf(lines, i);
    const std::string place =
        PlaceInRecording(recording, "markers.csv", fmt::format("line {}", line));
    CheckFrame(recording, marker.frame, place);
    CheckOnCloth(recording, marker.uv, place);
    CheckPosition(marker.position, place);
    const auto [first, is_new] = line_of_key.try_emplace({marker.frame, marker.id}, line);
    if (!is_new) {
      throw InputError(place, fmt::format("frame {}, id {} appeared already on line {}",
                                          marker.frame, marker.id, first->second));
    }
  }
}

void CheckTracks(const Recording& recording, const std::vector<int>& lines) {
  std::map<std::tuple<int, int, int>, int> line_of_key;
  for (size_t i = 0; i < recording.tracks.size(); ++i) {
    const Track& track = recording.tracks[i];
    const int line = LineOf(lines, i);
    const std::string place =
        PlaceInRecording(recording, "tracks.csv", fmt::format("line {}", line));
    CheckFrame(recording, track.frame, place);
    if (track.camera < 0 || static_cast<size_t>(track.camera) >= recording.cameras.size()) {
      throw InputError(place, fmt::format("there is no camera number {}", track.camera));
    }
    CheckOnCloth(recording, track.uv, place);
    if (!track.pixel.allFinite() || track.pixel.cwiseAbs().maxCoeff() > kFarthestPixel) {
      throw InputError(place, fmt::format("expected finite x, y of at most {:g} px, found {}, {}",
                                          kFarthestPixel, track.pixel.x(), track.pixel.y()));
    }
    const auto [first, is_new] =
        line_of_key.try_emplace({track.frame, track.camera, track.id}, line);
    if (!is_new) {
      throw InputError(
          place, fmt::format("frame {}, camera {}, id {} appeared already on line {}", track.frame,
                             recording.cameras[static_cast<size_t>(track.camera)].name, track.id,
                             first->second));
    }
  }
}

bool HasPictures(const CameraFiles& files) {
  return !files.images.empty() || !files.masks.empty() || !files.depth.empty() ||
         files.video.has_value();
}

// Each depth picture has a scale, and what is said of cameras is said of those that there are.
void CheckCamerasOfClouds(const Recording& recording) {
  const CloudFiles& clouds = recording.clouds;
  const auto check = [&](const std::string& name, const char* key) {
    if (FindCamera(recording, name)) return;
    throw InputError(PlaceInRecording(recording, "recording.yaml", key),
                     Quoted(name) + " is no camera of cameras.yaml");
  };
  if (!clouds.camera.empty()) check(clouds.camera, "clouds.camera");
  for (const auto& [camera, scale] : clouds.depth_scales) {
    check(camera, "depth");
    if (scale >= kSigma.least && scale <= kSigma.most) continue;
    throw InputError(PlaceInRecording(recording, "recording.yaml", "depth"),
                     fmt::format("scale of {}: expected {} to {} m, found {}", Quoted(camera),
                                 kSigma.least, kSigma.most, scale));
  }
  for (std::size_t c = 0; c < recording.files.size(); ++c) {
    const std::string& camera = recording.cameras[c].name;
    if (recording.files[c].depth.empty() || clouds.depth_scales.count(camera) > 0) continue;
    throw InputError(PlaceInRecording(recording, "recording.yaml", "depth"),
                     "has no scale for the depth pictures of " + Quoted(camera));
  }
}

void CheckFiles(const Recording& recording) {
  if (!recording.files.empty() && recording.files.size() != recording.cameras.size()) {
    throw InputError(recording.path.string(),
                     fmt::format("pictures of {} cameras, but cameras.yaml holds {}",
                                 recording.files.size(), recording.cameras.size()));
  }
  for (const CameraFiles& files : recording.files) {
    for (const auto& [frame, file] : files.images) CheckFrame(recording, frame, file.string());
    for (const auto& [frame, file] : files.masks) CheckFrame(recording, frame, file.string());
    for (const auto& [frame, file] : files.depth) CheckFrame(recording, frame, file.string());
  }
  for (const auto& [frame, file] : recording.clouds.files)
    CheckFrame(recording, frame, file.string());
  CheckCamerasOfClouds(recording);
}

}  // namespace

void CheckObservations(const Recording& recording, const ObservationLines& lines) {
  CheckFiles(recording);
  CheckMarkers(recording, lines.markers);
  CheckTracks(recording, lines.tracks);
}

void CheckHasObservation(const Recording& recording) {
  for (const CameraFiles& files : recording.files) {
    if (HasPictures(files)) return;
  }
  const bool any_cloud = !recording.clouds.files.empty();
  if (any_cloud || !recording.markers.empty() || !recording.tracks.empty()) return;
  throw InputError(
      recording.path.string(),
      "there is no observation; expected images, videos, masks, depth, clouds, tracks.csv "
      "or markers.csv");
}

void CheckValues(const Recording& recording, const ObservationLines& lines) {
  CheckScene(recording);
  CheckCloth(recording);
  CheckHandles(recording);
  CheckObstacles(recording);
  CheckCameras(recording);
  CheckNoiseAndSplits(recording);
  CheckObservations(recording, lines);
}

void CheckRecording(const Recording& recording) {
  CheckValues(recording, {});
  CheckHasObservation(recording);
}

}  // namespace clothfit
