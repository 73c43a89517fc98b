// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The measured silhouettes of a recording, as the silhouette errors need them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/recording/pictures/signed_distance.h"
#include "tracking/recording/recording.h"
#include "tracking/silhouette/bit_mask.h"

namespace clothfit {

struct SilhouetteObservation {
  int frame = 0, camera = 0;
  BitMask mask;
  // For the soft error, where it is fitted.
  std::optional<SignedDistanceField> field;
  std::vector<Eigen::Vector2d> outline;  // px
};

// With field and outline. `mask`: 8-bit, 0 = background, some of it cloth.
SilhouetteObservation MakeSilhouette(int frame, int camera, const cv::Mat& mask);

struct Silhouettes {
  std::vector<SilhouetteObservation> observations;  // by frame, then camera
  std::vector<std::string> warnings;                // on masks that cannot be used, one line each
};

// Points of a measured outline are this far apart (px): about as far as the errors of a mask hang
// together.
inline constexpr double kOutlineSpacing = 6.0;

// Reads all masks of the recording. `is_fitted(frame, camera)` says which ones get a field. A mask
// without any cloth is left out, with a warning. Throws InputError as LoadMask.
Silhouettes LoadSilhouettes(const Recording& recording,
                            const std::function<bool(int frame, int camera)>& is_fitted);

}  // namespace clothfit
