// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/scene/silhouettes.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/pictures/images.h"

namespace clothfit {

SilhouetteObservation MakeSilhouette(int frame, int camera, const cv::Mat& mask) {
  SilhouetteObservation silhouette;
  silhouette.frame = frame;
  silhouette.camera = camera;
  silhouette.mask = BitMask(mask);
  silhouette.field.emplace(mask);
  silhouette.outline = silhouette.field->Outline(mask, kOutlineSpacing);
  return silhouette;
}

Silhouettes LoadSilhouettes(const Recording& recording,
                            const std::function<bool(int frame, int camera)>& is_fitted) {
  struct Place {
    int frame, camera;
  };
  std::vector<Place> places;
  for (int frame = 0; frame < recording.frame_count; ++frame) {
    for (int camera = 0; camera < static_cast<int>(recording.files.size()); ++camera) {
      if (recording.files[camera].masks.count(frame) > 0) places.push_back({frame, camera});
    }
  }
  std::vector<SilhouetteObservation> all(places.size());
  std::vector<char> is_empty(places.size(), 0);
  ParallelFor(static_cast<int>(places.size()), NumThreads(0), [&](int i, int) {
    const auto [frame, camera] = places[i];
    const cv::Mat mask = LoadMask(recording, camera, frame);
    is_empty[i] = cv::countNonZero(mask) == 0 ? 1 : 0;
    if (is_empty[i] == 0 && is_fitted(frame, camera)) {
      all[i] = MakeSilhouette(frame, camera, mask);
      return;
    }
    all[i].frame = frame;
    all[i].camera = camera;
    all[i].mask = BitMask(mask);
  });
  Silhouettes silhouettes;
  std::vector<int> num_empty(recording.cameras.size(), 0), first_empty(recording.cameras.size(), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_empty[i] == 0) {
      silhouettes.observations.push_back(std::move(all[i]));
    } else if (num_empty[all[i].camera]++ == 0) {
      first_empty[all[i].camera] = all[i].frame;
    }
  }
  for (std::size_t c = 0; c < num_empty.size(); ++c) {
    if (num_empty[c] == 0) continue;
    silhouettes.warnings.push_back(fmt::format(
        "{} masks of camera '{}' show no cloth, the first in frame {}: they are left out",
        num_empty[c], recording.cameras[c].name, first_empty[c]));
  }
  return silhouettes;
}

}  // namespace clothfit
