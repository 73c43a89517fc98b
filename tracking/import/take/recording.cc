// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take/recording.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "tracking/import/markers/held_markers.h"
#include "tracking/import/markers/joined_tracks.h"
#include "tracking/import/markers/marker_layout.h"
#include "tracking/import/take/layout.h"
#include "tracking/import/take/obstacles.h"
#include "tracking/recording/folder/start.h"

namespace clothfit {
namespace {

// m. Markers stand off their bodies and off the cloth by about their own size, which no file has.
constexpr double kObstacleSigma = 0.01;

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

std::vector<HandleChoice> ProposeHandles(const MarkerTake& take, std::vector<std::string>* notes) {
  const std::vector<double> support = SupportAtStart(take);
  std::vector<HandleChoice> handles;
  std::vector<std::string> texts;
  double highest_other = 0.0;
  const std::vector<size_t> held = FindHeldMarkers(support, take);
  for (size_t i = 0; i < support.size(); ++i) {
    if (std::count(held.begin(), held.end(), i) == 0) {
      highest_other = std::max(highest_other, support[i]);
      continue;
    }
    handles.push_back({take.markers[i].name, i});
    texts.push_back(fmt::format("{} ({:.2f} g)", take.markers[i].name, support[i]));
  }
  if (handles.empty()) {
    notes->push_back(fmt::format(
        "no handles: at first no marker is above the lowest and carried by something else than the "
        "cloth (at most {:.2f} g, {:g} g would do); --handle names those that are held",
        highest_other, kHeldSupport));
  } else {
    notes->push_back(
        fmt::format("handles: {}: at first the cloth does not carry them; of others it "
                    "leaves at most {:.2f} g; --handle overrides",
                    JoinNames(texts), highest_other));
  }
  return handles;
}

std::vector<HandleChoice> FindHandles(const MarkerTake& take, const TakeOptions& options,
                                      std::vector<std::string>* notes) {
  if (options.handles.empty()) return ProposeHandles(take, notes);
  std::vector<HandleChoice> handles;
  if (options.handles == std::vector<std::string>{"none"}) return handles;
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

Eigen::MatrixXd DistancesIn(const MarkerTake& take) {
  std::vector<HandleDescription::Path> paths;
  for (const MarkerPath& marker : take.markers) paths.push_back(marker.positions);
  return LargestDistances(paths);
}

void RemoveLoose(const std::vector<std::string>& kept, MarkerTake* take,
                 std::vector<std::string>* notes) {
  while (const std::optional<size_t> loose = FindLooseMarker(DistancesIn(*take))) {
    const std::string name = take->markers[*loose].name;
    if (std::count(kept.begin(), kept.end(), name) > 0) return;
    notes->push_back(
        fmt::format("{} is left out: it does not keep its place on the cloth, and "
                    "without it the layout fits {:g} times better or more",
                    name, kLooseGain));
    take->markers.erase(take->markers.begin() + static_cast<std::ptrdiff_t>(*loose));
  }
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
double SigmaOf(const MarkerTake& take, double layout_rms, const TakeOptions& options,
               std::vector<std::string>* notes) {
  constexpr double kRounding = 1e6;  // steps a metre; one is the least, as no sigma is zero
  const std::optional<double> jitter = MarkerJitter(take.markers);
  if (options.marker_sigma) return *options.marker_sigma;
  const double sigma =
      jitter ? std::max(std::round(std::hypot(*jitter, layout_rms) * kRounding), 1.0) / kRounding
             : kDefaultMarkerSigma;
  notes->push_back(
      fmt::format("sigma of the markers: {:.2f} mm, of {:.3f} mm jitter and {:.2f} mm "
                  "layout; --sigma sets another",
                  1e3 * sigma, 1e3 * jitter.value_or(0.0), 1e3 * layout_rms));
  return sigma;
}

// About square cells, kTakeParticles along the longer side.
Eigen::Vector2i DefaultResolution(const Eigen::Vector2d& size) {
  constexpr double kCells = kTakeParticles - 1;
  constexpr double kLeastCells = 4.0;
  const Eigen::Array2d cells = (kCells * size.array() / size.maxCoeff()).round().max(kLeastCells);
  return cells.cast<int>() + 1;
}

void AddObstacles(const MarkerTake& take, const TakeOptions& options, ImportedTake* result) {
  Recording& recording = result->recording;
  recording.obstacles = MakeObstacles(take, options.obstacles, &result->notes);
  if (recording.obstacles.empty()) return;
  recording.noise.obstacles = kObstacleSigma;
  result->notes.push_back(fmt::format(
      "noise.obstacles: {} m: markers stand off their bodies and off the cloth by about "
      "as much; a fit finds where the obstacles are for the cloth",
      kObstacleSigma));
}

void CheckOptions(const TakeOptions& options) {
  const auto check = [](bool is_right, const char* option, const char* expected, double found) {
    if (!is_right) throw InputError(option, fmt::format("expected {}, found {}", expected, found));
  };
  check(options.least_seen >= 0.0 && options.least_seen <= 1.0, "--least-seen", "0 to 1",
        options.least_seen);
  check(options.every >= 1, "--every", "1 or more", options.every);
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
  const std::vector<std::string> kept = NamesToKeep(options);
  RemoveIgnored(options.ignored, &take);
  JoinTracks(kept, &take, &result.notes);
  RemoveRare(options.least_seen, kept, &take, &result.notes);
  if (!options.layout) RemoveLoose(kept, &take, &result.notes);
  const Eigen::MatrixXd distances = DistancesIn(take);  // before frames are left out
  TrimStart(&take, &result.notes);
  const std::vector<HandleChoice> handles = FindHandles(take, options, &result.notes);
  result.marker_names = NamesOf(take);
  std::vector<size_t> held;
  for (const HandleChoice& handle : handles) held.push_back(handle.marker);
  const LayoutOfTake layout = MakeLayout(take, held, distances, options, &result.notes);
  result.uv = layout.uv;
  const double sigma = SigmaOf(take, layout.rms, options, &result.notes);
  ThinFrames(options.every, &take);
  Recording& recording = result.recording;
  recording.frame_rate = take.frame_rate;
  recording.frame_count = int(take.num_frames());
  recording.ground_height = options.ground_height;
  recording.cloth.size = layout.size;
  recording.cloth.resolution = options.resolution.value_or(DefaultResolution(recording.cloth.size));
  recording.cloth.areal_density = options.areal_density;
  AddObstacles(take, options, &result);
  recording.noise.marker = sigma;
  AddMarkersAndHandles(handles, take, result.uv, sigma, &recording);
  HoldOut(options.held_out_share, &recording);
  return result;
}

}  // namespace clothfit
