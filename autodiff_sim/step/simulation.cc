// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Steps, and the shorter ones that a failed step is tried as.
#include "autodiff_sim/step/simulation.h"

#include <cmath>
#include <string>
#include <utility>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/intersections.h"
#include "autodiff_sim/step/grips.h"
#include "autodiff_sim/step/step_solver.h"
#include "autodiff_sim/terms/added_terms.h"
#include "autodiff_sim/terms/terms.h"

namespace clothfit {

StepReport& StepReport::operator+=(const StepReport& other) {
  if (other.status != StepStatus::kConverged) status = other.status;
  newton_iterations += other.newton_iterations;
  linear_iterations += other.linear_iterations;
  sensitivity_iterations += other.sensitivity_iterations;
  jacobians += other.jacobians;
  factorizations += other.factorizations;
  halvings += other.halvings;
  contact_pairs = other.contact_pairs;
  obstacle_contacts = other.obstacle_contacts;
  most_contact_pairs =
      std::max({most_contact_pairs, other.most_contact_pairs, other.contact_pairs});
  most_obstacle_contacts =
      std::max({most_obstacle_contacts, other.most_obstacle_contacts, other.obstacle_contacts});
  limited_iterates += other.limited_iterates;
  pattern_rebuilds += other.pattern_rebuilds;
  blocked_steps += other.blocked_steps;
  intersections += other.intersections;
  handle_work += other.handle_work;
  error = std::max(error, other.error);
  return *this;
}

struct Simulation::Solver {
  Solver(ClothModel* model, const SimulationOptions& options)
      : solver(model, options), grips(*model), last_constraints({}) {}

