// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/added_terms.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

struct Registry {
  std::vector<AddedTerm> terms;
  std::atomic<bool> is_closed = false;  // many threads make simulations
};

Registry& TheRegistry() {
  static Registry registry;
  return registry;
}

void CheckParameter(const std::string& name, const Parameter& p) {
  const auto fail = [&](const char* expected) { throw InputError(name, expected); };
  if (!(p.lower < p.upper)) fail("expected a lower bound below the upper one");
  const bool inside = p.initial >= p.lower && p.initial <= p.upper;
  if (!inside && p.initial != p.off) fail("expected an initial value within the bounds, or off");
  if (p.scale == Scale::kLog && !(p.lower > 0.0))
    fail("expected bounds above 0 of a parameter on a logarithmic scale");
  const double least_sigma = p.scale == Scale::kLog ? 1.0 : 0.0;
  if (!(p.prior_factor > least_sigma)) fail("expected a prior's factor above 1, or amount above 0");
}

class AddedBatch final : public ForceBatch {
 public:
  AddedBatch(const AddedTerm& term, const TermContext& context)
      : info_(term.info), elements_(term.elements(context)), n_(info_.nodes) {
    const int last = context.mesh.num_particles();
    const auto is_wrong = [last](int particle) { return particle < 0 || particle >= last; };
    const std::vector<int>& particles = elements_.particles;
    if (particles.size() % static_cast<std::size_t>(n_) != 0 ||
        std::any_of(particles.begin(), particles.end(), is_wrong))
      throw InputError("term " + info_.name, "its elements name particles that the cloth lacks");
  }

  const TermInfo& info() const override { return info_; }
  void BeginStep(const TermContext&) override {}
  bool FollowContacts(const TermContext&) override { return false; }
  int memory_size() const override { return 0; }
  std::optional<double> Energy(const BatchPoint&) const override { return std::nullopt; }

  std::vector<std::vector<int>> Cliques() const override {
    std::vector<std::vector<int>> cliques;
    for (std::size_t e = 0; e < size(); ++e) cliques.emplace_back(nodes(e), nodes(e) + n_);
    return cliques;
  }

  void Bind(const BlockPattern* pattern) override {
    blocks_.clear();
    for (std::size_t e = 0; e < size(); ++e) {
      for (int a = 0; a < n_; ++a)
        for (int b = 0; b < n_; ++b) blocks_.push_back(pattern->Find(nodes(e)[a], nodes(e)[b]));
    }
  }

  void AddForces(const BatchPoint& point, double* force, double*) const override {
    Work work(*this);
    for (std::size_t e = 0; e < size(); ++e) {
      Evaluate(e, point, false, &work);
      for (int i = 0; i < 3 * n_; ++i) force[Index(e, i)] += work.force[i];
    }
  }

  void AddJacobian(const BatchPoint& point, const JacobianWeights& weights,
                   BlockSparseMatrix* matrix) const override {
    Work work(*this);
    for (std::size_t e = 0; e < size(); ++e) {
      Evaluate(e, point, true, &work);
      for (int a = 0; a < n_; ++a) {
        for (int b = 0; b < n_; ++b) {
          double* const block = matrix->block(blocks_[(e * n_ + a) * n_ + b]);
          for (int p = 0; p < 3; ++p) {
            const double* const row = work.Row(3 * a + p);
            for (int q = 0; q < 3; ++q)
              block[BlockSparseMatrix::kRow * p + q] +=
                  weights.x * row[3 * b + q] + weights.v * row[3 * (n_ + b) + q];
          }
        }
      }
    }
  }

  void AddDerivatives(const BatchPoint& point, const BatchDirections& directions, double* force,
                      double*) const override {
    const std::size_t of_parameters = kLanes * info_.parameters.size();
    const bool moves_parameters =
        std::any_of(directions.parameter, directions.parameter + of_parameters,
                    [](double value) { return value != 0.0; });
    if (directions.x == nullptr && directions.v == nullptr && !moves_parameters) return;
    Work work(*this);
    std::vector<const double*> moves(work.columns);  // kLanes numbers a column; null: nothing
    for (std::size_t e = 0; e < size(); ++e) {
      Evaluate(e, point, true, &work);
      for (int i = 0; i < 3 * n_; ++i) {
        moves[i] = LanesOf(directions.x, Index(e, i));
        moves[3 * n_ + i] = LanesOf(directions.v, Index(e, i));
      }
      for (std::size_t k = 0; k < info_.parameters.size(); ++k)
        moves[6 * n_ + k] = LanesOf(directions.parameter, k);
      for (int i = 0; i < 3 * n_; ++i) {
        double* const row = force + kLanes * Index(e, i);
        for (std::size_t j = 0; j < work.columns; ++j) {
          if (moves[j] == nullptr) continue;
          for (int c = 0; c < kLanes; ++c) row[c] += work.Row(i)[j] * moves[j][c];
        }
      }
    }
  }

 private:
  // Of one element at a time.
  struct Work {
    explicit Work(const AddedBatch& batch)
        : columns(6 * batch.n_ + batch.info_.parameters.size()),
          x(3 * batch.n_),
          v(3 * batch.n_),
          force(3 * batch.n_),
          jacobian(3 * batch.n_ * columns) {}
    const double* Row(int i) const { return jacobian.data() + i * columns; }
    std::size_t columns;
    std::vector<double> x, v, force, jacobian;
  };

  std::size_t size() const { return elements_.particles.size() / n_; }
  const int* nodes(std::size_t e) const { return elements_.particles.data() + e * n_; }
  // Of the element's number i among all 3N.
  std::size_t Index(std::size_t e, int i) const {
    return 3 * static_cast<std::size_t>(nodes(e)[i / 3]) + i % 3;
  }
  static const double* LanesOf(const double* rows, std::size_t row) {
    return rows == nullptr ? nullptr : rows + kLanes * row;
  }

  void Evaluate(std::size_t e, const BatchPoint& point, bool with_jacobian, Work* work) const {
    for (int i = 0; i < 3 * n_; ++i) {
      work->x[i] = point.x[Index(e, i)];
      work->v[i] = point.v[Index(e, i)];
    }
    std::fill(work->force.begin(), work->force.end(), 0.0);
    elements_.evaluate(e, {point.time, point.step, work->x.data(), work->v.data(), point.parameter},
                       work->force.data(), with_jacobian ? work->jacobian.data() : nullptr);
  }

  TermInfo info_;
  AddedElements elements_;
  int n_;                    // particles an element
  std::vector<int> blocks_;  // n^2 block indices an element
};

}  // namespace

void AddTerm(AddedTerm term) {
  const std::string place = "term " + term.info.name;
  Registry& registry = TheRegistry();
  if (registry.is_closed)
    throw InputError(place, "is added too late; expected before anything else is asked for");
  if (term.info.nodes < 1) throw InputError(place, "expected elements of one particle or more");
  for (const Parameter& p : term.info.parameters) CheckParameter(term.info.name + "." + p.name, p);
  for (const AddedTerm& other : registry.terms)
    if (other.info.name == term.info.name) throw InputError(place, "is there already");
  registry.terms.push_back(std::move(term));
}

const std::vector<AddedTerm>& AddedTerms() {
  TheRegistry().is_closed = true;
  return TheRegistry().terms;
}

std::vector<std::unique_ptr<ForceBatch>> WithAddedTerms(
    std::vector<std::unique_ptr<ForceBatch>> batches, const TermContext& context) {
  for (const AddedTerm& term : AddedTerms())
    batches.push_back(std::make_unique<AddedBatch>(term, context));
  return batches;
}

}  // namespace clothfit
