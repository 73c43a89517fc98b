// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A force term of one's own: physics that a program adds to clothfit's when it runs. Simulations,
// fits and diagnoses have it from then on, under the name term.parameter, with exact derivatives.
//
//   struct Example {
//     static constexpr const char* kName = "example";
//     static constexpr const char* kDoc = "what it is, in one line";
//     static constexpr int kParticles = 1;  // that one element joins
//     static constexpr std::array<clothfit::TermParameter, 1> kParameters = {{...}};
//     struct Element { std::array<int, kParticles> particles; ... };
//     static std::vector<Element> Elements(const clothfit::Cloth&);
//     template <class T>  // double, or clothfit::Dual
//     static void AddForce(const Element&, const clothfit::ElementState<Example, T>&,
//                          clothfit::ElementForce<Example, T>*);
//   };
//   clothfit::AddTerm<Example>();
//
// AddForce gets forces of zero (N) and adds the element's. With its parameters at `off` it adds
// nothing. Branches are decided by comparing numbers, and the force is continuous across them. It
// is called by several threads at once. A term whose initial values are off may be missing: a
// diagnosis looks for it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "clothfit/base.h"
#include "clothfit/dual.h"

namespace clothfit::v0 {

enum class Scale { kLinear, kLog };  // moved by adding, or by multiplying

struct TermParameter {
  const char* name;
  const char* unit;
  const char* doc;
  double initial;  // what a simulation uses unless told otherwise
  double off;      // at which the term does nothing
  double lower, upper;
  Scale scale;
  double prior;  // one sigma of the prior: an amount, of a logarithmic scale a factor
};

// The cloth at rest and its world, of which a term makes its elements.
struct Cloth {
  std::vector<Vector2> uv;                    // m, one a particle
  std::vector<double> areas;                  // m^2, one a particle; all together the cloth's
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise in (u, v)
  Vector3 gravity = {};                       // m/s^2
  std::optional<double> ground_height;        // m
};

template <class Term, class T>
struct ElementState {
  double time = 0.0, step = 0.0;                        // s, at the step's end; its length
  std::array<std::array<T, 3>, Term::kParticles> x, v;  // m, m/s, world
  std::array<T, Term::kParameters.size()> parameter;
};

template <class Term, class T>
using ElementForce = std::array<std::array<T, 3>, Term::kParticles>;  // N

namespace detail {

// What the library sees of a term: nothing that depends on how the program is compiled.
struct PlainTerm {
  const char* name;
  const char* doc;
  int particles;
  std::vector<TermParameter> parameters;
  // The elements, and the particles of each, one after the other.
  std::function<std::shared_ptr<const void>(const Cloth& cloth, std::vector<int>* particles)> make;
  // force: 3n. jacobian: null, or 3n rows of the derivatives by x, v and parameters.
  void (*evaluate)(const void* elements, std::size_t element, double time, double step,
                   const double* x, const double* v, const double* parameter, double* force,
                   double* jacobian);
};
CLOTHFIT_API void AddPlainTerm(const PlainTerm& term);

template <class Term, class T>
ElementForce<Term, T> Force(const void* elements, std::size_t element, double time, double step,
                            const double* x, const double* v, const double* parameter) {
  ElementState<Term, T> state;
  state.time = time;
  state.step = step;
  const auto set = [](T* number, double value, int direction) {
    *number = T(value);
    if constexpr (!std::is_same_v<T, double>) number->derivative[direction] = 1.0;
  };
  constexpr int n = 3 * Term::kParticles;
  for (int i = 0; i < n; ++i) {
    set(&state.x[i / 3][i % 3], x[i], i);
    set(&state.v[i / 3][i % 3], v[i], n + i);
  }
  for (std::size_t k = 0; k < Term::kParameters.size(); ++k)
    set(&state.parameter[k], parameter[k], 2 * n + static_cast<int>(k));
  ElementForce<Term, T> force = {};
  const auto& all = *static_cast<const std::vector<typename Term::Element>*>(elements);
  Term::template AddForce<T>(all[element], state, &force);
  return force;
}

template <class Term>
void Evaluate(const void* elements, std::size_t element, double time, double step, const double* x,
              const double* v, const double* parameter, double* force, double* jacobian) {
  constexpr int n = 3 * Term::kParticles;
  if (jacobian == nullptr) {
    const auto f = Force<Term, double>(elements, element, time, step, x, v, parameter);
    for (int i = 0; i < n; ++i) force[i] = f[i / 3][i % 3];
    return;
  }
  constexpr int columns = 2 * n + static_cast<int>(Term::kParameters.size());
  const auto f = Force<Term, Dual<columns>>(elements, element, time, step, x, v, parameter);
  for (int i = 0; i < n; ++i) {
    force[i] = f[i / 3][i % 3].value;
    for (int j = 0; j < columns; ++j) jacobian[i * columns + j] = f[i / 3][i % 3].derivative[j];
  }
}

}  // namespace detail

// Adds a term, before anything else of clothfit is asked for. Throws InputError where it
// contradicts itself or comes too late.
template <class Term>
void AddTerm() {
  const auto make = [](const Cloth& cloth, std::vector<int>* particles) {
    auto elements = std::make_shared<std::vector<typename Term::Element>>(Term::Elements(cloth));
    for (const auto& e : *elements)
      particles->insert(particles->end(), e.particles.begin(), e.particles.end());
    return std::shared_ptr<const void>(elements);
  };
  detail::AddPlainTerm({Term::kName,
                        Term::kDoc,
                        Term::kParticles,
                        {Term::kParameters.begin(), Term::kParameters.end()},
                        make,
                        detail::Evaluate<Term>});
}

}  // namespace clothfit::v0
