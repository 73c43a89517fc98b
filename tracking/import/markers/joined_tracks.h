// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Markers that were lost and came back under another name.
#pragma once

#include <string>
#include <vector>

#include "tracking/import/markers/marker_take.h"

namespace clothfit {

// Joins markers of which one ends before the other begins, where the two can be the same: what is
// between them is no faster than a hand, and their largest distances to the other markers agree,
// since a marker keeps its place on the cloth. The nearest pair of all is joined first, under the
// earlier name, or the later one where that is among the `kept`; two of these are not joined.
// Markers that are never seen are taken out. `notes` gets a sentence on each pair.
void JoinTracks(const std::vector<std::string>& kept, MarkerTake* take,
                std::vector<std::string>* notes);

}  // namespace clothfit
