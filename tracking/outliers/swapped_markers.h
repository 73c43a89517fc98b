// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Markers whose labels changed places, found before any fit: each goes on where the other one was
// going.
#pragma once

#include <string>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

// In the order of their frames. Each marker is led on along its last two sightings; it is at
// another one's place where that one's continuation is nearer by half than its own, which is four
// times as far away as is usual at that frame. Markers that are so in turn are swapped. One of them
// may be hidden at first, if the others stay for another frame: a gross error comes back. Two of
// which one is hidden for longer are found by the cloth alone. Whatever is found the cloth has to
// confirm: labels as they are put markers where it cannot have them, labels that are put right do
// not.
std::vector<SwappedMarkers> FindSwappedMarkers(const Recording& recording);

// Puts the labels right.
void SwapBack(const SwappedMarkers& swap, Recording* recording);

// All of them that are found; put_right of the recording tells of them.
void PutLabelsRight(Recording* recording);

// "markers 3 and 9 swapped from frame 40 on"
std::string ToString(const SwappedMarkers& swap);
// The same of all that were put right; empty where none were.
std::string DescribeSwaps(const Recording& recording);

}  // namespace clothfit
