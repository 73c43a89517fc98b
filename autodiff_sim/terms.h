// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one list of force terms. A term is added by writing its file and naming it here.
#pragma once

#include "autodiff_sim/term.h"
#include "autodiff_sim/terms/added_mass.h"
#include "autodiff_sim/terms/air_drag.h"
#include "autodiff_sim/terms/attraction.h"
#include "autodiff_sim/terms/bending.h"
#include "autodiff_sim/terms/gravity.h"
#include "autodiff_sim/terms/ground_contact.h"
#include "autodiff_sim/terms/self_contact.h"
#include "autodiff_sim/terms/spring.h"

namespace clothfit {

using Terms = TypeList<Gravity, StretchSpring, ShearSpring, Bending, AirDrag, AddedMass,
                       GroundContact, PointAttraction, RayAttraction, SelfContact>;

}  // namespace clothfit
