// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether the cloth begins where its points were first seen: the part of Warnings that compares the
// start with observations.
#pragma once

#include <string>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

// How far a point may be from where the start has it, in lengths of the cloth's longer side. Cloth
// that is said to be flat and sags or has folds is off by 1 or 2 %, one that is mirrored, turned,
// of another size or elsewhere by tens of per cent.
inline constexpr double kPlacementTolerance = 0.05;
// The share of points farther off from which on it is the start that is wrong: then their median is
// far, too. Fewer are gross errors, of which a recording may have some per cent.
inline constexpr double kMisplacedShare = 0.5;
inline constexpr double kFirstSeenWithin = 0.1;  // s; what is first seen later has moved

// Appends a line for markers and one for tracks that begin elsewhere than the start has them, each
// with what would mend it where one of the eight symmetries of the rectangle, or a shift, does;
// otherwise what WarnOfSilhouettes has to say, and one for each handle whose path does. Points that
// the start was made of cannot disagree, nor can tracks that were found from it.
void WarnOfPlacement(const Recording& recording, std::vector<std::string>* warnings);

}  // namespace clothfit
