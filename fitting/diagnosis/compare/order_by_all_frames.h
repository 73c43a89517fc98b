// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What fits to all frames say of the order that forecasts have found. Forecasts find what is
// missing however chaotic a motion is, but the states that they begin with are a little wrong.
#pragma once

#include <vector>

#include "fitting/diagnosis/compare/two_meshes.h"

namespace clothfit {

// Whether two models are of the same candidate.
bool IsSame(const JudgedModel& a, const JudgedModel& b);

// The model among these that is of the same candidate as `one`; null where there is none.
const JudgedModel* Named(const JudgedModel& one, const std::vector<JudgedModel>& models);

// Puts the models of forecasts in order, both lists with the best first. `decide`: the best of
// `whole`, fitted to all frames, follows the recording to its end, and more is missing than another
// mesh makes. Then all frames order those that were fitted to them, and the others stay as far
// behind the best of forecasts as they were; else a model is as far behind as the kinder of the two
// says. Leaves all as it is where the best of forecasts is not among `whole`.
void OrderByAllFrames(const std::vector<JudgedModel>& whole, bool decide,
                      std::vector<JudgedModel>* forecasts);

}  // namespace clothfit
