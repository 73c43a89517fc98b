// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/nudging.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

bool HasPoints(const Scene& scene) { return !scene.markers.empty() || !scene.tracks.empty(); }

std::optional<FitConfig> NudgedConfig(FitConfig config, const Scene& scene, double share,
                                      double damping) {
  const auto markers =
      std::count_if(scene.markers.begin(), scene.markers.end(), [&](const MarkerObservation& m) {
        return scene.is_fitted[static_cast<std::size_t>(m.frame)];
      });
  const auto tracks =
      std::count_if(scene.tracks.begin(), scene.tracks.end(),
                    [&](const TrackObservation& track) { return scene.IsFitted(track); });
  std::size_t points = 0;
  for (std::size_t i = 0; scene.clouds && i < scene.clouds->observations.size(); ++i) {
    const CloudObservation& cloud = scene.clouds->observations[i];
    if (scene.IsFitted(cloud)) points += cloud.points.size();
  }
  const double pulling = static_cast<double>(markers + tracks) + static_cast<double>(points);
  if (pulling == 0.0) return {};
  const auto last = scene.is_fitted.begin() + scene.last_fitted_frame + 1;
  const double per_frame =
      pulling / static_cast<double>(std::count(scene.is_fitted.begin(), last, true));
  const double mass =
      config.parameters.at("cloth.areal_density").value * scene.recording.cloth.size.prod();
  // Each point as a mass on a spring that moves.
  const double rate = std::sqrt(share) * kNudgingRate;
  const double linear = mass * rate * rate / per_frame,
               drag = damping * 2.0 * mass * rate / per_frame;
  config.attract = true;
  config.polish = false;
  for (const TermInfo& term : AllTerms()) {
    if (term.role != Role::kGuide) continue;
    for (const auto& [name, value] : {std::pair{".linear", linear}, std::pair{".damping", drag}}) {
      ParameterSetting& setting = config.parameters.at(term.name + name);
      setting.value = std::clamp(value, setting.lower, setting.upper);
      setting.free = false;
    }
  }
  return config;
}

}  // namespace clothfit
