// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether the cloth begins where its silhouettes have it: the part of WarnOfPlacement that looks at
// pictures.
#pragma once

#include <string>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

// The least share that start and silhouette have in common of what either covers, both grown by
// kPlacementTolerance of the silhouette's longer side: cloth seen edge-on is a line, which moves by
// its width as soon as it sags. Of cloth that lies where it should 0.9 and more is common; there is
// less than half where it is moved by more than a third of its side, or more than half is hidden.
inline constexpr double kLeastOverlap = 0.5;

struct StartOverlap {
  int camera = 0;      // index
  double share = 0.0;  // 0 to 1
};
// Of each camera that sees cloth within kFirstSeenWithin: in its first mask or, where it has none,
// in its picture of frame 0 by that of the empty scene. Reads no other picture. One that cannot be
// used is left out: whoever goes on with it says what is wrong.
std::vector<StartOverlap> OverlapsAtStart(const Recording& recording);

// Appends a line where more than kMisplacedShare of these cameras have less than kLeastOverlap.
void WarnOfSilhouettes(const Recording& recording, std::vector<std::string>* warnings);

}  // namespace clothfit
