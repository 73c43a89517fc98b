// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What kind of physics a term is. Everything above the simulation asks these instead of names.
#pragma once

namespace clothfit {

enum class Role {
  kOrdinary,      // of every cloth and its world, on unless switched off
  kMayBeMissing,  // off, and looked for: physics that a cloth may have and a model seldom has
  kContact,       // keeps apart what is known to be there
  kVariant,       // a second form of a term that is looked for
  kGuide,         // pulls towards what was observed, on the way to a fit
  kEstimate,      // carries a force that was estimated
  kLaw,           // features of which a diagnosis learns a law
};

// What a term does to the energy of cloth and world.
enum class Work {
  kConserves,   // its force has an energy, or is an inertia
  kDissipates,  // it can only take
  kDrives,      // it gives and takes what something unseen pays for
  kMixed,       // some of these, as springs with damping
};

// What a force stays with where the cloth moves otherwise.
enum class Tie { kMaterial, kWorld, kContact, kClock };

// Without which a term never acts.
enum class Needs { kNothing, kGround, kObstacles };

constexpr const char* ToString(Role role) {
  constexpr const char* kWords[] = {"ordinary", "may be missing", "contact", "variant",
                                    "guide",    "estimate",       "law"};
  return kWords[static_cast<int>(role)];
}

constexpr const char* ToString(Work work) {
  constexpr const char* kWords[] = {"conserves", "dissipates", "drives", "mixed"};
  return kWords[static_cast<int>(work)];
}

constexpr const char* ToString(Tie tie) {
  constexpr const char* kWords[] = {"material", "world", "contact", "clock"};
  return kWords[static_cast<int>(tie)];
}

constexpr const char* ToString(Needs needs) {
  constexpr const char* kWords[] = {"nothing", "ground", "obstacles"};
  return kWords[static_cast<int>(needs)];
}

}  // namespace clothfit
