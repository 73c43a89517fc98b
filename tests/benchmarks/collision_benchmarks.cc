// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Collision detection of a cloth of n x (n - 3) particles with itself: with trees of k planes, and
// by all pairs (0 planes). Names end in n and the height of the folds in mm: flat, crumpled, and
// crumpled until it passes through itself. "found" counts the pairs.
#include <benchmark/benchmark.h>

#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/intersections.h"
#include "autodiff_sim/contact/proximity.h"
#include "tests/support/all_pairs.h"
#include "tests/support/crumpled_cloth.h"

namespace clothfit {
namespace {

struct Step {
  explicit Step(const benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const double height = 1e-3 * static_cast<double>(state.range(1));
    CrumpledCloth start = Crumple(1, height, n), end = Crumple(2, height, n);
    mesh = start.mesh;
    x0 = start.x;
    // 5 mm down, and where there are folds some centimetres towards other ones.
    x1 = start.x + 0.05 * (end.x - start.x);
    for (Eigen::Index i = 2; i < x1.size(); i += 3) x1[i] -= 0.005;
  }

  // m, a fifth of an edge: so that neighbours are not what is found.
  double distance() const { return 0.2 * (mesh.uv[1] - mesh.uv[0]).norm(); }

  ClothMesh mesh;
  Eigen::VectorXd x0, x1;
};

template <int kPlanes>
void Proximity(benchmark::State& state) {
  const Step step(state);
  CollisionSurface<kPlanes> surface(step.mesh);
  size_t found = 0;
  for (auto _ : state) found = FindProximity(step.x0, step.distance(), &surface).size();
  state.counters["found"] = static_cast<double>(found);
}

template <>
void Proximity<0>(benchmark::State& state) {
  const Step step(state);
  const MeshFeatures features = FindFeatures(step.mesh.triangles);
  const PlacedMesh mesh{features, step.x0};
  int found = 0;
  for (auto _ : state) {
    found = 0;
    VisitAllPairs(features, step.mesh.num_particles(), [&](const FeaturePair& pair) {
      const Contact contact = MeasureContact(pair, PairPoints(pair, mesh, mesh));
      if (contact.distance < step.distance()) ++found;
    });
  }
  state.counters["found"] = found;
}

template <int kPlanes>
void Continuous(benchmark::State& state) {
  const Step step(state);
  CollisionSurface<kPlanes> surface(step.mesh);
  size_t found = 0;
  for (auto _ : state) {
    found = FindContinuous(Motion{step.x0, step.x1}, Approach{}, &surface).size();
  }
  state.counters["found"] = static_cast<double>(found);
}

template <>
void Continuous<0>(benchmark::State& state) {
  const Step step(state);
  const MeshFeatures features = FindFeatures(step.mesh.triangles);
  const PlacedMesh start{features, step.x0}, end{features, step.x1};
  int found = 0;
  for (auto _ : state) {
    found = 0;
    VisitAllPairs(features, step.mesh.num_particles(), [&](const FeaturePair& pair) {
      const FourPoints x0 = PairPoints(pair, start, start), x1 = PairPoints(pair, end, end);
      if (FirstApproach(pair, x0, x1, Approach{})) ++found;
    });
  }
  state.counters["found"] = found;
}

// What every query with a tree begins with.
template <int kPlanes>
void Refit(benchmark::State& state) {
  const Step step(state);
  CollisionSurface<kPlanes> surface(step.mesh);
  for (auto _ : state) surface.Refit(step.x0, step.distance());
}

template <int kPlanes>
void Intersections(benchmark::State& state) {
  const Step step(state);
  CollisionSurface<kPlanes> surface(step.mesh);
  size_t found = 0;
  for (auto _ : state) found = FindIntersections(step.x0, &surface).size();
  state.counters["found"] = static_cast<double>(found);
}

void Trees(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{15, 30, 60, 100}, {0, 150, 1500}})->Unit(benchmark::kMillisecond);
}

// Once is enough for what takes seconds.
void AllPairs(benchmark::internal::Benchmark* benchmark) {
  Trees(benchmark);
  benchmark->Iterations(1);
}

#define CLOTHFIT_COLLISION(...) BENCHMARK(__VA_ARGS__)->Apply(Trees)

CLOTHFIT_COLLISION(Refit<14>);
CLOTHFIT_COLLISION(Proximity<6>);
CLOTHFIT_COLLISION(Proximity<14>);
CLOTHFIT_COLLISION(Proximity<18>);
CLOTHFIT_COLLISION(Proximity<26>);
CLOTHFIT_COLLISION(Continuous<6>);
CLOTHFIT_COLLISION(Continuous<14>);
CLOTHFIT_COLLISION(Continuous<18>);
CLOTHFIT_COLLISION(Continuous<26>);
CLOTHFIT_COLLISION(Intersections<6>);
CLOTHFIT_COLLISION(Intersections<14>);
CLOTHFIT_COLLISION(Intersections<18>);
CLOTHFIT_COLLISION(Intersections<26>);
BENCHMARK(Proximity<0>)->Apply(AllPairs);
BENCHMARK(Continuous<0>)->Apply(AllPairs);

}  // namespace
}  // namespace clothfit
