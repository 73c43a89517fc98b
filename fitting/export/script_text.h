// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of the scripts that clothfit writes for other programs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/export/run_cloth.h"

namespace clothfit {

// `text` with each "@KEY@" replaced. Values are not looked through again.
std::string FillIn(const std::string& text, const std::map<std::string, std::string>& values);

// A Python literal that is this text, in ASCII, whatever stands in it.
std::string AsPythonText(const std::string& text);

// "(1, 2, 3), (4, 5, 6)" of 3N numbers, to seven digits.
std::string AsTuples(const Eigen::VectorXd& numbers);
std::string AsTuples(const std::vector<Eigen::Vector3d>& points);

// "    12: [(1, 2, 3), ...],", a line a particle that is held: where it is in each frame, m.
std::string PathsInPython(const RunCloth& cloth);

// What every script says of a cloth, by the keys of FillIn: NAME, VERSION, RATE, FRAMES, GRAVITY,
// START, REST, PINS, LEFT_OUT, STRETCH, PLATE (bending), DRAG_NORMAL and FRICTION.
std::map<std::string, std::string> ValuesOfCloth(const RunCloth& cloth);

// To seven digits.
std::string Digits(double value);

// One comment a sentence, each line begun with `begin`; "nothing" where there is none.
std::string AsComments(const std::vector<std::string>& sentences, const std::string& begin);

}  // namespace clothfit
