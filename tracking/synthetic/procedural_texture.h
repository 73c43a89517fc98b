// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures made by rule, for synthetic pictures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/synthetic/plane_texture.h"

namespace clothfit {

enum class ClothPattern {
  kRich,        // random shapes of every size from 1 cm to 20 cm
  kRepetitive,  // one print every 8 cm
  kPlain,       // one colour
};

// The names on the command line: rich, repetitive, plain.
std::vector<std::string> ClothPatternNames();
std::string ToString(ClothPattern pattern);
// Throws InputError, naming `place`, where there is no such pattern.
ClothPattern ParseClothPattern(const std::string& place, const std::string& name);

inline constexpr double kPatternPeriod = 0.08;  // m, of the repetitive pattern

// Over the cloth's (u, v), m. `seed` chooses among the rich ones.
PlaneTexture MakeClothTexture(ClothPattern pattern, const Eigen::Vector2d& size,
                              std::uint64_t seed);

// Stone tiles, over (x, y), m.
PlaneTexture MakeFloorTexture();

}  // namespace clothfit
