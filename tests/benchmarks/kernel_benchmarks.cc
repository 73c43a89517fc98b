// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a step, on a square metre of n x n particles at rest on the ground.
#include <benchmark/benchmark.h>

#include "autodiff_sim/linear/gmres.h"
#include "autodiff_sim/linear/sparse_cholesky.h"
#include "autodiff_sim/linear/sparse_lu.h"
#include "autodiff_sim/step/simulation.h"
#include "tests/benchmarks/cholmod_reference.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

struct Parts {
  explicit Parts(int n)
      : scene(LiftedCloth(n, 1.0)),
        simulation(scene.mesh, scene.world, scene.handles),
        at_rest(simulation.MakeState(scene.x)),
        jacobian(&simulation.model().pattern()),
        factor(&simulation.model().pattern()) {
    Assemble();
    factor.Factorize(jacobian);
  }
  ForcePoint Point() const {  // at rest, v = a = 0
    return {0.0,
            1.0 / 120.0,
            at_rest.x,
            at_rest.v,
            at_rest.v,
            at_rest.x,
            simulation.parameters(),
            at_rest.memory};
  }
  void Assemble() { simulation.model().StepJacobian(Point(), 1.0 / 180.0, &jacobian); }

  TestScene scene;
  Simulation simulation;
  State at_rest;
  BlockSparseMatrix jacobian;
  SparseCholesky factor;
};

void Forces(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  Eigen::VectorXd force, memory;
  for (auto _ : state) {
    parts.simulation.model().Forces(parts.Point(), &force, &memory);
  }
}

void Jacobian(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  for (auto _ : state) parts.Assemble();
}

void CholmodFactor(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  CholmodReference reference(parts.simulation.model().pattern());
  for (auto _ : state) state.SetIterationTime(reference.Factorize(parts.jacobian));
}

void Factor(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  for (auto _ : state) parts.factor.Factorize(parts.jacobian);
}

void WholeFactor(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  SparseLu factor(parts.factor.supernodes());
  for (auto _ : state) factor.Factorize(parts.jacobian);
}

template <int kColumns>
void TriangularSolves(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  const FloatLanes<kColumns> b = FloatLanes<kColumns>::Ones(parts.scene.x.size(), kColumns);
  FloatLanes<kColumns> x;
  for (auto _ : state) parts.factor.Solve<kColumns>(b, &x);
}

template <int kColumns>
void Product(benchmark::State& state) {
  Parts parts(static_cast<int>(state.range(0)));
  FloatBlockMatrix rounded(&parts.simulation.model().pattern());
  rounded.Round(parts.jacobian);
  const FloatLanes<kColumns> x = FloatLanes<kColumns>::Ones(parts.scene.x.size(), kColumns);
  FloatLanes<kColumns> y;
  for (auto _ : state) rounded.Multiply<kColumns>(x, &y);
}

#define CLOTHFIT_KERNEL(...) BENCHMARK(__VA_ARGS__)->Arg(30)->Arg(60)->Unit(benchmark::kMicrosecond)

CLOTHFIT_KERNEL(Forces);
CLOTHFIT_KERNEL(Jacobian);
CLOTHFIT_KERNEL(CholmodFactor)->UseManualTime();
CLOTHFIT_KERNEL(Factor);
CLOTHFIT_KERNEL(WholeFactor);
CLOTHFIT_KERNEL(TriangularSolves<1>);
CLOTHFIT_KERNEL(TriangularSolves<kLanes>);
CLOTHFIT_KERNEL(Product<1>);
CLOTHFIT_KERNEL(Product<kLanes>);

}  // namespace
}  // namespace clothfit
