// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A physical parameter: its name, unit, meaning, bounds and scale, written once, with its term.
#pragma once

#include <array>

namespace clothfit {

// How a fit moves a parameter: by adding, or by multiplying (for what is positive and spans
// decades).
enum class Scale { kLinear, kLog };

// What a parameter places, where it places anything. Directions and places take three parameters in
// a row, places on the cloth two.
enum class Meaning {
  kNumber,
  kVectorX,  // of a vector, world
  kVectorY,
  kVectorZ,
  kPlaceX,  // of a place, m, world
  kPlaceY,
  kPlaceZ,
  kClothU,  // of a place on the cloth, m
  kClothV,
  kClothDistance,  // between places on the cloth, m
  kTime,           // s, since the recording began
  kTilt,           // of the direction up, rad, about one of two horizontal axes
  kAlongTilt,      // of a plane, m, along the direction that the term's tilts turn up to
};

// What of a recording a parameter moves, which the recording may have placed roughly.
enum class Places { kNothing, kObstacles, kRoundObstacles };

// Values to try for a parameter that has no meaning while its term is off: a term whose parameters
// without probes are off adds nothing, whatever those with probes are. In the parameter's unit, but
// shares of what was recorded for a place or a time: of the box that the cloth passes through
// (kPlace), of its extent along u or v (kClothU, kClothV), of the longer one of these
// (kClothDistance), of the recording's duration (kTime), of the box along the tilted direction
// (kAlongTilt). Of the two tilts one is tried at a time, the other at 0.
struct Probes {
  static constexpr int kMost = 4;
  int count = 0;
  std::array<double, kMost> values = {};
};

struct Parameter {
  const char* name;  // within its term; the full name is term.name
  const char* unit;
  const char* doc;
  double initial;  // what a simulation uses unless told otherwise
  double off;      // at which the term adds no force
  double lower;    // bounds that a fit respects
  double upper;
  Scale scale;
  double prior_factor;  // one sigma of the default prior: a factor for kLog, an amount for kLinear
  Meaning meaning = Meaning::kNumber;
  Probes probes = {};    // none where the parameter means something at `off`
  bool is_free = false;  // in a fit, unless it is told otherwise
  Places places = Places::kNothing;
};

// The parameter as one of which a recording tells in almost any case.
constexpr Parameter Free(Parameter parameter) {
  parameter.is_free = true;
  return parameter;
}

// The parameter as one that only shapes its term's force, with what to try while the term is off.
template <class... Values>
constexpr Parameter Shape(Parameter parameter, Meaning meaning, Values... probes) {
  static_assert(sizeof...(probes) > 0 && sizeof...(probes) <= Probes::kMost, "1 to 4 probes");
  parameter.meaning = meaning;
  parameter.probes = {static_cast<int>(sizeof...(probes)), {probes...}};
  return parameter;
}

// One of x, y and z of a place in the world that shapes a term's force.
constexpr Parameter PlaceInWorld(const char* name, Meaning meaning, const char* doc) {
  return Shape({name, "m", doc, 0.0, 0.0, -100.0, 100.0, Scale::kLinear, 0.3}, meaning, 0.0, 0.5,
               1.0);
}

// Whether the parameter by itself keeps its term from acting while it is off.
constexpr bool SwitchesOff(const Parameter& parameter) { return parameter.probes.count == 0; }

// Indices of the cloth's own parameters, cloth.*, which belong to no one force and come first in
// every table.
constexpr int kArealDensity = 0;
constexpr int kShrinkWarp = 1;
constexpr int kShrinkWeft = 2;
constexpr int kNumClothParameters = 3;

}  // namespace clothfit
