// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a missing force.
#pragma once

#include <opencv2/core/mat.hpp>

#include "fitting/diagnosis/locate/locate.h"

namespace clothfit {

// How strong it is over the cloth at a row of times spread over the recording, with the patch
// outlined where it acts, and below over all times: the mean over the cloth, and the strongest
// place. 8-bit BGR.
cv::Mat DrawForceMap(const Scene& scene, const MissingForce& missing, const Location& location);

// The cloth at the time of the force's peak as it hangs in space, seen from two sides, with the
// force of each patch of cloth as an arrow. 8-bit BGR.
cv::Mat DrawForceArrows(const Scene& scene, const MissingForce& missing, const Location& location);

}  // namespace clothfit
