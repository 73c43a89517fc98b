// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The obstacles that the rigid bodies of a take stand for.
#pragma once

#include <string>
#include <vector>

#include "tracking/import/markers/marker_take.h"

namespace clothfit {

// One obstacle a body, of the shape that is chosen, or else of the one that its markers suggest: a
// capsule along markers that are six times as long as they are wide, otherwise a box, which lies
// below markers that are as flat. `choices` are NAME=none, NAME=capsule[:radius=M,length=M] and
// NAME=box[:thickness=M,margin=M,below=M], lengths in metres; what is left out is measured. Bodies
// with fewer than three markers are no obstacles. Throws InputError on a choice that is malformed
// or names no body. `notes` gets a sentence on each body.
std::vector<ObstacleDescription> MakeObstacles(const MarkerTake& take,
                                               const std::vector<std::string>& choices,
                                               std::vector<std::string>* notes);

}  // namespace clothfit
