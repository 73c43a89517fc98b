// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What makes the options of a synthetic recording usable.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "tracking/recording/limits.h"
#include "tracking/synthetic/keys.h"
#include "tracking/synthetic/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::string ValueOf(const SyntheticOptions& options, const std::string& name) {
  for (const SyntheticKey& key : SyntheticKeys()) {
    if (key.name == name) return JoinNames(key.words(options), " ");
  }
  throw std::logic_error(name + ": no such key");
}

void CheckParameters(const std::map<std::string, double>& parameters, const std::string& place) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const auto& [name, value] : parameters) {
    const Parameter& p = table[RequireParameter(table, name, place)].parameter;
    if ((value >= p.lower && value <= p.upper) || value == p.off) continue;
    throw InputError(place + ": " + name, fmt::format("{}: expected {} to {} {} (or {}, off)",
                                                      value, p.lower, p.upper, p.unit, p.off));
  }
}

void CheckHiddenHandles(const SyntheticOptions& options, const std::string& place) {
  const std::vector<std::string> names =
      NamesOf(MakeSyntheticMotion(options.scenario, options.size, options.Duration()).handles);
  for (const std::string& name : options.hidden_handles) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw InputError(place, "'" + name + "' is no handle; " + Suggestion(name, names));
  }
}

}  // namespace

double SyntheticOptions::Duration() const { return (frame_count - 1) / frame_rate; }

void SyntheticOptions::Check(const std::string& place) const {
  Check([&place](const std::string& key) { return place + ": " + key; });
}

void SyntheticOptions::Check(const PlaceOfKey& place_of) const {
  const auto expect = [&](bool right, const std::string& key, const std::string& expected) {
    if (!right) throw InputError(place_of(key), ValueOf(*this, key) + ": expected " + expected);
  };
  const auto not_negative = [](double value) { return std::isfinite(value) && value >= 0.0; };
  const auto within = [](double value, const Limits& limits) {
    return value >= limits.least && value <= limits.most;
  };
  constexpr int kMostPoints = 1000;       // along each side: markers and truth, a million in all
  constexpr double kMostSteps = 1e7;      // hours, on the smallest of meshes
  constexpr double kMostSynthetic = 1e8;  // points of all clouds, in memory 2.4 GB
  expect(within(size.x(), kSide) && within(size.y(), kSide), "size",
         fmt::format("two lengths of {} to {} m", kSide.least, kSide.most));
  expect(resolution.minCoeff() >= 2 && resolution.maxCoeff() <= 500, "resolution",
         "2 to 500 particles along u and v");
  expect(refinement >= 1 && refinement <= 16, "refinement", "1 to 16");
  CheckParameters(parameters, place_of("parameters"));
  expect(within(frame_rate, kFrameRate), "rate",
         fmt::format("a frame rate of {} to {} Hz", kFrameRate.least, kFrameRate.most));
  expect(frame_count >= 2 && frame_count <= kMostFrames, "frames",
         fmt::format("2 to {}", kMostFrames));
  expect(steps_per_frame >= 1 && static_cast<double>(steps_per_frame) * frame_count <= kMostSteps,
         "steps", fmt::format("1 or more a frame, at most {:g} in all", kMostSteps));
  expect(held_out_share >= 0.0 && held_out_share < 1.0, "held_out",
         "a share of the frames from 0 to below 1");
  expect(markers.minCoeff() >= 0 && markers.maxCoeff() <= kMostPoints, "markers",
         fmt::format("0 to {} along u and v", kMostPoints));
  expect(num_cameras >= 0 && num_cameras <= kMostThings, "cameras",
         fmt::format("0 to {}", kMostThings));
  expect(num_cameras > 0 || !images, "cameras", "1 or more, where there are images");
  if (images) pictures.Check(expect);
  const bool any_point = markers.minCoeff() > 0 || cloud_points > 0;
  expect(any_point || num_cameras > 0, "markers", "some, where there is no camera and no cloud");
  expect(any_point || tracks || images, "markers",
         "some, where there are neither tracks nor images nor clouds");
  expect(cloud_points >= 0 && cloud_points <= kMostCloudPoints &&
             static_cast<double>(cloud_points) * frame_count <= kMostSynthetic,
         "cloud_points",
         fmt::format("0 to {}, at most {:g} in all", kMostCloudPoints, kMostSynthetic));
  expect(not_negative(marker_sigma), "noise", "0 or more");
  expect(not_negative(layout_sigma), "layout_noise", "0 or more");
  expect(not_negative(track_sigma), "track_noise", "0 or more");
  expect(not_negative(cloud_sigma), "cloud_noise", "0 or more");
  expect(truth_points.minCoeff() >= 2 && truth_points.maxCoeff() <= kMostPoints, "truth_points",
         fmt::format("2 to {} along u and v", kMostPoints));
  CheckHiddenHandles(*this, place_of("hide_handle"));
}

}  // namespace clothfit
