// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/summary.h"

#include <array>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::string SummaryRow(const std::string& label, const std::string& text) {
  return fmt::format("{:<{}}{}\n", label, kLabelWidth, text);
}

// "3 of 5 frames (0..4)".
std::string Frames(const std::set<int>& frames, const Recording& recording) {
  if (frames.empty()) return "no frame";
  return fmt::format("{} of {} frames ({}..{})", frames.size(), recording.frame_count,
                     *frames.begin(), *frames.rbegin());
}

std::set<int> KeysOf(const std::map<int, std::filesystem::path>& files) {
  std::set<int> keys;
  for (const auto& [frame, file] : files) keys.insert(frame);
  return keys;
}

std::string DescribeInitial(const ClothDescription& cloth) {
  if (std::holds_alternative<FlatPlacement>(cloth.initial)) return "flat";
  if (const auto* placement = std::get_if<PointPlacement>(&cloth.initial)) {
    return fmt::format("interpolated between {} points", placement->points.size());
  }
  return "mesh " + std::get<MeshPlacement>(cloth.initial).file.filename().string();
}

std::string DescribeCloth(const ClothDescription& cloth) {
  const std::string density = cloth.areal_density ? fmt::format("{} kg/m^2", *cloth.areal_density)
                                                  : std::string("areal density not known");
  return fmt::format("{} x {} m, {} x {} particles, {}; initially {}", cloth.size.x(),
                     cloth.size.y(), cloth.resolution.x(), cloth.resolution.y(), density,
                     DescribeInitial(cloth));
}

std::string DescribeHandle(const HandleDescription& handle, const Recording& recording) {
  std::string text =
      fmt::format("{} at (u, v) = ({}, {}), ", handle.name, handle.uv.x(), handle.uv.y());
  if (handle.path) {
    std::set<int> known;
    for (size_t frame = 0; frame < handle.path->size(); ++frame) {
      if ((*handle.path)[frame]) known.insert(static_cast<int>(frame));
    }
    text += fmt::format("path known in {} to {} m", Frames(known, recording),
                        handle.path_sigma.value_or(kDefaultPathSigma));
  } else {
    text += "path unknown";
  }
  return text + (handle.released_after
                     ? fmt::format(", released after frame {}", *handle.released_after)
                     : std::string(", never released"));
}

std::string DescribeMarkers(const Recording& recording) {
  if (recording.markers.empty()) return "none";
  std::set<int> frames;
  std::set<int> ids;
  for (const Marker& marker : recording.markers) {
    frames.insert(marker.frame);
    ids.insert(marker.id);
  }
  return fmt::format("{} positions of {} points in {}", recording.markers.size(), ids.size(),
                     Frames(frames, recording));
}

std::string DescribeTracks(const Recording& recording) {
  if (recording.tracks.empty()) return "none";
  std::set<int> frames;
  std::set<int> cameras;
  std::set<std::tuple<int, int>> features;
  for (const Track& track : recording.tracks) {
    frames.insert(track.frame);
    cameras.insert(track.camera);
    features.emplace(track.camera, track.id);
  }
  return fmt::format("{} positions of {} features of {} cameras in {}", recording.tracks.size(),
                     features.size(), cameras.size(), Frames(frames, recording));
}

// Which pictures there are of one camera: ", images in ..., masks in ...".
std::string DescribeFiles(const CameraFiles& files, const Recording& recording) {
  std::string text;
  if (!files.images.empty()) text += ", images in " + Frames(KeysOf(files.images), recording);
  if (files.video) text += ", video " + files.video->filename().string();
  if (!files.masks.empty()) text += ", masks in " + Frames(KeysOf(files.masks), recording);
  if (!files.depth.empty()) text += ", depth in " + Frames(KeysOf(files.depth), recording);
  if (files.background) text += ", background";
  return text.empty() ? ", no pictures" : text;
}

