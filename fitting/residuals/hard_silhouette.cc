// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/hard_silhouette.h"

#include <algorithm>

namespace clothfit {

HardSilhouette::HardSilhouette(const Scene& scene)
    : scene_(scene), rasters_(scene.recording.cameras.size()) {
  if (!scene.silhouettes) return;
  for (const SilhouetteObservation& s : scene.silhouettes->observations) {
    if (rasters_[s.camera]) continue;
    rasters_[s.camera] =
        std::make_unique<SilhouetteRaster>(scene.recording.cameras[s.camera], scene.mesh.triangles);
  }
}

std::vector<HardSilhouette::Difference> HardSilhouette::Differences(
    int frame, const Eigen::VectorXd& x) const {
  std::vector<Difference> differences;
  if (!scene_.silhouettes) return differences;
  const std::vector<SilhouetteObservation>& all = scene_.silhouettes->observations;
  auto s = std::lower_bound(all.begin(), all.end(), frame,
                            [](const SilhouetteObservation& a, int f) { return a.frame < f; });
  BitMask simulated;
  for (; s != all.end() && s->frame == frame; ++s) {
    rasters_[s->camera]->Draw(x, &simulated);
    differences.push_back({s->camera, CountDifferences(simulated, s->mask)});
  }
  return differences;
}

std::int64_t HardSilhouette::FittedDifference(int frame, const Eigen::VectorXd& x) const {
  if (!scene_.is_fitted[frame]) return 0;
  std::int64_t sum = 0;
  for (const Difference& difference : Differences(frame, x)) {
    if (scene_.IsFitted(frame, difference.camera)) sum += difference.pixels;
  }
  return sum;
}

}  // namespace clothfit
