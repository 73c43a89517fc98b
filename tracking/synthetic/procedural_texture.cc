// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/procedural_texture.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3f;

constexpr double kTexel = 0.002;  // m, some fraction of what a pixel sees

const std::vector<std::pair<std::string, ClothPattern>>& NamedPatterns() {
  static const std::vector<std::pair<std::string, ClothPattern>> names = {
      {"rich", ClothPattern::kRich},
      {"repetitive", ClothPattern::kRepetitive},
      {"plain", ClothPattern::kPlain}};
  return names;
}

// Numbers between 0 and 1 that are the same with every standard library.
class UniformNumbers {
 public:
  explicit UniformNumbers(std::uint64_t seed) : engine_(seed) {}
  double Next() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double Between(double low, double high) { return low + (high - low) * Next(); }

 private:
  std::mt19937_64 engine_;
};

// A lattice point's number in [0, 1): the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
double LatticeNumber(int i, int j, std::uint64_t seed) {
  std::uint64_t z = static_cast<std::uint32_t>(i) * 0x9E3779B97F4A7C15ULL +
                    static_cast<std::uint32_t>(j) * 0xD1B54A32D192ED03ULL + seed;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

// Smooth noise of mean 1/2 with one lattice point per unit, that repeats after `period` units.
double ValueNoise(const Vector2d& place, int period, std::uint64_t seed) {
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const int i = static_cast<int>(std::floor(place.x())),
            j = static_cast<int>(std::floor(place.y()));
  const double s = smooth(place.x() - i), t = smooth(place.y() - j);
  const auto at = [&](int di, int dj) {
    const auto wrapped = [period](int k) { return ((k % period) + period) % period; };
    return LatticeNumber(wrapped(i + di), wrapped(j + dj), seed);
  };
  return (1.0 - t) * ((1.0 - s) * at(0, 0) + s * at(1, 0)) +
         t * ((1.0 - s) * at(0, 1) + s * at(1, 1));
}

// A painted shape: an ellipse or a rectangle.
struct Leaf {
  Vector2d centre, half;  // m
  double cosine, sine;    // of its turn
  bool is_round;
  Vector3f colour;

  bool Covers(const Vector2d& place) const {
    const Vector2d d = place - centre;
    const double x = (cosine * d.x() + sine * d.y()) / half.x();
    const double y = (cosine * d.y() - sine * d.x()) / half.y();
    return is_round ? x * x + y * y < 1.0 : std::max(std::abs(x), std::abs(y)) < 1.0;
  }
};

// Dark, bright or coloured, so that neighbours differ in brightness most of the time.
Vector3f RandomColour(UniformNumbers* numbers) {
  const double brightness =
      numbers->Next() < 0.5 ? numbers->Between(0.02, 0.15) : numbers->Between(0.4, 0.9);
  Vector3f colour;
  for (float& channel : colour)
    channel = static_cast<float>(std::clamp(brightness * numbers->Between(0.5, 1.4), 0.01, 0.95));
  return colour;
}

// Leaves of one octave of sizes (diameter, m) that cover about `coverage` of the cloth.
void AddLeaves(const Vector2d& size, double diameter, double coverage, UniformNumbers* numbers,
               std::vector<Leaf>* leaves) {
  const double mean_area = 0.7 * diameter * diameter;
  const int count = static_cast<int>(std::ceil(coverage * size.prod() / mean_area));
  for (int i = 0; i < count; ++i) {
    Leaf leaf;
    leaf.centre = {numbers->Between(0.0, size.x()), numbers->Between(0.0, size.y())};
    const double half = 0.5 * diameter * numbers->Between(0.7, 1.4);
    leaf.half = {half, half * numbers->Between(0.4, 1.0)};
    const double angle = numbers->Between(0.0, 3.141592653589793);
    leaf.cosine = std::cos(angle);
    leaf.sine = std::sin(angle);
    leaf.is_round = numbers->Next() < 0.5;
    leaf.colour = RandomColour(numbers);
    leaves->push_back(leaf);
  }
}

// Leaves lie on one another, the smaller ones on top; a dead leaves model (Lee, Mumford and Huang
// 2001, "Occlusion models for natural images").
PlaneTexture RichTexture(const Vector2d& size, std::uint64_t seed) {
  UniformNumbers numbers(seed);
  std::vector<Leaf> leaves;
  constexpr std::pair<double, double> kOctaves[] = {// m across, share of the cloth
                                                    {0.20, 2.0},
                                                    {0.10, 0.5},
                                                    {0.05, 0.35},
                                                    {0.025, 0.22},
                                                    {0.0125, 0.1}};
  for (const auto& [diameter, coverage] : kOctaves)
    AddLeaves(size, diameter, coverage, &numbers, &leaves);
  // Painting by rule: each cell of a coarse grid knows the leaves that may cover it.
  constexpr double kCell = 0.05;  // m
  const Vector2i cells = (size / kCell).array().ceil().cast<int>().max(1);
  std::vector<std::vector<const Leaf*>> by_cell(static_cast<std::size_t>(cells.prod()));
  for (const Leaf& leaf : leaves) {
    const Eigen::Array2d reach = Eigen::Array2d::Constant(leaf.half.norm());
    const Eigen::Array2i last = cells.array() - 1;
    const Eigen::Array2i from = ((leaf.centre.array() - reach) / kCell).floor().cast<int>();
    const Eigen::Array2i to = ((leaf.centre.array() + reach) / kCell).floor().cast<int>();
    for (int j = std::max(from.y(), 0); j <= std::min(to.y(), last.y()); ++j) {
      for (int i = std::max(from.x(), 0); i <= std::min(to.x(), last.x()); ++i)
        by_cell[static_cast<std::size_t>(j * cells.x() + i)].push_back(&leaf);
    }
  }
  const auto colour = [&](const Vector2d& place) {
    const Eigen::Array2i cell = (place / kCell).array().floor().cast<int>().min(cells.array() - 1);
    const auto& here = by_cell[static_cast<std::size_t>(cell.y() * cells.x() + cell.x())];
    for (auto leaf = here.rbegin(); leaf != here.rend(); ++leaf) {
      if ((*leaf)->Covers(place)) return (*leaf)->colour;
    }
    return Vector3f(0.35F, 0.4F, 0.45F);
  };
  return {size, kTexel, PlaneTexture::Beyond::kBorder, colour};
}

// A ring, a dot and stripes on one square of the print.
Vector3f PrintColour(const Vector2d& place) {
  const Vector2d p = place / kPatternPeriod - Vector2d(0.5, 0.5);  // -0.5 to 0.5
  const double radius = p.norm();
  if (radius < 0.1) return {0.15F, 0.2F, 0.75F};
  if (radius > 0.2 && radius < 0.32) return {0.75F, 0.8F, 0.82F};
  if (std::abs(p.x()) > 0.44 || std::abs(p.y()) > 0.44) return {0.1F, 0.6F, 0.75F};
  if (radius > 0.36 && p.x() * p.y() > 0.0) return {0.55F, 0.2F, 0.12F};
  return {0.3F, 0.1F, 0.08F};
}

PlaneTexture RepetitiveTexture() {
  return {Vector2d::Constant(kPatternPeriod), 0.5 * kTexel, PlaneTexture::Beyond::kRepeat,
          PrintColour};
}

Vector3f FloorColour(const Vector2d& place) {
  constexpr double kTile = 0.5, kJoint = 0.008;  // m
  constexpr int kTiles = 8;                      // before they repeat
  const Vector2d in_tiles = place / kTile;
  const Vector2d in_tile = (in_tiles.array() - in_tiles.array().floor()) * kTile;
  if (in_tile.minCoeff() < kJoint) return {0.2F, 0.22F, 0.24F};
  const int i = static_cast<int>(std::floor(in_tiles.x())),
            j = static_cast<int>(std::floor(in_tiles.y()));
  double shade = 0.42 + 0.08 * (LatticeNumber(i, j, 1) - 0.5);
  for (const int octave : {4, 16, 50}) {  // lattice points a tile
    shade +=
        0.05 *
        (ValueNoise(octave * in_tiles, octave * kTiles, static_cast<std::uint64_t>(octave)) - 0.5);
  }
  return static_cast<float>(shade) * Vector3f(0.85F, 0.96F, 1.05F);
}

}  // namespace