  StepSolver solver;
  Grips grips;
  HandleConstraints last_constraints;
  Eigen::VectorXd
      clear_x;  // a place (3N, m) at which the cloth is known not to pass through itself
};

Simulation::Simulation(std::unique_ptr<ClothModel> model, const SimulationOptions& options)
    : model_(std::move(model)),
      options_(options),
      parameters_(InitialValues(model_->parameters())),
      solver_(std::make_unique<Solver>(model_.get(), options_)) {
  if (options_.self_contact) model_->EnableSelfContact();
}

Simulation::Simulation(ClothMesh mesh, const World& world, const std::vector<SurfacePoint>& handles,
                       const SimulationOptions& options)
    : Simulation(std::make_unique<ClothModel>(
                     std::move(mesh), world,
                     [](const TermContext& context) {
                       return WithAddedTerms(MakeForceBatches(Terms{}, context), context);
                     },
                     handles),
                 options) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

State Simulation::MakeState(const Eigen::VectorXd& x) const {
  State state;
  state.x = x;
  state.v = Eigen::VectorXd::Zero(x.size());
  state.memory = Eigen::VectorXd::Zero(model_->memory_size());
  state.previous_x = state.x;
  state.previous_v = state.v;
  return state;
}

void Simulation::SetParameters(const Eigen::VectorXd& values) {
  parameters_ = values;
  solver_->clear_x.resize(0);  // obstacles may stand elsewhere now
}

int Simulation::CountIntersections(const Eigen::VectorXd& x) const {
  CollisionSurface<> surface(model_->mesh());
  return static_cast<int>(FindIntersections(x, &surface).size());
}

int Simulation::CountObstacleIntersections(const Eigen::VectorXd& x, double time,
                                           std::vector<std::string>* names) const {
  const World& world = model_->world();
  ObstacleContacts obstacles(model_->mesh(), world.obstacles,
                             options_.self_contact ? world.ground_height : std::nullopt);
  obstacles.BeginStep(time, time,
                      model_->HasObstacles(parameters_) ? model_->ChangeOfObstacles(parameters_)
                                                        : ObstacleChange());
  return obstacles.CountIntersections(x, names);
}

std::vector<NamedEnergy> Simulation::Energies(const State& state) {
  if (model_->HasContact(parameters_)) {
    model_->BeginContactStep(state.time, state.time, parameters_);
    model_->FollowContacts(state.x, parameters_);
  }
  const Eigen::VectorXd no_acceleration = Eigen::VectorXd::Zero(state.x.size());
  return model_->Energies(
      {state.time, 0.0, state.x, state.v, no_acceleration, state.x, parameters_, state.memory});
}

void Simulation::Reset() { solver_->solver.ResetAll(); }

void Simulation::CheckStart(const State& state) const {
  if (model_->HasSelfContact(parameters_)) {
    // Layers thicker than the mesh is fine would be pushed apart by their own neighbours.
    const double thickness = model_->ContactThickness(parameters_);
    if (!(thickness > 0.0 && thickness <= model_->LargestThickness())) {
      throw InputError("contact.thickness",
                       std::to_string(thickness) + " m; expected at most " +
                           std::to_string(model_->LargestThickness()) +
                           " m, half of the smallest distance of parts of the flat mesh that have "
                           "no particle in common; lower it, or lower cloth.resolution");
    }
    if (const int edges = CountIntersections(state.x); edges > 0) {
      throw InputError("cloth.initial",
                       "the cloth passes through itself, at " + std::to_string(edges) +
                           " edges; expected a cloth that does not, or simulation.self_contact: "
                           "false");
    }
  }
  std::vector<std::string> names;
  if (!model_->HasObstacles(parameters_)) return;
  if (const int count = CountObstacleIntersections(state.x, state.time, &names); count > 0) {
    const std::string place = names[0] == "ground" ? "ground.height" : "obstacles: " + names[0];
    throw InputError(place, "the cloth is in it at frame 0, in " + std::to_string(count) +
                                " places; expected a cloth that begins outside: move "
                                "cloth.initial, or make the obstacle smaller");
  }
}

// A state may come from anywhere: what this simulation did not make is looked at.
bool Simulation::StartsClear(const State& state) {
  Eigen::VectorXd& clear_x = solver_->clear_x;
  if (clear_x.size() == state.x.size() && clear_x == state.x) return true;
  if (!model_->IsClear(state.x, state.time, parameters_)) return false;
  clear_x = state.x;
  return true;
}

namespace {

// The velocity after a step of h, by the polynomial through those that are known. Where there are
// three it is of second order.
Eigen::VectorXd ExtrapolatedVelocity(const State& state, double h) {
  const double h1 = state.previous_step, h2 = state.older_step, h12 = h1 + h2;
  if (h2 <= 0.0) return state.v + (h / h1) * (state.v - state.previous_v);
  return ((h + h1) * (h + h12) / (h1 * h12)) * state.v -
         (h * (h + h12) / (h1 * h2)) * state.previous_v +
         (h * (h + h1) / (h12 * h2)) * state.older_v;
}

}  // namespace

// One step of exactly h; the state is untouched unless it converges. A fresh one starts from the
// velocities as they are, not from extrapolated ones.
StepReport Simulation::TryStep(double h, bool fresh, const Drive& drive, State* state,
                               Sensitivity* sensitivity, const Eigen::VectorXd* known) {
  StepReport report;
  const bool with_directions = sensitivity != nullptr;
  StepInputs inputs = drive(state->time + h, with_directions);
  const Grips& grips = solver_->grips;
  const bool is_rigid = grips.AreRigid(parameters_);
  if (is_rigid) {
    grips.ApplySlip(*model_, parameters_, state->time + h,
                    with_directions ? &sensitivity->parameters() : nullptr, &inputs);
  }
  HandleConstraints constraints(is_rigid ? inputs.handles : std::vector<HandleTarget>());
  if (!constraints.SamePoints(solver_->last_constraints)) solver_->solver.Reset();
  solver_->last_constraints = constraints;
  model_->BeginStep(inputs);
  StepProblem problem;
  problem.end_time = state->time + h;
  problem.step = h;
  problem.start = state->x;
  problem.formula = MakeStepFormula(options_.integrator, h, state->previous_step);
  problem.x_hat = problem.formula.now * state->x + problem.formula.before * state->previous_x;
  problem.v_hat = problem.formula.now * state->v + problem.formula.before * state->previous_v;
  problem.memory = state->memory;
  problem.parameters = &parameters_;
  problem.constraints = &constraints;
  if (model_->HasContact(parameters_)) {
    const bool too_thick = model_->HasSelfContact(parameters_) &&
                           !(model_->ContactThickness(parameters_) <= model_->LargestThickness());
    if (too_thick || !StartsClear(*state)) {
      report.status = StepStatus::kDiverged;
      return report;
    }
    problem.keep_clear = true;
  }
  Eigen::VectorXd v = state->v;
  if (problem.formula.before != 0.0 && !fresh) v = ExtrapolatedVelocity(*state, h);
  if (known != nullptr) v = *known;
  StepSolver& solver = solver_->solver;
  if (known != nullptr && !problem.keep_clear) {
    solver.Take(problem, v);
  } else if (!solver.Solve(problem, &v, &report)) {
    report.status = StepStatus::kDiverged;
    return report;
  }
  if (is_rigid) {
    handle_forces_ = (solver.full_residual() - solver.reduced_residual()) / problem.formula.gamma;
    if (with_directions) grips.Yield(handle_forces_, sensitivity->parameters(), &inputs);
  } else {
    handle_forces_ = grips.Forces(*model_, parameters_, problem.end_time, inputs,
                                  problem.x_hat + problem.formula.gamma * v);
  }
  report.handle_work = h * handle_forces_.dot(v);
  if (sensitivity != nullptr && !solver.Differentiate(problem, inputs, v, sensitivity, &report)) {
    report.status = StepStatus::kSensitivityFailed;
  }
  state->previous_x = std::exchange(state->x, problem.x_hat + problem.formula.gamma * v);
  state->older_v = std::exchange(state->previous_v, std::exchange(state->v, v));
  state->older_step = state->previous_step;
  state->previous_step = h;
  state->memory = solver.memory();
  if (problem.keep_clear) solver_->clear_x = state->x;
  state->time += h;
  if (options_.check_intersections) {
    report.intersections =
        CountIntersections(state->x) + CountObstacleIntersections(state->x, state->time);
  }
  return report;
}

StepReport Simulation::Advance(double h, const Drive& drive, State* state, Sensitivity* sensitivity,
                               const Eigen::VectorXd* known) {
  StepReport total;
  if (sensitivity != nullptr && sensitivity->num_directions() == 0) sensitivity = nullptr;
  // The parts still to do, each as its number of halvings; a part that fails becomes two.
  std::vector<int> parts = {0};
  const double start = state->time;
  bool fresh = false;  // without a factor kept from an earlier step
  while (!parts.empty()) {
    const int halvings = parts.back();
    parts.pop_back();
    StepReport report = TryStep(std::ldexp(h, -halvings), fresh, drive, state, sensitivity,
                                halvings == 0 && !fresh ? known : nullptr);
    if (report.status == StepStatus::kDiverged && (!fresh || halvings < options_.max_halvings)) {
      // An old factor or a bold guess may have led astray: the same again without, then shorter.
      parts.insert(parts.end(), fresh ? 2 : 1, fresh ? halvings + 1 : halvings);
      report.halvings = fresh ? 1 : 0;
      solver_->solver.Reset();
      report.status = StepStatus::kConverged;
      report.error = 0.0;
      fresh = true;
    } else {
      fresh = false;
    }
    total += report;
    if (total.status != StepStatus::kConverged) return total;
  }
  state->time = start + h;  // not the sum of its parts, so that times do not drift
  return total;
}

}  // namespace clothfit
