// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The contract of a force term. Physics is written once, in one struct, templated on its scalar, in
// autodiff_sim/terms/, and named once, in terms/terms.list:
//
//   struct Example : TermDefaults {
//     static constexpr const char* kName = "example";            // its parameters are example.*
//     static constexpr const char* kDoc = "what it is, in one line";
//     static constexpr const char* kReference = "Author year, eq. n";
//     static constexpr int kNodes = 2;                            // particles an element acts on
//     static constexpr bool kInternal = true;                     // no net force, no net moment
//     static constexpr std::array<Parameter, 1> kParameters = {{...}};
//     // ... and what of TermDefaults is otherwise, such as kRole, kWork, kTies (term/kind.h)
//     struct Element { std::array<int, kNodes> nodes; ... };
//     static std::vector<Element> Elements(const TermContext&);
//     template <class T>
//     static void AddForce(const Element&, const ElementInput<Example, T>&, ElementOutput<Example,
//     T>*);
//   };
//
// AddForce gets an output whose forces are zero (N) and whose memory is last step's, adds the
// element's forces, and writes the memory at the end of the step. With its parameters at `off` it
// adds nothing; those that only shape the force (Parameter::probes) need not be. Branches are
// decided on plain values (Value()), and the force is continuous across them. Elements are fixed
// for a simulation, or, where kInputs > 0, made anew for each step from its StepInputs. Those of a
// term that follows contacts are made anew from TermContext::contacts or obstacles wherever the
// forces are evaluated. A term that needs an input names its first row in StepInputs::directions as
// Element::first_input.
//
// A term that remembers knows where its particles were when the step began, and so needs no
// memory of that; its memory is zero at first, and the cloth's first shape leaves it without force.
// A term that is a part of another's force (wind is of the air's drag) names the other's parameters
// in kReads.
//
// Forces, not energies: drag and friction have none. A term whose force has one, but for damping
// and friction, may give it too, so that a simulation's energy can be balanced
// (Simulation::Energies):
//     static double Energy(const Element&, const ElementInput<Example, double>&);  // J
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "autodiff_sim/base/scalar.h"
#include "autodiff_sim/mesh/cloth_mesh.h"
#include "autodiff_sim/term/kind.h"
#include "autodiff_sim/term/parameter.h"
#include "autodiff_sim/term/step_inputs.h"

namespace clothfit {

struct Obstacle;         // contact/obstacle_body.h
struct ContactPair;      // contact/contact_pair.h
struct ObstacleContact;  // contact/obstacle_contact.h

// The world around the cloth.
struct World {
  Eigen::Vector3d gravity = {0.0, 0.0, -9.81};  // m/s^2
  std::optional<double> ground_height;          // m; the ground is the plane z = height
  std::vector<std::shared_ptr<const Obstacle>> obstacles;
};

// What most terms are.
struct TermDefaults {
  static constexpr const char* kTitle = "";  // its name in sentences, where that is not kName
  static constexpr Role kRole = Role::kMayBeMissing;
  static constexpr Work kWork = Work::kConserves;
  static constexpr std::array kTies = {Tie::kMaterial};  // all that are right, the foremost first
  static constexpr Needs kNeeds = Needs::kNothing;
  static constexpr int kInputs = 0;                 // numbers from StepInputs an element
  static constexpr int kMemory = 0;                 // numbers an element remembers
  static constexpr bool kUsesAcceleration = false;  // reads a
  static constexpr bool kUsesDensity = false;       // reads areal_density
  static constexpr bool kUsesShrinkage = false;     // reads shrinkage
  static constexpr bool kPrefersAxes = false;       // parameters that are bound to the world's axes
  static constexpr bool kFollowsContacts = false;   // its elements are what is in contact
  static constexpr std::array<const char*, 0> kReads = {};  // full names of others' parameters
};

// What an element list is made from. `inputs` is null for elements that are fixed for a simulation,
// `contacts` where none are known.
struct TermContext {
  const ClothMesh& mesh;
  const ClothTopology& topology;
  const World& world;
  const StepInputs* inputs;
  const std::vector<ContactPair>* contacts = nullptr;  // features of the cloth that are in contact
  const std::vector<ObstacleContact>* obstacles = nullptr;  // the same with obstacles
};

template <class Term, class T>
struct ElementInput {
  double time;                             // s, at the end of the step
  double step;                             // s, its length
  std::array<Vector3<T>, Term::kNodes> x;  // m
  std::array<Vector3<T>, Term::kNodes> v;  // m/s
  // m/s^2, of the integrator's own formula; there only if kUsesAcceleration.
  std::array<Vector3<T>, Term::kUsesAcceleration ? Term::kNodes : 0> a;
  // m, at the start of the step; there only if kMemory > 0.
  std::array<Vector3<T>, (Term::kMemory > 0) ? Term::kNodes : 0> start;
  std::array<T, Term::kParameters.size()> parameter;
  // As in kReads; zero where the simulation lacks the other term.
  std::array<T, Term::kReads.size()> read;
  T areal_density;                     // kg/m^2
  std::array<T, 2> shrinkage;          // of the rest lengths along warp and weft, a share
  std::array<T, Term::kInputs> input;  // as the term's Element defines them
};

template <class Term, class T>
struct ElementOutput {
  std::array<Vector3<T>, Term::kNodes> force;  // N
  std::array<T, Term::kMemory> memory;         // in: last step's; out: this step's
};

// A compile-time list of terms.
template <class... Terms>
struct TypeList {
  static constexpr int kSize = sizeof...(Terms);
};

}  // namespace clothfit
