// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// All elements of one term, behind an interface without templates: the solver sees batches, and
// each term's derivatives are compiled once, in a translation unit of their own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/block_sparse_matrix.h"
#include "autodiff_sim/term.h"

namespace clothfit {

// What a term says of itself.
struct TermInfo {
  std::string name, doc, reference;
  int nodes = 0;
  int memory = 0;  // numbers that an element remembers
  bool internal = false;
  std::vector<Parameter> parameters;
};

// Where a batch is evaluated: all pointers are to whole arrays of the simulation.
struct BatchPoint {
  double time;              // s
  const double* x;          // 3N, m
  const double* v;          // 3N, m/s
  double areal_density;     // kg/m^2
  const double* parameter;  // the term's own
  const double* memory;     // the term's own, at the start of the step
};

// df/dinput of one particle's force, from elements with inputs.
struct InputDerivative {
  int node;
  int input_row;  // row of StepInputs::directions
  Eigen::Vector3d derivative;
};

// The local Jacobian of one element that remembers: rows are its forces (3 a node) and its new
// memory, columns its velocities, positions (3 a node each), parameters, areal density and old
// memory.
struct MemoryElement {
  std::vector<int> nodes;
  int first_parameter;  // index of the term's parameters among all
  int first_memory;     // index into the state's memory
  Eigen::MatrixXd jacobian;
};

// First derivatives of all forces at one point.
struct Linearization {
  BlockSparseMatrix* step_jacobian;  // += -gamma (df/dv + gamma df/dx)
  BlockSparseMatrix* stiffness;      // += df/dx
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> by_parameter;  // 3N x all
  std::vector<InputDerivative> by_input;
  std::vector<MemoryElement> with_memory;
};

class ForceBatch {
 public:
  virtual ~ForceBatch() = default;
  virtual const TermInfo& info() const = 0;

  // Makes the elements of a step anew (terms with inputs only).
  virtual void BeginStep(const TermContext& context) = 0;
  // The particles that each element couples.
  virtual std::vector<std::vector<int>> Cliques() const = 0;
  // Finds where the elements' blocks lie in the pattern, which must outlive this object.
  virtual void Bind(const BlockPattern* pattern) = 0;
  // Numbers that all elements together remember.
  virtual int memory_size() const = 0;

  // force += the forces, N, 3N; the new memory is written to `memory`.
  virtual void AddForces(const BatchPoint& point, double* force, double* memory) const = 0;
  // a += -gamma d force / d velocity, where positions move by gamma times velocities.
  virtual void AddStepJacobian(const BatchPoint& point, double gamma,
                               BlockSparseMatrix* a) const = 0;
  // Adds all first derivatives. The term's parameters begin at column `first_parameter` of
  // by_parameter, column 0 is the areal density; its memory begins at `first_memory`.
  virtual void Linearize(const BatchPoint& point, double gamma, int first_parameter,
                         int first_memory, Linearization* out) const = 0;
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
          Term::kDoc,
          Term::kReference,
          Term::kNodes,
          Term::kMemory,
          Term::kInternal,
          {Term::kParameters.begin(), Term::kParameters.end()}};
}

template <class... Terms>
std::vector<TermInfo> MakeTermInfos(TypeList<Terms...>) {
  return {MakeTermInfo<Terms>()...};
}

}  // namespace clothfit
