// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The implementation of MakeForceBatch, for the translation units that instantiate a term (those
// that cmake/term_list.cmake writes, and tests that bring a term of their own).
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "autodiff_sim/base/dual.h"
#include "autodiff_sim/term/force_batch.h"

namespace clothfit {

template <class Term, class = void>
constexpr bool kTermHasEnergy = false;
template <class Term>
constexpr bool kTermHasEnergy<Term, std::void_t<decltype(&Term::Energy)>> = true;

template <class Term>
class TermBatch final : public ForceBatch {
 public:
  explicit TermBatch(const TermContext& context)
      : info_(MakeTermInfo<Term>()), elements_(Term::Elements(context)) {}

  const TermInfo& info() const override { return info_; }

  void BeginStep(const TermContext& context) override {
    if constexpr (Term::kInputs > 0) {
      elements_ = Term::Elements(context);
      Bind(pattern_);
    }
  }

  bool FollowContacts(const TermContext& context) override {
    if constexpr (Term::kFollowsContacts) elements_ = Term::Elements(context);
    return Term::kFollowsContacts;
  }

  std::vector<std::vector<int>> Cliques() const override {
    std::vector<std::vector<int>> cliques;
    for (const Element& e : elements_) cliques.emplace_back(e.nodes.begin(), e.nodes.end());
    return cliques;
  }

  void Bind(const BlockPattern* pattern) override {
    pattern_ = pattern;
    blocks_.clear();
    for (const Element& e : elements_) {
      for (const int a : e.nodes) {
        for (const int b : e.nodes) blocks_.push_back(pattern->Find(a, b));
      }
    }
  }

  int memory_size() const override { return static_cast<int>(elements_.size()) * Term::kMemory; }

  [[gnu::flatten]] void AddForces(const BatchPoint& point, double* force,
                                  double* memory) const override {
    ElementInput<Term, double> in = MakeInput<double>(point);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LoadNodes(point, elements_[e], &in);
      LoadInputs(elements_[e], &in);
      ElementOutput<Term, double> out = EmptyOutput<double>(point, e);
      Term::template AddForce<double>(elements_[e], in, &out);
      for (int a = 0; a < kNodes; ++a) {
        for (int k = 0; k < 3; ++k) force[3 * elements_[e].nodes[a] + k] += out.force[a][k];
      }
      for (int m = 0; m < Term::kMemory; ++m) memory[e * Term::kMemory + m] = out.memory[m];
    }
  }

  std::optional<double> Energy(const BatchPoint& point) const override {
    if constexpr (kTermHasEnergy<Term>) {
      ElementInput<Term, double> in = MakeInput<double>(point);
      double energy = 0.0;
      for (const Element& element : elements_) {
        LoadNodes(point, element, &in);
        LoadInputs(element, &in);
        energy += Term::Energy(element, in);
      }
      return energy;
    } else {
      return std::nullopt;
    }
  }

  void AddJacobian(const BatchPoint& point, const JacobianWeights& weights,
                   BlockSparseMatrix* matrix) const override {
    if constexpr (kWritesJacobian<Term>) {
      AddWrittenJacobian(point, weights, matrix);
    } else {
      AddDualJacobian(point, weights, matrix);
    }
  }

