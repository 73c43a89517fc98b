// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// All elements of one term, behind an interface without templates: the solver sees batches, and
// each term's derivatives are compiled once, in a translation unit of their own.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/term/element_jacobian.h"
#include "autodiff_sim/term/term.h"

namespace clothfit {

// What a term says of itself.
struct TermInfo {
  std::string name, title, doc, reference;
  int nodes = 0;
  int memory = 0;  // numbers that an element remembers
  bool internal = false;
  Role role = Role::kOrdinary;
  Work work = Work::kMixed;
  std::vector<Tie> ties;
  Needs needs = Needs::kNothing;
  std::vector<Parameter> parameters;
  std::vector<std::string> reads;  // full names of other terms' parameters
};

// Where a batch is evaluated: all pointers are to whole arrays of the simulation.
struct BatchPoint {
  double time;                   // s
  double step;                   // s
  const double* x;               // 3N, m
  const double* v;               // 3N, m/s
  const double* a;               // 3N, m/s^2
  const double* start;           // 3N, m, the positions when the step began
  const double* all_parameters;  // see parameter_table.h; the cloth's own come first
  const double* parameter;       // the term's own
  const int* read;               // where those of TermInfo::reads are among all; -1 for none
  const double* memory;          // the term's own, at the start of the step
};

// Directions in which a batch's forces are differentiated, kLanes at once: rows of kLanes numbers,
// a row for each number of the point. All pointers as in BatchPoint; null where nothing moves.
struct BatchDirections {
  const double* x;      // 3N rows
  const double* v;      // 3N rows
  const double* a;      // 3N rows
  const double* start;  // 3N rows
  const double* all_parameters;
  const double* parameter;  // the term's own
  const double* memory;     // the term's own
  const double* input;      // rows of StepInputs::directions
};

class ForceBatch {
 public:
  virtual ~ForceBatch() = default;
  virtual const TermInfo& info() const = 0;

  // Makes the elements of a step anew (terms with inputs only).
  virtual void BeginStep(const TermContext& context) = 0;
  // Whether the elements are the contacts, and if so makes them anew. They are not bound then.
  virtual bool FollowContacts(const TermContext& context) = 0;
  // The particles that each element couples.
  virtual std::vector<std::vector<int>> Cliques() const = 0;
  // Finds where the elements' blocks lie in the pattern, which must outlive this object.
  virtual void Bind(const BlockPattern* pattern) = 0;
  // Numbers that all elements together remember.
  virtual int memory_size() const = 0;

  // force += the forces, N, 3N; the new memory is written to `memory`.
  virtual void AddForces(const BatchPoint& point, double* force, double* memory) const = 0;
  // J, of all elements; none where the term has none.
  virtual std::optional<double> Energy(const BatchPoint& point) const = 0;
  // matrix += the forces' derivatives by positions, velocities and accelerations, each with its
  // weight.
  virtual void AddJacobian(const BatchPoint& point, const JacobianWeights& weights,
                           BlockSparseMatrix* matrix) const = 0;
  // force += the forces' derivatives along the directions, 3N rows; those of the new memory, of a
  // term that remembers, are written to `memory`.
  virtual void AddDerivatives(const BatchPoint& point, const BatchDirections& directions,
                              double* force, double* memory) const = 0;
};

// One batch a term of the list, in the list's order.
template <class Term>
std::unique_ptr<ForceBatch> MakeForceBatch(const TermContext& context);

template <class... Terms>
std::vector<std::unique_ptr<ForceBatch>> MakeForceBatches(TypeList<Terms...>,
                                                          const TermContext& context) {
  std::vector<std::unique_ptr<ForceBatch>> batches;
  (batches.push_back(MakeForceBatch<Terms>(context)), ...);
  return batches;
}

template <class Term>
TermInfo MakeTermInfo() {
  return {Term::kName,
          Term::kTitle,
          Term::kDoc,
          Term::kReference,
          Term::kNodes,
          Term::kMemory,
          Term::kInternal,
          Term::kRole,
          Term::kWork,
          {Term::kTies.begin(), Term::kTies.end()},
          Term::kNeeds,
          {Term::kParameters.begin(), Term::kParameters.end()},
          {Term::kReads.begin(), Term::kReads.end()}};
}

template <class... Terms>
std::vector<TermInfo> MakeTermInfos(TypeList<Terms...>) {
  return {MakeTermInfo<Terms>()...};
}

}  // namespace clothfit
