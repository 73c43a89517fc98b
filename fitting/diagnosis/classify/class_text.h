// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Of what class a force is, in plain sentences.
#pragma once

#include <string>

#include "fitting/diagnosis/classify/acting_force.h"
#include "fitting/diagnosis/classify/classes.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// "In the fitted model it acts all the time on the whole cloth, with 0.4 N/m^2 where it is
// strongest, mostly along +y. It comes from outside the cloth and takes energy out of the motion."
ActingClass ClassOfActing(const Scene& scene, const ActingForce& force);

// "The missing force comes from outside the cloth, takes energy out of the motion and acts for a
// time only."
std::string ClassText(const DiscrepancyClass& discrepancy_class);

}  // namespace clothfit
