// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/scene/clouds.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/clouds/clouds.h"

namespace clothfit {

Clouds LoadClouds(const Recording& recording, int most_points) {
  struct Place {
    int frame;
    bool is_depth;
    std::optional<int> camera;
  };
  std::vector<Place> places;
  for (int frame = 0; frame < recording.frame_count; ++frame) {
    if (recording.clouds.files.count(frame) > 0)
      places.push_back({frame, false, FindCamera(recording, recording.clouds.camera)});
    for (std::size_t c = 0; c < recording.files.size(); ++c) {
      if (recording.files[c].depth.count(frame) > 0)
        places.push_back({frame, true, static_cast<int>(c)});
    }
  }
  const double spacing = recording.noise.cloud_spacing.value_or(kDefaultCloudSpacing);
  std::vector<ThinnedPoints> thinned(places.size());
  ParallelFor(static_cast<int>(places.size()), NumThreads(0), [&](int i, int) {
    const Place& place = places[i];
    thinned[i] = ThinPoints(place.is_depth ? LoadDepth(recording, *place.camera, place.frame)
                                           : LoadCloud(recording, place.frame),
                            spacing, most_points);
  });
  Clouds clouds;
  clouds.most_points = most_points;
  int num_empty = 0, first_empty = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (thinned[i].points.empty()) {
      if (num_empty++ == 0) first_empty = places[i].frame;
      continue;
    }
    const double spread =
        std::sqrt(recording.cloth.size.prod() / static_cast<double>(thinned[i].points.size()));
    clouds.observations.push_back({places[i].frame, places[i].camera, std::move(thinned[i].points),
                                   std::max(thinned[i].spacing, spread)});
  }
  if (num_empty > 0) {
    clouds.warnings.push_back(
        fmt::format("{} clouds or depth pictures hold no point, the first in frame {}: they are "
                    "left out",
                    num_empty, first_empty));
  }
  return clouds;
}

}  // namespace clothfit
