// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What is allowed in a recording but worth knowing.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "tracking/recording/warnings/placement.h"
#include "tracking/recording/warnings/points.h"
#include "tracking/recording/warnings/summary.h"
#include "tracking/recording/warnings/support.h"

namespace clothfit {
namespace {

void WarnOfHandles(const Recording& recording, std::vector<std::string>* warnings) {
  for (const HandleDescription& handle : recording.handles) {
    if (!handle.path) {
      if (handle.path_sigma) {
        warnings->push_back(fmt::format("handle {}: path_sigma without a path", handle.name));
      }
      continue;
    }
    const int last = handle.released_after.value_or(recording.frame_count - 1);
    int missing = 0;
    int first_missing = 0;
    for (int frame = last; frame >= 0; --frame) {
      if ((*handle.path)[static_cast<size_t>(frame)]) continue;
      ++missing;
      first_missing = frame;
    }
    if (missing > 0) {
      warnings->push_back(fmt::format("handle {}: path lacks {} of {} frames (first: {})",
                                      handle.name, missing, last + 1, first_missing));
    }
    if (!handle.path_sigma) {
      warnings->push_back(fmt::format("handle {}: no path_sigma given; {} m is assumed",
                                      handle.name, kDefaultPathSigma));
    }
  }
  std::string lack = DescribeLackOfSupport(recording);
  if (!lack.empty()) warnings->push_back(std::move(lack));
}

void WarnOfScene(const Recording& recording, std::vector<std::string>* warnings) {
  if (!recording.cloth.areal_density) {
    warnings->emplace_back(
        "areal density is not known: stiffness, damping and drag can only be found relative to it");
  }
  const double longer = recording.cloth.size.maxCoeff(), shorter = recording.cloth.size.minCoeff();
  constexpr double kMostRatio = 20.0, kLargest = 20.0, kSmallest = 0.02;  // m; of cloth on record
  if (longer > kMostRatio * shorter || longer > kLargest || longer < kSmallest) {
    warnings->push_back(fmt::format("the cloth is {} x {} m; is that meant?",
                                    recording.cloth.size.x(), recording.cloth.size.y()));
  }
  const double gravity = recording.gravity.norm();
  if (gravity < 9.7 || gravity > 9.9) {  // on Earth: 9.76 to 9.83
    warnings->push_back(fmt::format("gravity is {} m/s^2, not that of the Earth", gravity));
  }
}

// What there is of observations, in the frames and cameras that a fit may use.
struct Coverage {
  std::set<int> frames;  // with any observation
  bool has_silhouettes = false;
  bool has_video = false;
  bool any_to_fit = false;
};

Coverage FindCoverage(const Recording& recording) {
  Coverage coverage;
  const auto add = [&](int frame, bool is_held_out) {
    coverage.frames.insert(frame);
    if (!is_held_out && !IsHeldOutFrame(recording, frame)) coverage.any_to_fit = true;
  };
  for (const Marker& marker : recording.markers) add(marker.frame, false);
  for (const Track& track : recording.tracks) {
    add(track.frame, IsHeldOutCamera(recording, track.camera));
  }
  for (const auto& [frame, file] : recording.clouds.files) add(frame, false);
  for (size_t i = 0; i < recording.files.size(); ++i) {
    const bool is_held_out = IsHeldOutCamera(recording, static_cast<int>(i));
    const CameraFiles& files = recording.files[i];
    for (const auto& [frame, file] : files.images) add(frame, is_held_out);
    for (const auto& [frame, file] : files.masks) add(frame, is_held_out);
    for (const auto& [frame, file] : files.depth) add(frame, is_held_out);
    coverage.has_video = coverage.has_video || files.video.has_value();
    coverage.has_silhouettes =
        coverage.has_silhouettes || !files.masks.empty() || files.background.has_value();
    if (files.video && !is_held_out) coverage.any_to_fit = true;
  }
  return coverage;
}

void WarnOfCoverage(const Recording& recording, const Coverage& coverage,
                    std::vector<std::string>* warnings) {
  if (!coverage.any_to_fit) {
    warnings->emplace_back("everything observed is held out: nothing is left to fit");
  }
  const int missing = recording.frame_count - static_cast<int>(coverage.frames.size());
  if (missing > 0 && !coverage.has_video) {  // which frames a video has is not known yet
    int first = 0;
    while (coverage.frames.count(first) != 0) ++first;
    warnings->push_back(
        fmt::format("{} frames are without any observation (first: {})", missing, first));
  }
}

void WarnOfNoise(const Recording& recording, const Coverage& coverage,
                 std::vector<std::string>* warnings) {
  const auto warn = [&](bool is_used, const std::optional<double>& given, const char* kind,
                        double assumed, const char* unit) {
    if (!is_used || given) return;
    warnings->push_back(fmt::format("no noise.{} given; {} {} is assumed", kind, assumed, unit));
  };
  warn(!recording.markers.empty(), recording.noise.marker, "marker", kDefaultMarkerSigma, "m");
  warn(!recording.tracks.empty(), recording.noise.track, "track", kDefaultTrackSigma, "px");
  warn(coverage.has_silhouettes, recording.noise.silhouette, "silhouette", kDefaultSilhouetteSigma,
       "px");
  warn(HasClouds(recording), recording.noise.cloud, "cloud", kDefaultCloudSigma, "m");
  warn(HasClouds(recording), recording.noise.cloud_spacing, "cloud_spacing", kDefaultCloudSpacing,
       "m");
}

void WarnOfCameras(const Recording& recording, std::vector<std::string>* warnings) {
  for (size_t i = 0; i < recording.files.size(); ++i) {
    const CameraFiles& files = recording.files[i];
    const std::string& name = recording.cameras[i].name;
    const bool has_images = !files.images.empty() || files.video.has_value();
    if (!files.images.empty() && files.video) {
      warnings->push_back(fmt::format("camera {}: has images, so its video is not used", name));
    }
    if (has_images && files.masks.empty() && !files.background) {
      warnings->push_back(fmt::format(
          "camera {}: images but neither masks nor background, so no silhouettes", name));
    }
  }
  constexpr double kFarInClothSizes = 1000.0;  // there it would be smaller than a pixel or so
  for (const Camera& camera : recording.cameras) {
    const double distance = CameraCentre(camera).norm();
    if (distance <= kFarInClothSizes * std::max(1.0, recording.cloth.size.maxCoeff())) continue;
    warnings->push_back(
        fmt::format("camera {}: stands {:.0f} m from the world's origin; is that "
                    "meant?",
                    camera.name, distance));
  }
  if (recording.cameras.size() == 1 && recording.markers.empty() && !HasClouds(recording)) {
    warnings->emplace_back("a single camera: depth is only weakly known");
  }
  const auto outside =
      std::count_if(recording.tracks.begin(), recording.tracks.end(), [&](const Track& track) {
        return !IsInImage(recording.cameras[static_cast<size_t>(track.camera)], track.pixel);
      });
  if (outside > 0) {
    warnings->push_back(fmt::format("{} rows of tracks.csv lie outside the picture", outside));
  }
}

}  // namespace

std::vector<std::string> Warnings(const Recording& recording) {
  std::vector<std::string> warnings;
  const Coverage coverage = FindCoverage(recording);
  WarnOfCoverage(recording, coverage, &warnings);
  WarnOfPlacement(recording, &warnings);
  WarnOfPoints(recording, &warnings);
  WarnOfHandles(recording, &warnings);
  WarnOfCameras(recording, &warnings);
  WarnOfScene(recording, &warnings);
  WarnOfNoise(recording, coverage, &warnings);
  return warnings;
}

}  // namespace clothfit