std::string DescribeCamera(const Recording& recording, size_t index) {
  const Camera& camera = recording.cameras[index];
  const bool is_distorted = camera.distortion != std::array<double, 5>{};
  return fmt::format(
      "{}, {} x {} px, {}{}{}", camera.name, camera.width, camera.height,
      is_distorted ? "with distortion" : "no distortion",
      recording.files.empty() ? "" : DescribeFiles(recording.files[index], recording),
      IsHeldOutCamera(recording, static_cast<int>(index)) ? ", held out" : "");
}

std::string Sigma(const std::optional<double>& given, double assumed, const char* unit) {
  return fmt::format("{} {}{}", given.value_or(assumed), unit, given ? "" : " (assumed)");
}

std::string DescribeNoise(const Recording& recording) {
  const NoiseSigmas& noise = recording.noise;
  return fmt::format("marker {}, track {}, silhouette {}",
                     Sigma(noise.marker, kDefaultMarkerSigma, "m"),
                     Sigma(noise.track, kDefaultTrackSigma, "px"),
                     Sigma(noise.silhouette, kDefaultSilhouetteSigma, "px")) +
         (HasClouds(recording)
              ? fmt::format(", cloud {} every {}", Sigma(noise.cloud, kDefaultCloudSigma, "m"),
                            Sigma(noise.cloud_spacing, kDefaultCloudSpacing, "m"))
              : std::string()) +
         (noise.layout ? fmt::format(", layout {} m", *noise.layout) : std::string()) +
         (noise.obstacles && !recording.obstacles.empty()
              ? fmt::format(", obstacles {} m", *noise.obstacles)
              : std::string());
}

std::string DescribeSplits(const Splits& splits) {
  std::string text;
  if (const auto& range = splits.held_out_frames) {
    text = fmt::format("frames {}..{}", range->first, range->last);
  }
  if (!splits.held_out_cameras.empty()) {
    text += (text.empty() ? "cameras " : ", cameras ") + JoinNames(splits.held_out_cameras);
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::string DescribeRecording(const Recording& recording) {
  const Eigen::Vector3d& gravity = recording.gravity;
  std::string text = SummaryRow("recording", recording.name);
  text += SummaryRow(
      "frames", fmt::format("{} at {} Hz, {:.2f} s", recording.frame_count, recording.frame_rate,
                            recording.frame_count / recording.frame_rate));
  text += SummaryRow("gravity",
                     fmt::format("({}, {}, {}) m/s^2", gravity.x(), gravity.y(), gravity.z()));
  text += SummaryRow("ground", recording.ground_height
                                   ? fmt::format("z = {} m", *recording.ground_height)
                                   : std::string("none"));
  text += SummaryRow("cloth", DescribeCloth(recording.cloth));
  for (const HandleDescription& handle : recording.handles) {
    text += SummaryRow("handle", DescribeHandle(handle, recording));
  }
  for (const ObstacleDescription& obstacle : recording.obstacles) {
    constexpr std::array<const char*, 4> kShapes = {"sphere", "capsule", "box", "mesh"};
    text += SummaryRow("obstacle",
                       fmt::format("{}, a {} {}", obstacle.name, kShapes.at(obstacle.shape.index()),
                                   obstacle.path.size() == 1 ? "at rest" : "on a path"));
  }
  text += SummaryRow("markers", DescribeMarkers(recording));
  text += SummaryRow("tracks", DescribeTracks(recording));
  if (!recording.clouds.files.empty()) {
    const std::string& camera = recording.clouds.camera;
    text +=
        SummaryRow("clouds", Frames(KeysOf(recording.clouds.files), recording) +
                                 (camera.empty() ? ", of the whole cloth" : ", seen by " + camera));
  }
  for (size_t i = 0; i < recording.cameras.size(); ++i) {
    text += SummaryRow("camera", DescribeCamera(recording, i));
  }
  text += SummaryRow("noise", DescribeNoise(recording));
  text += SummaryRow("held out", DescribeSplits(recording.splits));
  return text;
}

}  // namespace clothfit
