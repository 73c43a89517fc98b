// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/validate/model_validation.h"

#include <cmath>

namespace clothfit {
namespace {

constexpr double kBlockSeconds = 0.2;  // of the bootstrap

// Of what is predicted, root mean square.
double NoiseOf(const Scene& scene, bool is_in_pixels) {
  if (!HasPoints(scene)) return 0.0;
  return is_in_pixels ? scene.track_sigma * std::sqrt(2.0) : scene.marker_sigma * std::sqrt(3.0);
}

}  // namespace

std::optional<int> FaultySource(const RankedCandidate& candidate, const Ranking& ranking) {
  const std::vector<int>& faults = candidate.faults;
  if (faults.empty()) return {};
  const Fault& fault = ranking.faults[static_cast<std::size_t>(faults.front())];
  if (IsOfMarkers(fault.kind)) return kMarkerSource;
  if (!ShowsInTracks(fault)) return {};
  return fault.source;
}

HeldOutValidation ValidateOnHeldOut(const FittedScene& model, const FittedScene& before,
                                    std::optional<int> source, double by_mesh, std::uint64_t seed) {
  const Scene& scene = before.scene;
  const int block = static_cast<int>(std::lround(kBlockSeconds * scene.recording.frame_rate));
  if (source) {  // it is held to all the others
    const std::optional<HeldOutErrors> without = MeasureAgainstOthers(before, *source);
    const std::optional<HeldOutErrors> with = MeasureAgainstOthers(model, *source);
    if (without && with) {
      const bool is_in_pixels = *source != kMarkerSource;
      HeldOutValidation validation =
          Validate(*without, *with, block, {NoiseOf(scene, is_in_pixels), 0.0}, seed);
      validation.is_in_pixels = is_in_pixels;
      validation.is_against_others = true;
      return validation;
    }
  }
  const bool is_in_pixels = scene.markers.empty();
  const IrreducibleError irreducible{NoiseOf(scene, is_in_pixels), by_mesh};
  HeldOutValidation validation =
      Validate(MeasureHeldOut(before), MeasureHeldOut(model), block, irreducible, seed);
  validation.is_in_pixels = is_in_pixels;
  return validation;
}

}  // namespace clothfit
