// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take_recording.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/import/marker_layout.h"
#include "tracking/import/take_layout.h"

namespace clothfit {
namespace {

// "left=Unlabeled 1022", or the marker's name alone.
struct HandleChoice {
  std::string name;
  size_t marker = 0;
};

std::string MarkerOfHandle(const std::string& text) {
  const size_t equals = text.find('=');
  return equals == std::string::npos ? text : text.substr(equals + 1);
}

// Markers that count however seldom they are seen.
std::vector<std::string> NamesToKeep(const TakeOptions& options) {
  std::vector<std::string> names;
  for (const std::string& text : options.handles) names.push_back(MarkerOfHandle(text));
  if (!options.layout) return names;
  for (const auto& [name, uv] : *options.layout) names.push_back(name);
  return names;
}

std::vector<HandleChoice> FindHandles(const MarkerTake& take, const TakeOptions& options) {
  std::vector<HandleChoice> handles;
  for (const std::string& text : options.handles) {
    const std::string marker = MarkerOfHandle(text);
    handles.push_back({text.substr(0, text.find('=')), MarkerNamed(take, marker, "--handle")});
    for (size_t i = 0; i + 1 < handles.size(); ++i) {
      if (handles[i].marker != handles.back().marker) continue;
      throw InputError("--handle", "'" + marker + "' is named twice");
    }
  }
  return handles;
}

void AddMarkersAndHandles(const std::vector<HandleChoice>& handles, const MarkerTake& take,
                          const std::vector<Eigen::Vector2d>& uv, double sigma,
                          Recording* recording) {
  PointPlacement placement;
  for (size_t i = 0; i < uv.size(); ++i) {
    placement.points.push_back({uv[i], *take.markers[i].positions.front()});
  }
  recording->cloth.initial = placement;
  for (const HandleChoice& choice : handles) {
    HandleDescription handle;
    handle.name = choice.name;
    handle.uv = uv[choice.marker];
    handle.path = take.markers[choice.marker].positions;
    handle.path_sigma = sigma;
    recording->handles.push_back(handle);
  }
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    for (size_t i = 0; i < uv.size(); ++i) {
      const bool is_handle =
          std::any_of(handles.begin(), handles.end(),
                      [&](const HandleChoice& handle) { return handle.marker == i; });
      const std::optional<Eigen::Vector3d>& position = take.markers[i].positions[frame];
      if (is_handle || !position) continue;
      recording->markers.push_back({int(frame), int(i), uv[i], *position});
    }
  }
}

// Of one coordinate of a marker (m), and of a handle's path.
double SigmaOf(const MarkerTake& take, const TakeOptions& options,
               std::vector<std::string>* notes) {
  constexpr double kRounding = 1e6;  // steps a metre; one is the least, as no sigma is zero
  const std::optional<double> jitter = MarkerJitter(take.markers);
  if (jitter) notes->push_back(fmt::format("markers jitter by {:.3f} mm", 1e3 * *jitter));
  if (options.marker_sigma) return *options.marker_sigma;
  if (!jitter) return kDefaultMarkerSigma;
  return std::max(std::round(*jitter * kRounding), 1.0) / kRounding;
}

// About square cells, 21 particles along the longer side.
Eigen::Vector2i DefaultResolution(const Eigen::Vector2d& size) {
  constexpr double kCells = 20.0;
  constexpr double kLeastCells = 4.0;
  const Eigen::Array2d cells = (kCells * size.array() / size.maxCoeff()).round().max(kLeastCells);
  return cells.cast<int>() + 1;
}

void HoldOut(double share, Recording* recording) {
  if (share <= 0.0) return;
  const int count = recording->frame_count;
  const int held_out = std::clamp(static_cast<int>(std::lround(share * count)), 1, count - 1);
  recording->splits.held_out_frames = Splits::FrameRange{count - held_out, count - 1};
}

void CheckOptions(const TakeOptions& options) {
  const auto check = [](bool is_right, const char* option, const char* expected, double found) {
    if (!is_right) throw InputError(option, fmt::format("expected {}, found {}", expected, found));
  };
  check(options.held_out_share >= 0.0 && options.held_out_share < 1.0, "--held-out",
        "0 to less than 1", options.held_out_share);
  check(options.least_seen >= 0.0 && options.least_seen <= 1.0, "--least-seen", "0 to 1",
        options.least_seen);
  check(options.margin.value_or(0.0) >= 0.0, "--margin", "0 m or more",
        options.margin.value_or(0.0));
  if (options.margin && options.size) {
    throw InputError("--margin", "expected either this or --size, found both");
  }
}

}  // namespace

ImportedTake MakeTakeRecording(MarkerTake take, const TakeOptions& options) {
  CheckOptions(options);
  ImportedTake result;
  RemoveMarkers(options.ignored, options.least_seen, NamesToKeep(options), &take, &result.notes);
  const std::vector<HandleChoice> handles = FindHandles(take, options);
  std::vector<HandleDescription::Path> paths;
  for (const MarkerPath& marker : take.markers) paths.push_back(marker.positions);
  const Eigen::MatrixXd distances = LargestDistances(paths);  // before frames are left out
  TrimStart(&take, &result.notes);
  result.marker_names = NamesOf(take);
  std::vector<size_t> held;
  for (const HandleChoice& handle : handles) held.push_back(handle.marker);
  const LayoutOfTake layout = MakeLayout(take, held, distances, options, &result.notes);
  result.uv = layout.uv;
  Recording& recording = result.recording;
  recording.frame_rate = take.frame_rate;
  recording.frame_count = int(take.num_frames());
  recording.ground_height = options.ground_height;
  recording.cloth.size = layout.size;
  recording.cloth.resolution = options.resolution.value_or(DefaultResolution(recording.cloth.size));
  recording.cloth.areal_density = options.areal_density;
  const double sigma = SigmaOf(take, options, &result.notes);
  recording.noise.marker = sigma;
  AddMarkersAndHandles(handles, take, result.uv, sigma, &recording);
  HoldOut(options.held_out_share, &recording);
  return result;
}

}  // namespace clothfit
