// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The implementation of MakeForceBatch, for the translation units that instantiate a term
// (terms/*.cc, and tests that bring a term of their own).
#pragma once

#include <utility>

#include "autodiff_sim/force_batch.h"

namespace clothfit {

// Jets are padded to whole vector registers: a width that is no multiple of one is evaluated two
// numbers at a time.
constexpr int PaddedJetWidth(int width) { return width <= 4 ? 4 : (width + 7) / 8 * 8; }

// Where each input of an element has its derivative.
template <class Term>
struct JetLayout {
  static constexpr int kV = 0;
  static constexpr int kX = 3 * Term::kNodes;
  static constexpr int kParameter = 6 * Term::kNodes;
  static constexpr int kDensity = kParameter + static_cast<int>(Term::kParameters.size());
  static constexpr int kInput = kDensity + 1;
  static constexpr int kMemory = kInput + Term::kInputs;
  static constexpr int kSize = kMemory + Term::kMemory;
  static constexpr int kWidth = PaddedJetWidth(kSize);
};

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

  void AddForces(const BatchPoint& point, double* force, double* memory) const override {
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

  void AddStepJacobian(const BatchPoint& point, double gamma, BlockSparseMatrix* a) const override {
    using Jet = ceres::Jet<double, PaddedJetWidth(3 * kNodes)>;
    ElementInput<Term, Jet> in = MakeInput<Jet>(point);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LoadNodes(point, elements_[e], &in);
      LoadInputs(elements_[e], &in);
      for (int n = 0; n < kNodes; ++n) {
        for (int k = 0; k < 3; ++k) {
          in.x[n][k].v[3 * n + k] = gamma;
          in.v[n][k].v[3 * n + k] = 1.0;
        }
      }
      ElementOutput<Term, Jet> out = EmptyOutput<Jet>(point, e);
      Term::template AddForce<Jet>(elements_[e], in, &out);
      ScatterBlocks(out, e, 0, -gamma, a);
    }
  }

  void Linearize(const BatchPoint& point, double gamma, int first_parameter, int first_memory,
                 Linearization* result) const override {
    using Jet = ceres::Jet<double, Layout::kWidth>;
    ElementInput<Term, Jet> in = MakeInput<Jet>(point);
    for (std::size_t i = 0; i < Term::kParameters.size(); ++i)
      in.parameter[i].v[Layout::kParameter + i] = 1.0;
    in.areal_density.v[Layout::kDensity] = 1.0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      LoadNodes(point, elements_[e], &in);
      LoadInputs(elements_[e], &in);
      for (int n = 0; n < kNodes; ++n) {
        for (int k = 0; k < 3; ++k) {
          in.x[n][k].v[Layout::kX + 3 * n + k] = 1.0;
          in.v[n][k].v[Layout::kV + 3 * n + k] = 1.0;
        }
      }
      for (int i = 0; i < Term::kInputs; ++i) in.input[i].v[Layout::kInput + i] = 1.0;
      ElementOutput<Term, Jet> out = EmptyOutput<Jet>(point, e);
      for (int m = 0; m < Term::kMemory; ++m) out.memory[m].v[Layout::kMemory + m] = 1.0;
      Term::template AddForce<Jet>(elements_[e], in, &out);
      ScatterBlocks(out, e, Layout::kV, -gamma, result->step_jacobian);
      ScatterBlocks(out, e, Layout::kX, -gamma * gamma, result->step_jacobian);
      ScatterBlocks(out, e, Layout::kX, 1.0, result->stiffness);
      ScatterColumns(out, e, first_parameter, result);
      if constexpr (Term::kMemory > 0) StoreMemory(out, e, first_parameter, first_memory, result);
    }
  }

 private:
  using Element = typename Term::Element;
  using Layout = JetLayout<Term>;
  static constexpr int kNodes = Term::kNodes;

  template <class T>
  ElementInput<Term, T> MakeInput(const BatchPoint& point) const {
    ElementInput<Term, T> in;
    in.time = point.time;
    for (std::size_t i = 0; i < Term::kParameters.size(); ++i)
      in.parameter[i] = T(point.parameter[i]);
    in.areal_density = T(point.areal_density);
    return in;
  }

  template <class T>
  static void LoadNodes(const BatchPoint& point, const Element& e, ElementInput<Term, T>* in) {
    for (int n = 0; n < kNodes; ++n) {
      for (int k = 0; k < 3; ++k) {
        in->x[n][k] = T(point.x[3 * e.nodes[n] + k]);
        in->v[n][k] = T(point.v[3 * e.nodes[n] + k]);
      }
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

  template <class Jet>
  void ScatterBlocks(const ElementOutput<Term, Jet>& out, std::size_t e, int first_slot,
                     double scale, BlockSparseMatrix* matrix) const {
    const int* index = &blocks_[e * kNodes * kNodes];
    for (int a = 0; a < kNodes; ++a) {
      for (int b = 0; b < kNodes; ++b) {
        double* block = matrix->block(index[a * kNodes + b]);
        for (int p = 0; p < 3; ++p) {
          for (int q = 0; q < 3; ++q)
            block[3 * p + q] += scale * out.force[a][p].v[first_slot + 3 * b + q];
        }
      }
    }
  }

  template <class Jet>
  void ScatterColumns(const ElementOutput<Term, Jet>& out, std::size_t e, int first_parameter,
                      Linearization* result) const {
    for (int a = 0; a < kNodes; ++a) {
      const int node = elements_[e].nodes[a];
      for (int p = 0; p < 3; ++p) {
        const auto& derivative = out.force[a][p].v;
        for (std::size_t i = 0; i < Term::kParameters.size(); ++i) {
          result->by_parameter(3 * node + p, first_parameter + static_cast<int>(i)) +=
              derivative[Layout::kParameter + static_cast<int>(i)];
        }
        if constexpr (Term::kUsesDensity) {
          result->by_parameter(3 * node + p, 0) += derivative[Layout::kDensity];
        }
      }
      if constexpr (Term::kInputs > 0) {
        for (int i = 0; i < Term::kInputs; ++i) {
          result->by_input.push_back(
              {node,
               elements_[e].first_input + i,
               {out.force[a][0].v[Layout::kInput + i], out.force[a][1].v[Layout::kInput + i],
                out.force[a][2].v[Layout::kInput + i]}});
        }
      }
    }
  }

  template <class Jet>
  void StoreMemory(const ElementOutput<Term, Jet>& out, std::size_t e, int first_parameter,
                   int first_memory, Linearization* result) const {
    MemoryElement element;
    element.nodes.assign(elements_[e].nodes.begin(), elements_[e].nodes.end());
    element.first_parameter = first_parameter;
    element.first_memory = first_memory + static_cast<int>(e) * Term::kMemory;
    const int columns = Layout::kInput + Term::kMemory;  // inputs do not act through memory
    element.jacobian.resize(3 * kNodes + Term::kMemory, columns);
    for (int row = 0; row < element.jacobian.rows(); ++row) {
      const Jet& value =
          row < 3 * kNodes ? out.force[row / 3][row % 3] : out.memory[row - 3 * kNodes];
      for (int c = 0; c < columns; ++c) {
        element.jacobian(row, c) =
            value.v[c < Layout::kInput ? c : c - Layout::kInput + Layout::kMemory];
      }
    }
    result->with_memory.push_back(std::move(element));
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
