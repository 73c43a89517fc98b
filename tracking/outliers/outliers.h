// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Gross errors of markers and tracks, found before any fit: by what cloth cannot do, and by what no
// motion explains.
#pragma once

#include <string>

#include "tracking/recording/recording.h"

namespace clothfit {

// Puts labels right first (swapped_markers.h), then moves gross errors from a recording's markers
// and tracks to what it left out; markers first, of each kind the worst first.
//  - A marker that is farther from half of its nearest neighbours than cloth lets it be (a tenth
//    more than on the cloth, and 6 sigmas). Neighbours that half of their own neighbours contradict
//    do not count, so that cloth that is stretched as a whole is no error.
//  - A point that is off what its neighbours in time and on the cloth lead one to expect by
//    10 times what is usual around it, and by 5 sigmas (class Unexplained).
// What is found of one id more than three times and in more than a tenth of its frames is no gross
// error but a wrong label or (u, v): it stays. An error beside the end of an id's frames may take
// the end with it, since nothing tells them apart in time.
void LeaveOutOutliers(Recording* recording);

// "3 of 18876 markers (worst: marker 149 at frame 46, 0.180 m off)" of what was left out of a
// recording, and the like of tracked points; empty where nothing was.
std::string DescribeOutliers(const Recording& recording);

}  // namespace clothfit
