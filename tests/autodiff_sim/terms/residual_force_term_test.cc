// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The force that is given with each step's inputs: what it sums to, that without one nothing
// changes, and its derivatives over whole rollouts.
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/residual_force.h"
#include "tests/autodiff_sim/step/rollout.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

constexpr double kSide = 0.3;  // m

ForceGrid Grid(const Eigen::Vector3d& first, const Eigen::Vector3d& others) {
  ForceGrid grid{{0.0, 0.0}, {kSide, kSide}, {3, 2}, {}};
  grid.force.assign(6, others);
  grid.force.front() = first;
  return grid;
}

// The sum over all triangles of a cloth at x.
Eigen::Vector3d Total(const ClothMesh& mesh, const Eigen::VectorXd& x, const ForceGrid& grid) {
  StepInputs inputs;
  inputs.residual_force = grid;
  const ClothTopology topology = BuildTopology(mesh);
  const World world;
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const auto& element : ResidualForce::Elements({mesh, topology, world, &inputs})) {
    ElementInput<ResidualForce, double> in;
    in.parameter[0] = 1.0;
    for (int n = 0; n < 3; ++n) {
      in.x[n] = x.segment<3>(3 * element.nodes[n]);
      in.input[n] = element.input[n];
    }
    ElementOutput<ResidualForce, double> out;
    for (Vector3<double>& f : out.force) f.setZero();
    ResidualForce::AddForce<double>(element, in, &out);
    for (const Vector3<double>& f : out.force) total += f;
  }
  return total;
}

TEST(ResidualForce, EvenForceIsAreaTimesForceAlongTheSurface) {
  const ClothMesh mesh = MakeGrid({kSide, kSide}, {7, 6});
  const Eigen::Vector3d warp = Eigen::Vector3d(0.6, 0.0, 0.8), weft(0.0, -1.0, 0.0);
  const Eigen::VectorXd x = LayFlat(mesh, {1.0, 2.0, 3.0}, warp, weft);
  const Eigen::Vector3d force(0.5, -2.0, 3.0);  // normal, warp, weft
  const Eigen::Vector3d expected =
      kSide * kSide * (force[0] * warp.cross(weft) + force[1] * warp + force[2] * weft);
  EXPECT_LT((Total(mesh, x, Grid(force, force)) - expected).norm(), 1e-13);
}

// The hat of a corner node over two cells by one is a quarter of a cell: an eighth of the cloth.
TEST(ResidualForce, NodesShareTheCloth) {
  const ClothMesh mesh = MakeGrid({kSide, kSide}, {25, 25});
  const Eigen::VectorXd x =
      LayFlat(mesh, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  const Eigen::Vector3d total = Total(mesh, x, Grid({8.0, 0.0, 0.0}, Eigen::Vector3d::Zero()));
  // Sampled at the triangles' middles: products of hats are off by 1 / (9 * 12^2).
  EXPECT_NEAR(total.z(), kSide * kSide, 2e-3 * kSide * kSide);
}

TEST(ResidualForce, NoForceChangesNoNumber) {
  const TestScene scene = SwingingCloth(6, kSide);
  std::vector<RolloutResult> results;
  for (int variant = 0; variant < 3; ++variant) {
    Rollout rollout = MakeRollout(scene, {});
    rollout.steps = 40;
    if (variant > 0) Set("residual_force.share", 1.0, &rollout);
    if (variant == 2) {  // a force whose term is off
      Set("residual_force.share", 0.0, &rollout);
      const auto inputs = rollout.inputs;
      rollout.inputs = [inputs](double time) {
        StepInputs forced = inputs(time);
        forced.residual_force = Grid({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0});
        return forced;
      };
    }
    rollout.AddParameters({"bending.stiffness", "air_drag.normal"});
    results.push_back(RunRollout(rollout, Eigen::VectorXd::Zero(2), true));
    ASSERT_TRUE(results.back().converged);
  }
  for (int variant = 1; variant < 3; ++variant) {
    EXPECT_EQ(results[variant].values, results[0].values);
    EXPECT_EQ(results[variant].jacobian, results[0].jacobian);
  }
  EXPECT_GT(results[0].jacobian.lpNorm<Eigen::Infinity>(), 0.0);
}

// Moves one component of one node with a hat function of the time.
Direction MoveForce(int node, int component, double middle) {
  Direction direction;
  direction.name = "node " + std::to_string(node) + " component " + std::to_string(component);
  direction.typical = 0.5;
  direction.inputs = [=](double time, const StepInputs& inputs) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(inputs.num_rows());
    d[inputs.first_force_row() + 3 * node + component] =
        std::max(0.0, 1.0 - std::abs(time - middle) / 0.1);
    return d;
  };
  return direction;
}

TEST(ResidualForce, RolloutsAgreeWithDifferences) {
  for (const Integrator integrator : {Integrator::kBdf2, Integrator::kBackwardEuler}) {
    Rollout rollout = MakeRollout(SwingingCloth(5, kSide), Precise(integrator));
    Set("residual_force.share", 1.0, &rollout);
    const auto inputs = rollout.inputs;
    rollout.inputs = [inputs](double time) {
      StepInputs forced = inputs(time);
      forced.residual_force = Grid({1.0, 0.3, 0.0}, {-0.5, 0.0, 0.4 * time});
      return forced;
    };
    rollout.steps = 60;
    rollout.directions = {MoveForce(0, 0, 0.1), MoveForce(4, 0, 0.3), MoveForce(2, 1, 0.2),
                          MoveForce(5, 2, 0.25)};
    rollout.AddParameters({"residual_force.share", "bending.stiffness"});
    GradientCheckOptions options;
    options.tolerance = 1e-5;
    options.first_step = 5e-3;
    options.sufficient = 0.3;
    ExpectDerivatives(rollout, options);
  }
}

}  // namespace
}  // namespace clothfit
