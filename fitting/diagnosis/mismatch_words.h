// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What was found about a missing force, in plain sentences.
#pragma once

#include <string>

#include "fitting/diagnosis/acting_force.h"
#include "fitting/diagnosis/classes.h"
#include "fitting/diagnosis/force_layout.h"
#include "fitting/diagnosis/mismatch.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// "Between 1.2 s and 2.1 s the quarter at high u and low v is pushed along +y with up to 0.4 N/m^2
// more than the model has." `last_frame`: of those the force was estimated for.
std::string MismatchWords(const Scene& scene, const ForceLayout& layout, int last_frame,
                          const Mismatch& mismatch);

// A direction (unit, world) as "+y" where it is within 20 degrees of an axis, else by its numbers.
std::string DirectionWords(const Eigen::Vector3d& direction);

// A rectangle of the cloth (m): "the whole cloth", "the half at low u", "the quarter at high u and
// low v", "the middle", or by its numbers.
std::string RegionWords(const Eigen::Vector2d& cloth_low, const Eigen::Vector2d& cloth_high,
                        const Eigen::Vector2d& low, const Eigen::Vector2d& high);

// "It acts all the time on the whole cloth, with up to 0.4 N/m^2 along +y. It comes from outside
// the cloth and takes energy out of the motion."
ActingClass ClassOfActing(const Scene& scene, const ActingForce& force);

// "The missing force comes from outside the cloth, takes energy out of the motion and acts for a
// time only."
std::string ClassWords(const MismatchClass& mismatch_class);

}  // namespace clothfit
