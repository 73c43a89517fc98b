// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one list of force terms. A term is added by writing its file and naming it here.
#pragma once

#include "autodiff_sim/term/term.h"
#include "autodiff_sim/terms/added_mass.h"
#include "autodiff_sim/terms/adhesion.h"
#include "autodiff_sim/terms/air_drag.h"
#include "autodiff_sim/terms/attraction.h"
#include "autodiff_sim/terms/attractor.h"
#include "autodiff_sim/terms/bending.h"
#include "autodiff_sim/terms/bending_friction.h"
#include "autodiff_sim/terms/crease.h"
#include "autodiff_sim/terms/extra_mass.h"
#include "autodiff_sim/terms/gravity.h"
#include "autodiff_sim/terms/gravity_tilt.h"
#include "autodiff_sim/terms/grip.h"
#include "autodiff_sim/terms/ground_contact.h"
#include "autodiff_sim/terms/gust.h"
#include "autodiff_sim/terms/law.h"
#include "autodiff_sim/terms/obstacle.h"
#include "autodiff_sim/terms/obstacle_contact.h"
#include "autodiff_sim/terms/orthotropy.h"
#include "autodiff_sim/terms/relaxation.h"
#include "autodiff_sim/terms/residual_force.h"
#include "autodiff_sim/terms/self_contact.h"
#include "autodiff_sim/terms/shear_friction.h"
#include "autodiff_sim/terms/spring.h"
#include "autodiff_sim/terms/stiff_patch.h"
#include "autodiff_sim/terms/stiff_seam.h"
#include "autodiff_sim/terms/strain_limit.h"
#include "autodiff_sim/terms/stretch_stiffening.h"
#include "autodiff_sim/terms/wind.h"

namespace clothfit {

using Terms =
    TypeList<Gravity, StretchSpring, ShearSpring, Bending, AirDrag, AddedMass, GroundContact,
             PointAttraction, RayAttraction, SelfContact, ObstacleBarrier, UniformWind, Gust,
             BendingFriction, ShearFriction, StretchRelaxation, ShearRelaxation, BendingRelaxation,
             Crease, StretchStiffening, StrainLimit, StretchOrthotropy, ShearOrthotropy,
             BendingOrthotropy, Hem, HeavyPatch, StiffPatchStretch, StiffPatchBending,
             StiffSeamStretch, StiffSeamBending, Adhesion, StickyPatch, ObstaclePlane,
             ObstacleSphere, ObstacleCapsule, GravityTilt, Attractor, Grip, GripSlip, LawField,
             LawAir, LawTension, ResidualForce>;

}  // namespace clothfit
