// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where, when and which way a force is missing, in plain sentences.
#pragma once

#include <string>

#include "fitting/diagnosis/locate/discrepancy.h"
#include "fitting/diagnosis/locate/force_layout.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// "By the map of the missing force, between 1.2 s and 2.1 s the quarter at high u and low v is
// pushed along +y with up to 0.4 N/m^2 more than the baseline has." No direction where it has none.
// `last_frame`: of those the force was estimated for.
std::string DiscrepancyText(const Scene& scene, const ForceLayout& layout, int last_frame,
                            const Discrepancy& discrepancy);

// A direction (unit, world) as "+y" where it is within 20 degrees of an axis, else by its numbers.
std::string DirectionText(const Eigen::Vector3d& direction);

// A rectangle of the cloth (m): "the whole cloth", "the half at low u", "the quarter at high u and
// low v", "the middle", or by its numbers.
std::string RegionText(const Eigen::Vector2d& cloth_low, const Eigen::Vector2d& cloth_high,
                       const Eigen::Vector2d& low, const Eigen::Vector2d& high);

}  // namespace clothfit
