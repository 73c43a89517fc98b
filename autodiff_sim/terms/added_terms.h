// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Force terms that a program brings along when it runs, beside those of terms.list: they are
// simulated, fitted, listed and looked for like any other. Their elements' derivatives come as
// dense matrices.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "autodiff_sim/term/force_batch.h"

namespace clothfit {

// Where one element is evaluated; n: its particles.
struct ElementPoint {
  double time, step;        // s
  const double* x;          // 3n, m
  const double* v;          // 3n, m/s
  const double* parameter;  // the term's own
};

struct AddedElements {
  std::vector<int> particles;  // n an element
  // Writes the forces (3n, N) of an element and, where jacobian is not null, their derivatives by
  // x, v and parameters, 3n rows of 6n + parameters numbers.
  std::function<void(std::size_t element, const ElementPoint& point, double* force,
                     double* jacobian)>
      evaluate;
};

struct AddedTerm {
  TermInfo info;  // whose texts have to live as long as the program
  std::function<AddedElements(const TermContext&)> elements;
};

// Adds a term to those of every simulation from here on. Throws InputError where it contradicts
// itself, another term has its name, or the table of parameters has been asked for already.
void AddTerm(AddedTerm term);

// The terms in the order in which they were added. Whoever asks ends the adding.
const std::vector<AddedTerm>& AddedTerms();

// One batch more for each of them.
std::vector<std::unique_ptr<ForceBatch>> WithAddedTerms(
    std::vector<std::unique_ptr<ForceBatch>> batches, const TermContext& context);

}  // namespace clothfit
