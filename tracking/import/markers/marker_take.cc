// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/marker_take.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr size_t kLeastMarkers = 4;  // three lie in a plane whatever the cloth does

size_t NumSeen(const MarkerPath& marker) {
  return static_cast<size_t>(
      std::count_if(marker.positions.begin(), marker.positions.end(),
                    [](const auto& position) { return position.has_value(); }));
}

std::vector<std::string> MissingAt(const MarkerTake& take, size_t frame) {
  std::vector<std::string> missing;
  for (const MarkerPath& marker : take.markers) {
    if (!marker.positions[frame]) missing.push_back(marker.name);
  }
  return missing;
}

template <class Change>
void ChangePaths(MarkerTake* take, Change change) {
  for (MarkerPath& marker : take->markers) change(&marker.positions);
  for (RigidBody& body : take->bodies) {
    for (MarkerPath& marker : body.markers) change(&marker.positions);
  }
}

}  // namespace

size_t MarkerNamed(const MarkerTake& take, const std::string& name, const std::string& option) {
  const std::vector<std::string> names = NamesOf(take);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError(option, fmt::format("'{}' is no marker of {}; {}", name, take.file.string(),
                                         Suggestion(name, names)));
  }
  return static_cast<size_t>(found - names.begin());
}

LayoutByName ReadLayout(const std::filesystem::path& file) {
  LayoutByName layout;
  ReadCsv(file, {"name", "u", "v"}, [&](const CsvRow& row) {
    if (!layout.emplace(row.Text(0), row.Vector2(1)).second) {
      row.Fail(0, "'" + row.Text(0) + "' appears twice");
    }
  });
  return layout;
}

std::string LayoutAsCsv(const std::vector<std::string>& names,
                        const std::vector<Eigen::Vector2d>& uv) {
  std::string text = "name,u,v\n";
  for (size_t i = 0; i < uv.size(); ++i) {
    text += fmt::format("{},{:.5f},{:.5f}\n", names[i], uv[i].x(), uv[i].y());
  }
  return text;
}

void RemoveIgnored(const std::vector<std::string>& ignored, MarkerTake* take) {
  for (const std::string& name : ignored) {
    const size_t place = MarkerNamed(*take, name, "--ignore");
    take->markers.erase(take->markers.begin() + static_cast<std::ptrdiff_t>(place));
  }
}

void RemoveRare(double least_seen, const std::vector<std::string>& kept, MarkerTake* take,
                std::vector<std::string>* notes) {
  std::vector<std::string> removed;
  const auto is_rare = [&](const MarkerPath& marker) {
    const double share = static_cast<double>(NumSeen(marker)) / double(marker.positions.size());
    const bool is_kept = std::count(kept.begin(), kept.end(), marker.name) > 0;
    if (is_kept || share >= least_seen) return false;
    removed.push_back(fmt::format("{} ({:.1f} %)", marker.name, 100.0 * share));
    return true;
  };
  std::vector<MarkerPath>& markers = take->markers;
  markers.erase(std::remove_if(markers.begin(), markers.end(), is_rare), markers.end());
  if (!removed.empty()) {
    notes->push_back(fmt::format("left out, seen in less than {:g} % of the frames: {}",
                                 100.0 * least_seen, JoinNames(removed)));
  }
  if (markers.size() >= kLeastMarkers) return;
  throw InputError(take->file.string(), fmt::format("expected at least {} markers, found {}",
                                                    kLeastMarkers, markers.size()));
}

void TrimStart(MarkerTake* take, std::vector<std::string>* notes) {
  size_t fullest = 0;
  for (size_t frame = 0; frame < take->num_frames(); ++frame) {
    const std::vector<std::string> missing = MissingAt(*take, frame);
    if (missing.size() < MissingAt(*take, fullest).size()) fullest = frame;
    if (!missing.empty()) continue;
    if (frame == 0) return;
    notes->push_back(
        fmt::format("the first {} frames are left out: before that one marker or "
                    "another is not seen ({} at the first)",
                    frame, JoinNames(MissingAt(*take, 0))));
    ChangePaths(take, [&](HandleDescription::Path* path) {
      path->erase(path->begin(), path->begin() + static_cast<std::ptrdiff_t>(frame));
    });
    return;
  }
  throw InputError(
      take->file.string(),
      fmt::format("expected a frame that has all {} markers; the fullest, {}, lacks "
                  "{}; leave some out with --ignore",
                  take->markers.size(), fullest, JoinNames(MissingAt(*take, fullest))));
}

void ThinFrames(int every, MarkerTake* take) {
  take->frame_rate /= every;
  ChangePaths(take, [&](HandleDescription::Path* path) {
    HandleDescription::Path thinned;
    for (size_t frame = 0; frame < path->size(); frame += static_cast<size_t>(every)) {
      thinned.push_back((*path)[frame]);
    }
    *path = thinned;
  });
}

std::optional<double> MarkerJitter(const std::vector<MarkerPath>& markers) {
  std::vector<double> deviations;  // m, of single coordinates
  for (const MarkerPath& marker : markers) {
    const HandleDescription::Path& path = marker.positions;
    for (size_t frame = 1; frame + 1 < path.size(); ++frame) {
      if (!path[frame - 1] || !path[frame] || !path[frame + 1]) continue;
      const Eigen::Vector3d second = *path[frame - 1] - 2.0 * *path[frame] + *path[frame + 1];
      for (int axis = 0; axis < 3; ++axis) deviations.push_back(std::abs(second[axis]));
    }
  }
  if (deviations.empty()) return std::nullopt;
  const auto middle = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
  std::nth_element(deviations.begin(), middle, deviations.end());
  constexpr double kSigmaPerMedian = 1.4826;  // of absolute deviations, for a normal distribution
  return kSigmaPerMedian * *middle / std::sqrt(6.0);  // 1 + 4 + 1 variances add up
}

}  // namespace clothfit