  [[gnu::flatten]] void AddDerivatives(const BatchPoint& point, const BatchDirections& directions,
                                       double* force, double* memory) const override {
    if (!MovesForces(point, directions)) return;
    using T = Dual<kLanes>;
    ElementInput<Term, T> in = MakeInput<T>(point);
    for (std::size_t i = 0; i < Term::kParameters.size(); ++i)
      SetLanes(directions.parameter, i, &in.parameter[i]);
    SetLanes(directions.all_parameters, kArealDensity, &in.areal_density);
    for (std::size_t k = 0; k < 2; ++k)
      SetLanes(directions.all_parameters, kShrinkWarp + k, &in.shrinkage[k]);
    for (std::size_t i = 0; i < in.read.size(); ++i) {
      if (point.read[i] < 0) continue;
      SetLanes(directions.all_parameters, static_cast<std::size_t>(point.read[i]), &in.read[i]);
    }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LoadNodes(point, elements_[e], &in);
      LoadInputs(elements_[e], &in);
      LoadDirections(directions, elements_[e], &in);
      ElementOutput<Term, T> out = EmptyOutput<T>(point, e);
      for (std::size_t m = 0; m < Term::kMemory; ++m)
        SetLanes(directions.memory, e * Term::kMemory + m, &out.memory[m]);
      Term::template AddForce<T>(elements_[e], in, &out);
      for (int n = 0; n < kNodes; ++n) {
        for (int k = 0; k < 3; ++k) {
          double* row = force + kLanes * (3 * elements_[e].nodes[n] + k);
          for (int c = 0; c < kLanes; ++c) row[c] += out.force[n][k].derivative(c);
        }
      }
      for (std::size_t m = 0; m < Term::kMemory; ++m) {
        for (int c = 0; c < kLanes; ++c)
          memory[kLanes * (e * Term::kMemory + m) + c] = out.memory[m].derivative(c);
      }
    }
  }

 private:
  using Element = typename Term::Element;
  static constexpr int kNodes = Term::kNodes;
  static constexpr bool kRemembers = Term::kMemory > 0;

  struct RowSink {
    void operator()(int a, int b, int p, const JacobianRow& row) const {
      row.AddTo(matrix->block(index[a * kNodes + b]) + BlockSparseMatrix::kRow * p);
    }
    const int* index;
    BlockSparseMatrix* matrix;
  };

  [[gnu::flatten]] void AddWrittenJacobian(const BatchPoint& point, const JacobianWeights& weights,
                                           BlockSparseMatrix* matrix) const {
    ElementInput<Term, double> in = MakeInput<double>(point);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LoadNodes(point, elements_[e], &in);
      const RowSink sink = {&blocks_[e * kNodes * kNodes], matrix};
      Term::template AddJacobian<RowSink>(elements_[e], in, weights, sink);
    }
  }

  // By automatic differentiation.
  [[gnu::flatten]] void AddDualJacobian(const BatchPoint& point, const JacobianWeights& weights,
                                        BlockSparseMatrix* matrix) const {
    using T = Dual<WholeRegisters(3 * kNodes)>;
    ElementInput<Term, T> in = MakeInput<T>(point);
    for (int n = 0; n < kNodes; ++n) {  // these derivatives are the same for all elements
      for (int k = 0; k < 3; ++k) {
        in.x[n][k].SetDerivative(3 * n + k, weights.x);
        in.v[n][k].SetDerivative(3 * n + k, weights.v);
        if constexpr (Term::kUsesAcceleration) in.a[n][k].SetDerivative(3 * n + k, weights.a);
      }
    }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LoadNodes(point, elements_[e], &in);
      LoadInputs(elements_[e], &in);
      ElementOutput<Term, T> out = EmptyOutput<T>(point, e);
      Term::template AddForce<T>(elements_[e], in, &out);
      ScatterBlocks(out, e, matrix);
    }
  }

  template <class T>
  ElementInput<Term, T> MakeInput(const BatchPoint& point) const {
    ElementInput<Term, T> in;
    in.time = point.time;
    in.step = point.step;
    for (std::size_t i = 0; i < Term::kParameters.size(); ++i)
      in.parameter[i] = T(point.parameter[i]);
    in.areal_density = T(point.all_parameters[kArealDensity]);
    for (std::size_t k = 0; k < 2; ++k) in.shrinkage[k] = T(point.all_parameters[kShrinkWarp + k]);
    for (std::size_t i = 0; i < in.read.size(); ++i)
      in.read[i] = T(point.read[i] < 0 ? 0.0 : point.all_parameters[point.read[i]]);
    return in;
  }

  static void SetValue(double value, double* number) { *number = value; }
  template <int kSize>
  static void SetValue(double value, Dual<kSize>* number) {
    number->a = value;
  }
  static void SetLanes(const double* rows, std::size_t row, Dual<kLanes>* number) {
    for (int c = 0; c < kLanes; ++c) number->SetDerivative(c, rows[kLanes * row + c]);
  }

  // Sets the values and leaves the derivatives.
  template <class T>
  static void LoadNodes(const BatchPoint& point, const Element& e, ElementInput<Term, T>* in) {
    for (int n = 0; n < kNodes; ++n) {
      for (int k = 0; k < 3; ++k) {
        SetValue(point.x[3 * e.nodes[n] + k], &in->x[n][k]);
        SetValue(point.v[3 * e.nodes[n] + k], &in->v[n][k]);
        if constexpr (Term::kUsesAcceleration) SetValue(point.a[3 * e.nodes[n] + k], &in->a[n][k]);
        if constexpr (kRemembers) SetValue(point.start[3 * e.nodes[n] + k], &in->start[n][k]);
      }
    }
  }

  // Whether anything that the forces depend on moves along any direction.
  static bool MovesForces(const BatchPoint& point, const BatchDirections& directions) {
    const bool has_states =
        directions.x != nullptr || directions.v != nullptr || Term::kUsesAcceleration || kRemembers;
    if (has_states || (Term::kInputs > 0 && directions.input != nullptr)) return true;
    const auto moves = [](const double* rows, std::size_t row) {
      const double* first = rows + kLanes * row;
      return std::any_of(first, first + kLanes, [](double value) { return value != 0.0; });
    };
    const double* all = directions.all_parameters;
    for (std::size_t i = 0; i < Term::kParameters.size(); ++i)
      if (moves(directions.parameter, i)) return true;
    if (Term::kUsesDensity && moves(all, kArealDensity)) return true;
    for (std::size_t k = 0; k < 2; ++k)
      if (Term::kUsesShrinkage && moves(all, kShrinkWarp + k)) return true;
    for (std::size_t i = 0; i < Term::kReads.size(); ++i)
      if (point.read[i] >= 0 && moves(all, static_cast<std::size_t>(point.read[i]))) return true;
    return false;
  }

  static void LoadDirections(const BatchDirections& directions, const Element& e,
                             ElementInput<Term, Dual<kLanes>>* in) {
    for (int n = 0; n < kNodes; ++n) {
      for (int k = 0; k < 3; ++k) {
        const auto row = static_cast<std::size_t>(3 * e.nodes[n] + k);
        if (directions.x != nullptr) SetLanes(directions.x, row, &in->x[n][k]);
        if (directions.v != nullptr) SetLanes(directions.v, row, &in->v[n][k]);
        if constexpr (Term::kUsesAcceleration) SetLanes(directions.a, row, &in->a[n][k]);
        if constexpr (kRemembers) SetLanes(directions.start, row, &in->start[n][k]);
      }
    }
    if constexpr (Term::kInputs > 0) {
      if (directions.input == nullptr) return;
      for (int i = 0; i < Term::kInputs; ++i)
        SetLanes(directions.input, static_cast<std::size_t>(e.first_input + i), &in->input[i]);
    }
  }

  template <class T>
  static void LoadInputs(const Element& e, ElementInput<Term, T>* in) {
    if constexpr (Term::kInputs > 0) {
      for (int i = 0; i < Term::kInputs; ++i) in->input[i] = T(e.input[i]);
    }
  }

  template <class T>
  ElementOutput<Term, T> EmptyOutput(const BatchPoint& point, std::size_t e) const {
    ElementOutput<Term, T> out;
    for (Vector3<T>& f : out.force) f = Vector3<T>(T(0.0), T(0.0), T(0.0));
    for (int m = 0; m < Term::kMemory; ++m) out.memory[m] = T(point.memory[e * Term::kMemory + m]);
    return out;
  }

  template <class T>
  void ScatterBlocks(const ElementOutput<Term, T>& out, std::size_t e,
                     BlockSparseMatrix* matrix) const {
    const int* index = &blocks_[e * kNodes * kNodes];
    for (int a = 0; a < kNodes; ++a) {
      for (int p = 0; p < 3; ++p) {
        double row[T::kRegisters * T::kWidth];
        std::memcpy(row, out.force[a][p].v, sizeof(row));
        for (int b = 0; b < kNodes; ++b) {
          double* target = matrix->block(index[a * kNodes + b]) + BlockSparseMatrix::kRow * p;
          for (int q = 0; q < 3; ++q) target[q] += row[3 * b + q];
        }
      }
    }
  }

  TermInfo info_;
  std::vector<Element> elements_;
  std::vector<int> blocks_;  // kNodes^2 block indices an element
  const BlockPattern* pattern_ = nullptr;
};

template <class Term>
std::unique_ptr<ForceBatch> MakeForceBatch(const TermContext& context) {
  static_assert(Term::kInputs == 0 || Term::kMemory == 0,
                "an element that is made anew cannot remember");
  return std::make_unique<TermBatch<Term>>(context);
}

}  // namespace clothfit
