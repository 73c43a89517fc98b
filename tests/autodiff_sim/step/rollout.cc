// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Running and differentiating rollouts.
#include "tests/autodiff_sim/step/rollout.h"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// Adds these numbers to the inputs, rows as in StepInputs::directions.
void Add(const Eigen::VectorXd& change, StepInputs* inputs) {
  int row = 0;
  const auto next = [&]() {
    row += 3;
    return change.segment<3>(row - 3);
  };
  for (HandleTarget& handle : inputs->handles) handle.position += next();
  for (PointTarget& point : inputs->points) point.position += next();
  for (RayTarget& ray : inputs->rays) {
    ray.direction += next();
    ray.moment += next();
  }
  for (Eigen::Vector3d& force : inputs->residual_force.force) force += next();
}

StepInputs InputsAt(const Rollout& rollout, const Eigen::VectorXd& q, double time,
                    bool with_directions) {
  const StepInputs given = rollout.inputs(time);
  StepInputs inputs = given;
  const auto count = static_cast<Eigen::Index>(rollout.directions.size());
  if (with_directions) inputs.directions.setZero(given.num_rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!rollout.directions[i].inputs) continue;
    const Eigen::VectorXd derivative = rollout.directions[i].inputs(time, given);
    Add(q[i] * derivative, &inputs);
    if (with_directions) inputs.directions.col(i) = derivative;
  }
  return inputs;
}

}  // namespace

void Rollout::AddParameter(const std::string& name) {
  const Simulation simulation = make();
  const std::vector<NamedParameter>& table = simulation.model().parameters();
  const int index = FindParameter(table, name);
  ASSERT_GE(index, 0) << name;
  const double value = std::abs(parameters[index]);
  Direction direction;
  direction.name = name;
  direction.typical = value > 0.0 ? value : table[index].parameter.prior_factor;
  direction.parameter = index;
  directions.push_back(direction);
}

void Rollout::AddParameters(const std::vector<std::string>& names) {
  for (const std::string& name : names) AddParameter(name);
}

SimulationOptions Precise(Integrator integrator) {
  SimulationOptions options;
  options.integrator = integrator;
  options.tolerance = 1e-12;
  return options;
}

void Set(const std::string& name, double value, Rollout* rollout) {
  const int index = FindParameter(rollout->make().model().parameters(), name);
  ASSERT_GE(index, 0) << name;
  rollout->parameters[index] = value;
}

Rollout MakeRollout(const TestScene& scene, const SimulationOptions& options) {
  Rollout rollout;
  rollout.make = [scene, options]() {
    Simulation simulation(scene.mesh, scene.world, scene.handles, options);
    UseSuppleCloth(&simulation);
    return simulation;
  };
  rollout.parameters = rollout.make().parameters();
  rollout.x = scene.x;
  rollout.v = Eigen::VectorXd::Zero(scene.x.size());
  const Drive drive = scene.MakeDrive();
  rollout.inputs = [drive](double time) { return drive(time, false); };
  return rollout;
}

RolloutResult RunRollout(const Rollout& rollout, const Eigen::VectorXd& q, bool with_jacobian) {
  Simulation simulation = rollout.make();
  const Eigen::Index size = rollout.x.size(), count = q.size();
  Eigen::VectorXd parameters = rollout.parameters, x = rollout.x, v = rollout.v;
  Eigen::MatrixXd parameter_directions = Eigen::MatrixXd::Zero(parameters.size(), count);
  Eigen::MatrixXd dx = Eigen::MatrixXd::Zero(size, count), dv = dx;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Direction& direction = rollout.directions[i];
    if (direction.parameter >= 0) {
      parameters[direction.parameter] += q[i];
      parameter_directions(direction.parameter, i) = 1.0;
    }
    if (direction.dx.size() > 0) dx.col(i) = direction.dx;
    if (direction.dv.size() > 0) dv.col(i) = direction.dv;
  }
  simulation.SetParameters(parameters);
  State state = simulation.MakeState(x + dx * q);
  state.v = v + dv * q;
  Sensitivity sensitivity(state, parameter_directions);
  sensitivity.SetInitial(dx, dv);
  const Drive drive = [&](double time, bool with_directions) {
    return InputsAt(rollout, q, time, with_directions);
  };
  RolloutResult result;
  result.values.resize(3 * size);
  result.jacobian.resize(with_jacobian ? 3 * size : 0, count);
  for (int step = 1; step <= rollout.steps; ++step) {
    const StepReport report =
        simulation.Advance(rollout.step, drive, &state, with_jacobian ? &sensitivity : nullptr);
    result.report += report;
    result.halvings.push_back(report.halvings);
    if (result.report.status != StepStatus::kConverged) return result;
    if (step == rollout.steps / 2) {
      result.values.head(size) = state.x;
      if (with_jacobian) result.jacobian.topRows(size) = sensitivity.x();
    }
  }
  result.values.segment(size, size) = state.x;
  result.values.tail(size) = state.v;
  if (with_jacobian) {
    result.jacobian.middleRows(size, size) = sensitivity.x();
    result.jacobian.bottomRows(size) = sensitivity.v();
  }
  result.converged = true;
  return result;
}

GradientCheckReport CheckRollout(const Rollout& rollout, const GradientCheckOptions& options) {
  const auto count = static_cast<Eigen::Index>(rollout.directions.size());
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(count);
  const RolloutResult base = RunRollout(rollout, zero, true);
  EXPECT_TRUE(base.converged);
  if (!base.converged) return {};
  GradientCheckOptions with_typical = options;
  with_typical.typical.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) with_typical.typical[i] = rollout.directions[i].typical;
  const auto function = [&](const Eigen::VectorXd& q, Eigen::VectorXd* f) {
    const RolloutResult moved = RunRollout(rollout, q, false);
    *f = moved.values;
    return moved.converged && moved.halvings == base.halvings;
  };
  return CheckGradient(function, zero, base.jacobian, with_typical);
}

void ExpectDerivatives(const Rollout& rollout, const GradientCheckOptions& options, int undecided) {
  ASSERT_FALSE(rollout.directions.empty());
  const GradientCheckReport report = CheckRollout(rollout, options);
  ASSERT_EQ(report.columns.size(), rollout.directions.size());
  for (std::size_t i = 0; i < report.columns.size(); ++i) {
    const ColumnCheck& column = report.columns[i];
    EXPECT_NE(column.verdict, GradientVerdict::kDisagrees)
        << rollout.directions[i].name << ": relative error " << column.relative_error
        << ", the difference's own " << column.difference_error << ", of " << column.magnitude;
    // A derivative that is zero would agree with anything that does nothing.
    EXPECT_GT(column.magnitude * rollout.directions[i].typical, 1e-9) << rollout.directions[i].name;
    if (column.verdict == GradientVerdict::kUndecided) {
      std::printf("undecided: %s, %.1e, the difference's own %.1e\n",
                  rollout.directions[i].name.c_str(), column.relative_error,
                  column.difference_error);
    }
  }
  EXPECT_LE(report.Count(GradientVerdict::kUndecided), undecided);
  std::printf("%zu directions, worst relative error %.1e, %d rollouts\n", report.columns.size(),
              report.WorstRelativeError(), report.evaluations);
}

}  // namespace clothfit