std::vector<std::string> ClothPatternNames() {
  std::vector<std::string> names;
  for (const auto& [name, pattern] : NamedPatterns()) names.push_back(name);
  return names;
}

std::string ToString(ClothPattern pattern) {
  for (const auto& [name, value] : NamedPatterns()) {
    if (value == pattern) return name;
  }
  return "unknown";
}

ClothPattern ParseClothPattern(const std::string& place, const std::string& name) {
  for (const auto& [known, pattern] : NamedPatterns()) {
    if (known == name) return pattern;
  }
  throw InputError(place, "'" + name + "': " + Suggestion(name, ClothPatternNames()));
}

PlaneTexture MakeClothTexture(ClothPattern pattern, const Vector2d& size, std::uint64_t seed) {
  switch (pattern) {
    case ClothPattern::kRich:
      return RichTexture(size, seed);
    case ClothPattern::kRepetitive:
      return RepetitiveTexture();
    case ClothPattern::kPlain:
      break;
  }
  return {size, size.maxCoeff(), PlaneTexture::Beyond::kBorder,
          [](const Vector2d&) { return Vector3f(0.35F, 0.45F, 0.75F); }};
}

PlaneTexture MakeFloorTexture() {
  return {Vector2d(4.0, 4.0), 0.004, PlaneTexture::Beyond::kRepeat, FloorColour};
}

}  // namespace clothfit
