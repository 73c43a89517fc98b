// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What makes the options of a synthetic recording usable.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "tracking/recording/limits.h"
#include "tracking/synthetic/recording.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

void Expect(bool right, const std::string& place, const std::string& expected) {
  if (!right) throw InputError(place, "expected " + expected);
}

void CheckParameters(const std::map<std::string, double>& parameters, const std::string& place) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const auto& [name, value] : parameters) {
    const Parameter& p = table[RequireParameter(table, name, place)].parameter;
    Expect(
        (value >= p.lower && value <= p.upper) || value == p.off, place + ": " + name,
        fmt::format("{} to {} {} (or {}, off), found {}", p.lower, p.upper, p.unit, p.off, value));
  }
}

void CheckHiddenHandles(const SyntheticOptions& options, const std::string& place) {
  std::vector<std::string> names;
  for (const SyntheticHandle& handle :
       MakeSyntheticMotion(options.scenario, options.size, options.Duration()).handles) {
    names.push_back(handle.name);
  }
  for (const std::string& name : options.hidden_handles) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw InputError(place, "'" + name + "' is no handle; " + Suggestion(name, names));
  }
}

}  // namespace

double SyntheticOptions::Duration() const { return (frame_count - 1) / frame_rate; }

void SyntheticOptions::Check(const std::string& place) const {
  const auto not_negative = [](double value) { return std::isfinite(value) && value >= 0.0; };
  const auto within = [](double value, const Limits& limits) {
    return value >= limits.least && value <= limits.most;
  };
  constexpr int kMostPoints = 1000;       // along each side: markers and truth, a million in all
  constexpr double kMostSteps = 1e7;      // hours, on the smallest of meshes
  constexpr double kMostSynthetic = 1e8;  // points of all clouds, in memory 2.4 GB
  Expect(within(size.x(), kSide) && within(size.y(), kSide), place + ": size",
         fmt::format("two lengths of {} to {} m", kSide.least, kSide.most));
  Expect(resolution.minCoeff() >= 2 && resolution.maxCoeff() <= 500, place + ": resolution",
         "2 to 500 particles along u and v");
  Expect(refinement >= 1 && refinement <= 16, place + ": refinement", "1 to 16");
  CheckParameters(parameters, place + ": parameters");
  Expect(within(frame_rate, kFrameRate), place + ": rate",
         fmt::format("a frame rate of {} to {} Hz", kFrameRate.least, kFrameRate.most));
  Expect(frame_count >= 2 && frame_count <= kMostFrames, place + ": frames",
         fmt::format("2 to {}", kMostFrames));
  Expect(steps_per_frame >= 1 && static_cast<double>(steps_per_frame) * frame_count <= kMostSteps,
         place + ": steps", fmt::format("1 or more a frame, at most {:g} in all", kMostSteps));
  Expect(held_out_share >= 0.0 && held_out_share < 1.0, place + ": held out",
         "a share of the frames from 0 to below 1");
  Expect(markers.minCoeff() >= 0 && markers.maxCoeff() <= kMostPoints, place + ": markers",
         fmt::format("0 to {} along u and v", kMostPoints));
  Expect(num_cameras >= 0 && num_cameras <= kMostThings, place + ": cameras",
         fmt::format("0 to {}", kMostThings));
  Expect(num_cameras > 0 || !images, place + ": cameras", "1 or more, where there are images");
  if (images) pictures.Check(place);
  const bool any_point = markers.minCoeff() > 0 || cloud_points > 0;
  Expect(any_point || num_cameras > 0, place + ": markers",
         "some, where there is no camera and no cloud");
  Expect(any_point || tracks || images, place + ": markers",
         "some, where there are neither tracks nor images nor clouds");
  Expect(cloud_points >= 0 && cloud_points <= kMostCloudPoints &&
             static_cast<double>(cloud_points) * frame_count <= kMostSynthetic,
         place + ": cloud points",
         fmt::format("0 to {}, at most {:g} in all", kMostCloudPoints, kMostSynthetic));
  Expect(not_negative(marker_sigma) && not_negative(track_sigma) && not_negative(cloud_sigma),
         place + ": noise", "sigmas of 0 or more");
  Expect(truth_points.minCoeff() >= 2 && truth_points.maxCoeff() <= kMostPoints,
         place + ": truth points", fmt::format("2 to {} along u and v", kMostPoints));
  CheckHiddenHandles(*this, place + ": hidden handles");
}

}  // namespace clothfit
