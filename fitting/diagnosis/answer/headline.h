// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer of a diagnosis in one sentence, which terminal, diagnosis.md, diagnosis.json and page
// begin with.
#pragma once

#include <string>
#include <vector>

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

// "Wind of 0.56 m/s along +y."; of a model confidence set all of its members: "Wind of 0.56 m/s
// along +y, or gravity tilt of 4 degrees: this recording cannot tell."
std::string HeadlineOf(const Diagnosis& diagnosis);

// Of an undecided diagnosis: whether mesh and step may leave what the baseline does; else its fit
// has come to no minimum.
bool MayBeMesh(const Diagnosis& diagnosis);

// An effect of the answer or of its confidence set in a few words, by the model that has it.
std::string InBrief(const Diagnosis& diagnosis, const std::string& effect);

// The first model that was fitted with this effect as its newest one, the last of an effect that
// stands for a later one alone; null where there is none.
const Model* ModelWith(const Diagnosis& diagnosis, const std::string& effect);

}  // namespace clothfit
