// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The verdict of a diagnosis.
#pragma once

#include "fitting/diagnosis/answer/diagnosis.h"

namespace clothfit {

// All that the verdict is read from once the last round is over.
struct Outcome {
  bool has_physics = false;   // was physics kept?
  bool is_explained = false;  // does the last fit leave no more than noise and D?
  double explained = 0.0;     // share of the residual beyond them without physics
  double unexplained = 0.0;   // residual of the last fit beyond noise, delta, sigmas
  double mesh = 0.0;          // the discretisation error D, sigmas; 0 where it is not known
  double most = 0.9;          // the share that named physics has to explain
};

// The share that named physics has to explain: 0.9, or half where the fit leaves more than
// kUnusableResidual sigmas beyond noise, or has lost the recorded motion, so that forecasts tell.
double MostOfIt(double unexplained, bool is_lost = false);

// Would a full step of the baseline's fit explain half of what it leaves beyond noise (sigmas)?
// Where nothing was kept, that is no evidence of anything.
bool IsOnItsWay(const Diagnosis& diagnosis, double unexplained);

// Does the 90 % interval of any amount of the answer's physics exclude the value at which it is
// off? True where it has no amount.
bool IsDetermined(const Diagnosis& diagnosis);

// Of a diagnosis that has run to its end.
Verdict VerdictOf(const Diagnosis& diagnosis, const Outcome& outcome);

}  // namespace clothfit
